#include "recipe/passes.hh"

#include <algorithm>
#include <numeric>
#include <utility>

namespace whittle::recipe {
void append(Pass& sum, Pass&& pass) {
  sum.mesh = std::move(pass.mesh);
  for (std::uint32_t& v : sum.vertex_map) v = pass.vertex_map[v];
  std::vector<std::uint32_t> origin(pass.face_origin.size());
  for (std::size_t f = 0; f < origin.size(); ++f) origin[f] = sum.face_origin[pass.face_origin[f]];
  sum.face_origin = std::move(origin);
  sum.collapses += pass.collapses;
  sum.refused += pass.refused;
  sum.refused_faces += pass.refused_faces;
  sum.plan_seconds += pass.plan_seconds;
  sum.execute_seconds += pass.execute_seconds;
  sum.record += pass.record;
}

Passes no_passes(const IndexedMesh& mesh) {
  Passes out;
  out.sum.mesh = mesh;
  out.sum.vertex_map.resize(mesh.points.size());
  std::iota(out.sum.vertex_map.begin(), out.sum.vertex_map.end(), 0u);
  out.sum.face_origin.resize(mesh.triangles.size());
  std::iota(out.sum.face_origin.begin(), out.sum.face_origin.end(), 0u);
  return out;
}

Passes run_passes(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner* planner,
                  const Scale& scale, const Floor& floor, std::size_t max_passes, const GoOn& go_on) {
  Passes out = no_passes(mesh);
  const bool at_once = stage.constraints.empty();
  while (out.count < max_passes && !floor.reached(out.sum.mesh)) {
    const IndexedMesh& now = out.sum.mesh;
    Plan plan;
    if (planner) plan = make_plan(now, *planner, floor, at_once ? max_passes : 1, go_on);
    Pass pass =
        driver == Driver::bulk
            ? bulk_pass(now, plan.collapses, floor)
            : openmesh_pass(now, driver, stage, planner ? &plan.collapses : nullptr, scale, floor, go_on);
    pass.plan_seconds = plan.seconds;
    pass.record = plan.collapses.record;
    const std::size_t collapses = pass.collapses;
    append(out.sum, std::move(pass));
    out.count += planner ? plan.passes : 1;
    if (at_once || !planner || collapses == 0) break;
  }
  return out;
}

double find_threshold(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner& planner,
                      const Scale& scale, const Floor& floor, std::size_t max_passes, const GoOn& go_on) {
  // All drivers execute the same plan, so the fastest one may search, unless constraints change what it does.
  const Driver searcher = stage.constraints.empty() ? Driver::bulk : driver;
  const auto reaches = [&](double threshold) {
    const Planner attempt = with_threshold(planner, threshold);
    return floor.reached(
        run_passes(mesh, searcher, stage, &attempt, scale, floor, max_passes, go_on).sum.mesh);
  };
  const auto [first, last] = threshold_range(planner, scale);
  double high = first;
  while (!reaches(high)) {
    if (high >= last) return last;
    high = std::min(2 * high, last);
  }
  double low = high == first ? 0 : high / 2;
  while (high - low > 0.002 * high && high > first / 100) {  // below that, the passes get there by themselves
    const double middle = (low + high) / 2;
    (reaches(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace whittle::recipe
