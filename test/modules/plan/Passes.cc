#include "catch.hh"
#include "meshes.hh"
#include "planners.hh"
#include "stages.hh"
#include "whittle/plan/Stages.hh"

using namespace whittle;
using meshes::IndexedMesh;
using Surface = SurfaceT<double>;
using Stages = StagesT<double>;
using planners::ivdd, planners::ss;
using stages::check_same, stages::kNever, stages::least_cosine, stages::some_extras, stages::some_mesh;

TEST_CASE("passes together turn no face further than one may, where passes on their own do") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.03, 3);
  VertexDistance planner = ivdd(0.5);
  planner.guard.min_cos = 0.7;

  ExecutedT<double> alone = execute(CollapsePlan(), mesh);
  for (int pass = 0; pass < 4; ++pass) {
    ExecutedT<double> next = execute(planner.plan(Surface(alone.mesh)), alone.mesh);
    for (std::uint32_t& f : next.face_origin) f = alone.face_origin[f];
    alone = std::move(next);
  }
  CHECK(least_cosine(alone, mesh) < 0.7);

  const CollapsePlan together = plan_passes(planner, Surface(mesh), 4, kNever).plan;
  REQUIRE(together.stages.size() > 1);
  CHECK(least_cosine(execute(together, mesh), mesh) > 0.7);
}

TEST_CASE("locked vertices and those of tolerance 0 stay through all passes") {
  const IndexedMesh mesh = some_mesh();
  const SurfaceExtras extras = some_extras(mesh);
  const CollapsePlan plan = plan_passes(ivdd(0.3), Surface(mesh, extras), 10, kNever).plan;
  REQUIRE(plan.stages.size() > 2);
  for (const Collapse& c : plan.collapses)
    for (const std::uint32_t v : {c.from, c.to}) {
      CHECK(extras.flags[v] == 0);
      CHECK(extras.tolerance[v] > 0);
    }
}

TEST_CASE("passes go on until nothing changes") {
  const IndexedMesh mesh = some_mesh();
  const Surface surface(mesh);
  const CollapsePlan plan = plan_passes(ss(0.2), surface, 1000, kNever).plan;
  REQUIRE(plan.stages.size() > 1);
  REQUIRE(plan.stages.size() < 1000);
  check_same(plan_passes(ss(0.2), surface, plan.stages.size() + 1, kNever).plan.collapses, plan.collapses);
  CHECK(plan_passes(ss(0.2), surface, plan.stages.size() - 1, kNever).plan.collapses.size() <
        plan.collapses.size());

  Stages stages(surface);
  for (std::size_t pass = 0; pass < plan.stages.size(); ++pass) CHECK(stages.add(ss(0.2)) > 0);
  CHECK(stages.add(ss(0.2)) == 0);
}

TEST_CASE("one pass is a plan of the planner, no pass is none") {
  const IndexedMesh mesh = some_mesh();
  const Surface surface(mesh);
  check_same(plan_passes(ivdd(0.2), surface, 1, kNever).plan.collapses, ivdd(0.2).plan(surface).collapses);
  CHECK(plan_passes(ivdd(0.2), surface, 0, kNever).plan.collapses.empty());
}

TEST_CASE("passes end where the caller's monitor says so") {
  const IndexedMesh mesh = some_mesh();
  const Surface surface(mesh);
  const CollapsePlan all = plan_passes(ivdd(0.3), surface, 1000, kNever).plan;
  REQUIRE(all.stages.size() > 2);
  std::size_t asked = 0;
  const CollapsePlan two =
      plan_passes(ivdd(0.3), surface, 1000, [&](const Stages&) { return ++asked == 2; }).plan;
  CHECK(asked == 2);
  CHECK(two.stages == std::vector<std::size_t>(all.stages.begin(), all.stages.begin() + 2));
  CHECK(two.collapses.size() == all.stages[2]);

  const std::size_t after_one = execute(all, mesh, all.stages[1]).mesh.triangles.size();
  const CollapsePlan one =
      plan_passes(ivdd(0.3), surface, 1000, [&](const Stages& s) { return s.n_faces() <= after_one; }).plan;
  CHECK(one.collapses.size() == all.stages[1]);
}
