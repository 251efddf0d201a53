#include "model/PlanPicture.hh"

#include <cstdint>
#include <numeric>

#include "render/MeshBuffers.hh"

namespace whittle::viewer {

PlanPicture picture(const IndexedMesh& mesh, const CollapsePlan& plan) {
  std::vector<Eigen::Vector3d> place = mesh.points;
  std::vector<std::uint32_t> survivor(mesh.points.size());
  std::iota(survivor.begin(), survivor.end(), 0u);
  PlanPicture out;
  out.record = plan.record;
  for (const Collapse& collapse : plan.collapses) {
    place[collapse.to] = collapse.target;
    out.faces_gone += collapse.faces;
  }
  for (auto c = plan.collapses.rbegin(); c != plan.collapses.rend(); ++c)
    survivor[c->from] = survivor[c->to];  // backwards: the survivor's own end is known already
  out.vertices_gone = plan.collapses.size();

  std::vector<bool> is_target(mesh.points.size(), false);
  for (std::uint32_t v = 0; v < survivor.size(); ++v) {
    const std::uint32_t end = survivor[v];
    const bool vanishes = end != v;
    if (vanishes) is_target[end] = true;
    if (vanishes || place[v] != mesh.points[v]) out.merges.push_back({mesh.points[v], place[end], vanishes});
  }
  for (std::uint32_t v = 0; v < survivor.size(); ++v)
    if (is_target[v]) out.targets.push_back(place[v]);

  if (!mesh.points.empty()) out.origin = render::bounding_box(mesh).center();
  const auto seen = [&](const Eigen::Vector3d& point) -> Eigen::Vector3f {
    return (point - out.origin).cast<float>();
  };
  out.line_ends.reserve(2 * out.merges.size());
  for (const Merge& merge : out.merges) {
    out.line_ends.push_back(seen(merge.from));
    out.line_ends.push_back(seen(merge.to));
  }
  out.dots.reserve(out.targets.size());
  for (const Eigen::Vector3d& target : out.targets) out.dots.push_back(seen(target));
  return out;
}

}  // namespace whittle::viewer
