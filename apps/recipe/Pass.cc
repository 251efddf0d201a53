#include "recipe/Pass.hh"

#include <utility>

#include "recipe/Stopwatch.hh"
#include "whittle/execute.hh"

namespace whittle::recipe {
namespace {

/// The shortest beginning of the plan that reaches the floor, or all of it.
std::size_t collapses_to_floor(const CollapsePlan& plan, const IndexedMesh& mesh, const Floor& floor) {
  std::size_t faces = mesh.triangles.size(), vertices = mesh.points.size(), n = 0;
  for (const Collapse& collapse : plan.collapses) {
    if ((floor.faces > 0 && faces <= floor.faces) || (floor.vertices > 0 && vertices <= floor.vertices))
      break;
    faces -= collapse.faces;
    --vertices;
    ++n;
  }
  return n;
}

}  // namespace

Pass bulk_pass(const IndexedMesh& mesh, const Planner& planner, const Floor& floor) {
  Pass pass;
  Stopwatch watch;
  const CollapsePlan plan =
      std::visit([&](const auto& p) { return p.plan(SurfaceT<double>(mesh)); }, planner);
  pass.plan_seconds = watch.lap();
  pass.collapses = collapses_to_floor(plan, mesh, floor);
  auto executed = execute(plan, mesh, pass.collapses);
  pass.execute_seconds = watch.lap();
  pass.mesh = std::move(executed.mesh);
  pass.vertex_map = std::move(executed.vertex_map);
  pass.face_origin = std::move(executed.face_origin);
  pass.record = plan.record;
  return pass;
}

}  // namespace whittle::recipe
