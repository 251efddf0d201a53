#include "recipe/passes.hh"

#include <algorithm>
#include <numeric>
#include <utility>

namespace whittle::recipe {
namespace {

void add(PlanRecord& sum, const PlanRecord& record) {
  sum.planned += record.planned;
  sum.refused_by_flip_guard += record.refused_by_flip_guard;
  sum.refused_by_link += record.refused_by_link;
  sum.fell_back += record.fell_back;
}

}  // namespace

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
  add(sum.record, pass.record);
}

Passes run_passes(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner& planner,
                  const Scale& scale, const Floor& floor, std::size_t max_passes) {
  Passes out;
  out.sum.mesh = mesh;
  out.sum.vertex_map.resize(mesh.points.size());
  std::iota(out.sum.vertex_map.begin(), out.sum.vertex_map.end(), 0u);
  out.sum.face_origin.resize(mesh.triangles.size());
  std::iota(out.sum.face_origin.begin(), out.sum.face_origin.end(), 0u);
  while (out.count < max_passes && !floor.reached(out.sum.mesh)) {
    Pass pass = driver == Driver::bulk ? bulk_pass(out.sum.mesh, planner, floor)
                                       : openmesh_pass(out.sum.mesh, driver, stage, planner, scale, floor);
    const std::size_t collapses = pass.collapses;
    append(out.sum, std::move(pass));
    ++out.count;
    if (collapses == 0) break;
  }
  return out;
}

double find_threshold(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner& planner,
                      const Scale& scale, const Floor& floor, std::size_t max_passes) {
  // All drivers execute the same plan, so the fastest one may search, unless constraints change what it does.
  const Driver searcher = stage.constraints.empty() ? Driver::bulk : driver;
  const auto reaches = [&](double threshold) {
    return floor.reached(
        run_passes(mesh, searcher, stage, with_threshold(planner, threshold), scale, floor, max_passes)
            .sum.mesh);
  };
  const auto [first, last] = threshold_range(planner, scale);
  double high = first;
  while (!reaches(high)) {
    if (high >= last) return last;
    high = std::min(2 * high, last);
  }
  double low = high == first ? 0 : high / 2;
  while (high - low > 0.002 * high) {
    const double middle = (low + high) / 2;
    (reaches(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace whittle::recipe
