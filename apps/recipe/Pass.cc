#include "recipe/Pass.hh"

#include <thread>
#include <utility>

#include "recipe/Stopwatch.hh"
#include "whittle/bulk.hh"
#include "whittle/plan/Stages.hh"
#include "whittle/plan/execute.hh"

namespace whittle::recipe {

std::size_t collapses_to_floor(const CollapsePlan& plan, const IndexedMesh& mesh, const Floor& floor) {
  std::size_t faces = mesh.triangles.size(), vertices = mesh.points.size(), n = 0;
  for (const Collapse& collapse : plan.collapses) {
    if (floor.reached(faces, vertices)) break;
    faces -= collapse.faces;
    --vertices;
    ++n;
  }
  return n;
}

namespace {

bool reaches_floor(const CollapsePlan& plan, const IndexedMesh& mesh, const Floor& floor) {
  std::size_t faces = mesh.triangles.size();
  for (const Collapse& collapse : plan.collapses) faces -= collapse.faces;
  return floor.reached(faces, mesh.points.size() - plan.collapses.size());
}

/// \return no passes, if a surface and more of them are needed.
template <typename P>
RepeatedPlan plan_without_surface(const P& planner, const IndexedMesh& mesh, const SurfaceExtras& extras,
                                  const Job& job, std::size_t max_passes, std::size_t n_threads) {
  if constexpr (detail::plans_without_surface<P, double>::value) {
    RepeatedPlan once{planner.plan(mesh, extras, n_threads), 1};
    if (max_passes == 1 || reaches_floor(once.plan, mesh, job.floor)) return once;
  }
  return {};
}

}  // namespace

Plan make_plan(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job, std::size_t max_passes) {
  if (job.go_on && !job.go_on(mesh.triangles.size())) throw Cancelled();
  Plan plan;
  Stopwatch watch;
  const std::size_t n_threads = std::thread::hardware_concurrency();
  const auto enough = [&](const auto& stages) {
    if (job.go_on && !job.go_on(stages.n_faces())) throw Cancelled();
    return job.floor.reached(stages.n_faces(), stages.n_vertices());
  };
  auto repeated = std::visit(
      [&](const auto& planner) {
        RepeatedPlan once = plan_without_surface(planner, mesh, extras, job, max_passes, n_threads);
        if (once.passes > 0) return once;
        return plan_passes(planner, SurfaceT<double>(mesh, extras, n_threads), max_passes, enough);
      },
      *job.planner);
  plan.collapses = std::move(repeated.plan);
  plan.passes = repeated.passes;
  plan.seconds = watch.lap();
  return plan;
}

Pass bulk_pass(const IndexedMesh& mesh, const CollapsePlan& plan, const Floor& floor) {
  Pass pass;
  Stopwatch watch;
  pass.collapses = collapses_to_floor(plan, mesh, floor);
  auto executed = execute(plan, mesh, pass.collapses);
  pass.execute_seconds = watch.lap();
  pass.mesh = std::move(executed.mesh);
  pass.vertex_map = std::move(executed.vertex_map);
  pass.face_origin = std::move(executed.face_origin);
  return pass;
}

}  // namespace whittle::recipe
