#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;
using namespace whittle::recipe;
using Catch::Matchers::Contains;

namespace {

constexpr measure::DistanceOptions kSampling{5000, 0};  // enough for small meshes

Recipe bounded(const std::string& spec, const std::string& bound, Target target = {}) {
  Recipe recipe;
  recipe.modules = {parse_spec(spec)};
  recipe.max_distance = parse_length(bound);
  recipe.target = target;
  recipe.samples = kSampling.samples;
  return recipe;
}

Target faces(std::size_t n) {
  Target target;
  target.faces = n;
  return target;
}

double farthest(const IndexedMesh& before, const Result& result) {
  return measure::distance(before, result.mesh, kSampling).two_sided.max;
}

std::string all_reasons(const Recipe& recipe, const Result& result) {
  std::string text;
  for (const std::string& reason : reasons(recipe, result)) text += reason + "\n";
  return text;
}

}  // namespace

TEST_CASE("the bound on the distance holds for every module, and what it reports is measured") {
  for (const IndexedMesh& mesh : {meshes::shaken(meshes::torus(24, 14), 0.01, 1)}) {
    const double bound = 0.01 * measure_scale(mesh).diagonal;
    for (const std::string spec : {"vt:passes=3", "ivdd:distance=3e,passes=4", "quadric:max-err=1e6",
                                   // without a threshold they go as far as the bound allows
                                   "ss", "mq"}) {
      INFO(spec);
      const Recipe recipe = bounded(spec, "1%");
      const Result result = run(mesh, recipe);
      REQUIRE(result.distance);
      CHECK(result.bound_held);
      CHECK(*result.distance <= bound);
      CHECK(farthest(mesh, result) == *result.distance);
      CHECK(result.mesh.triangles.size() < mesh.triangles.size());
      if (recipe.modules[0].parameters.empty() || spec == "vt:passes=3") {
        CHECK(result.stopped_by_bound);
      } else {  // the note is there exactly where something was changed
        Recipe free = recipe;
        free.max_distance.reset();
        CHECK(result.stopped_by_bound == (farthest(mesh, run(mesh, free)) > bound));
      }
    }
  }
}

TEST_CASE("a bound that nothing comes near changes nothing") {
  const IndexedMesh mesh = meshes::torus(48, 28);
  for (const std::string spec : {"ivdd:distance=0.9e", "fad", "ss:radius=0.8e"}) {
    Recipe free = bounded(spec, "50%");
    const Result with = run(mesh, free);
    free.max_distance.reset();
    CHECK(run(mesh, free).mesh.points == with.mesh.points);
    CHECK(with.held_by_bound == 0);
    CHECK_FALSE(with.stopped_by_bound);
  }
}

TEST_CASE("a bound of nothing leaves curved meshes as they are, and flat ones flat") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(24, 14), 0.01, 1);
  for (const std::string spec : {"vt", "mq"})
    CHECK(run(torus, bounded(spec, "0", faces(100))).mesh.points == torus.points);
  const IndexedMesh flat = meshes::flat_grid(20);
  const Result result = run(flat, bounded("ivdd:distance=1.2e", "1e-9"));
  CHECK(result.mesh.triangles.size() < flat.triangles.size());
}

TEST_CASE("where the bound forbids the target, the result says so") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  for (const std::string spec : {"mq", "ss"}) {
    const Recipe recipe = bounded(spec, "0.3%", faces(20));
    const Result result = run(mesh, recipe);
    INFO(spec);
    CHECK_FALSE(result.target_reached);
    CHECK(*result.distance <= 0.003 * measure_scale(mesh).diagonal);
    CHECK_THAT(all_reasons(recipe, result), Contains("the bound on the distance allows no more"));
  }
  const Recipe loose = bounded("mq", "20%", faces(1000));
  const Result result = run(mesh, loose);
  CHECK(result.target_reached);
  CHECK(result.mesh.triangles.size() <= 1000);
  CHECK(reasons(loose, result).empty());
}

TEST_CASE("mq goes on where the bound allows it when it is reached somewhere") {
  // A torus with spikes: the cheapest collapses first would stop at one of them.
  IndexedMesh mesh = meshes::shaken(meshes::torus(60, 36), 0.0005, 1);
  for (std::size_t v = 0; v < mesh.points.size(); v += 37) mesh.points[v] *= 1.02;
  const double bound = 0.01 * measure_scale(mesh).diagonal;
  const Result kept = run(mesh, bounded("mq", "1%"));
  CHECK(kept.bound_held);
  CHECK(farthest(mesh, kept) <= bound);
  CHECK(kept.stopped_by_bound);
  // As many faces by the order of the errors alone lie farther off.
  Recipe free;
  free.modules = {parse_spec("mq")};
  free.target = faces(kept.mesh.triangles.size());
  CHECK(farthest(mesh, run(mesh, free)) > bound);
}

TEST_CASE("a bound can be mq's own, and takes one pass") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  Recipe recipe;
  recipe.modules = {parse_spec("mq:max-distance=1%")};
  const Result alone = run(mesh, recipe);
  CHECK(alone.mesh.triangles.size() < mesh.triangles.size() / 2);
  CHECK(alone.stages[0].passes == 1);
  recipe.target = faces(4);
  CHECK_FALSE(run(mesh, recipe).target_reached);
  recipe.modules = {parse_spec("mq:max-distance=1%,passes=2")};
  CHECK_THROWS_WITH(run(mesh, recipe), Contains("max-distance") && Contains("one"));
}

TEST_CASE("a retriangulation that breaks the bound is dropped") {
  const IndexedMesh mesh = meshes::grid(12, [](auto i, auto) { return i == 6 ? 1.0 : 0.0; });
  Recipe recipe = bounded("fad:angle=1", "1e-6");
  recipe.delaunay = 180;
  const Result result = run(mesh, recipe);
  CHECK(*result.distance <= 1e-6);
  CHECK(farthest(mesh, result) <= 1e-6);
}

TEST_CASE("locks hold, and the reasons name them") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  Givens givens;
  givens.flags.assign(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); v += 2) givens.flags[v] = kLocked;
  for (const std::string spec : {"vt", "fad", "ivdd", "ss", "vtd", "fass", "mq", "quadric"}) {
    INFO(spec);
    Recipe recipe;
    recipe.modules = {parse_spec(spec)};
    recipe.target = faces(100);
    const Result result = run(mesh, recipe, {}, givens);
    CHECK_FALSE(result.target_reached);
    CHECK(result.held == mesh.points.size() / 2);
    CHECK_THAT(all_reasons(recipe, result), Contains(std::to_string(result.held) + " vertices are locked"));
    for (std::size_t v = 0; v < mesh.points.size(); v += 2)
      CHECK(result.mesh.points[result.vertex_map[v]] == mesh.points[v]);
  }
}

TEST_CASE("a length has one of three units") {
  const Scale scale{2, 50};
  CHECK(parse_length("0.5%").in(scale) == 0.25);
  CHECK(parse_length("0.5e").in(scale) == 1);
  CHECK(parse_length("0.5").in(scale) == 0.5);
  CHECK(parse_length("0.50%").text() == "0.5%");
  for (const std::string text : {"", "x", "1m", "-1", "nan", "1 e"})
    CHECK_THROWS_AS(parse_length(text), RecipeError);
}
