#include "model/PlanPicture.hh"

#include "catch.hh"
#include "meshes.hh"
#include "model/RecipeText.hh"
#include "recipe/Recipe.hh"

using namespace whittle;
using namespace whittle::viewer;

TEST_CASE("chained collapses end at the last target") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  CollapsePlan plan;
  plan.collapses = {{0, 1, 2, 0, {0.5, 0, 0}}, {1, 2, 2, 0, {1.5, 0, 0}}};
  const PlanPicture shown = picture(mesh, plan);
  CHECK(shown.vertices_gone == 2);
  CHECK(shown.faces_gone == 4);
  REQUIRE(shown.targets.size() == 1);
  CHECK(shown.targets[0].x() == 1.5);
  REQUIRE(shown.merges.size() == 3);  // two vanish, the survivor moves
  for (const Merge& merge : shown.merges) CHECK(merge.to.x() == 1.5);
  CHECK_FALSE(shown.merges[2].vanishes);
}

TEST_CASE("the plan foretells what the run does") {
  const IndexedMesh mesh = meshes::torus(40, 24);
  for (const char* text : {"ivdd:distance=1.1e", "fass:radius=0.9e", "vt", "fad:angle=20,passes=3",
                           "ss --ratio 0.5", "ivdd --faces 1000"}) {
    INFO(text);
    const recipe::Recipe recipe = parse_options(text);
    const PlanPicture shown = picture(mesh, recipe::plan(mesh, recipe));
    const recipe::Result result = recipe::run(mesh, recipe);
    CHECK(shown.vertices_gone > 0);
    CHECK(mesh.points.size() - shown.vertices_gone == result.mesh.points.size());
    CHECK(mesh.triangles.size() - shown.faces_gone == result.mesh.triangles.size());
  }
}

TEST_CASE("a stock module has no plan") {
  const IndexedMesh mesh = meshes::torus(12, 8);
  CHECK(recipe::plan(mesh, parse_options("quadric --ratio 0.5")).collapses.empty());
}

TEST_CASE("a monitor ends a run, whoever executes it") {
  const IndexedMesh mesh = meshes::torus(60, 40);
  for (const char* text :
       {"ivdd:distance=1.1e", "ivdd --ratio 0.5", "ivdd:distance=1.1e --driver sweep",
        "fad:angle=20 --driver decimater", "quadric --ratio 0.3", "quadric --ratio 0.3 --driver mc"}) {
    INFO(text);
    std::size_t asked = 0;
    const auto stop = [&](const recipe::Progress& now) {
      ++asked;
      CHECK(now.faces <= mesh.triangles.size());
      return false;
    };
    CHECK_THROWS_AS(recipe::run(mesh, parse_options(text), stop), recipe::Cancelled);
    CHECK(asked >= 1);
  }
}
