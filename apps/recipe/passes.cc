#include "recipe/passes.hh"

#include <algorithm>
#include <cmath>
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

SurfaceExtras carried(const SurfaceExtras& extras, const Pass& pass) {
  SurfaceExtras out;
  const std::size_t n = pass.mesh.points.size();
  if (!extras.flags.empty()) out.flags.resize(n, 0);
  if (!extras.tolerance.empty()) out.tolerance.resize(n, HUGE_VALF);
  for (std::size_t v = 0; v < pass.vertex_map.size(); ++v) {
    const std::uint32_t w = pass.vertex_map[v];
    if (!extras.flags.empty()) out.flags[w] |= extras.flags[v];
    if (!extras.tolerance.empty()) out.tolerance[w] = std::min(out.tolerance[w], extras.tolerance[v]);
  }
  return out;
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

Passes run_passes(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job) {
  Passes out = no_passes(mesh);
  SurfaceExtras known = extras;
  const bool at_once = job.stage.constraints.empty();
  while (out.count < job.max_passes && !job.floor.reached(out.sum.mesh)) {
    const IndexedMesh& now = out.sum.mesh;
    Plan plan;
    if (job.planner) plan = make_plan(now, known, job, at_once ? job.max_passes : 1);
    Pass pass = job.driver == Driver::bulk
                    ? bulk_pass(now, plan.collapses, job.floor)
                    : openmesh_pass(now, known, job, job.planner ? &plan.collapses : nullptr);
    pass.plan_seconds = plan.seconds;
    pass.record = plan.collapses.record;
    const std::size_t collapses = pass.collapses;
    known = carried(known, pass);
    append(out.sum, std::move(pass));
    out.count += job.planner ? plan.passes : 1;
    if (at_once || !job.planner || collapses == 0) break;
  }
  return out;
}

double find_threshold(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job) {
  Job attempt = job;
  // All drivers execute the same plan, so the fastest one may search, unless constraints change what it does.
  if (job.stage.constraints.empty()) attempt.driver = Driver::bulk;
  const auto reaches = [&](double threshold) {
    const Planner planner = with_threshold(*job.planner, threshold);
    attempt.planner = &planner;
    return job.floor.reached(run_passes(mesh, extras, attempt).sum.mesh);
  };
  const auto [first, last] = threshold_range(*job.planner, job.scale);
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
