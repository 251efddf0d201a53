#include "model/PlanPicture.hh"

#include <cstdint>
#include <numeric>

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
  return out;
}

}  // namespace whittle::viewer
