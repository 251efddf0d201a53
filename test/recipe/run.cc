#include "catch.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"
#include "whittle/surface/errors.hh"

using namespace whittle;
using namespace whittle::recipe;
using Catch::Matchers::Contains;

namespace {

Recipe make(const std::vector<std::string>& modules, Driver driver = Driver::automatic, Target target = {}) {
  Recipe recipe;
  for (const std::string& text : modules) recipe.modules.push_back(parse_spec(text));
  recipe.driver = driver;
  recipe.target = target;
  return recipe;
}

Target ratio(double value) {
  Target target;
  target.ratio = value;
  return target;
}

IndexedMesh torus() {
  return meshes::shaken(meshes::torus(48, 28), 0.003, 1);
}

}  // namespace

TEST_CASE("all drivers of a planned module give the same surface") {
  const IndexedMesh mesh = torus();
  for (const std::string spec :
       {"vt", "fad:angle=40", "ivdd:distance=0.9e", "ss:radius=0.9e", "vtd:distance=1.1e",
        "fass:radius=0.9e,angle=30", "ss:radius=1e,passes=5", "fass:radius=0.8e,passes=3"}) {
    const Result bulk = run(mesh, make({spec}, Driver::bulk));
    CHECK(bulk.mesh.triangles.size() < mesh.triangles.size());
    CHECK(bulk.flipped_faces == 0);
    for (const Driver driver : {Driver::automatic, Driver::sweep, Driver::lazy, Driver::decimater}) {
      const Result other = run(mesh, make({spec}, driver));
      CHECK(meshes::canonical(other.mesh) == meshes::canonical(bulk.mesh));
      CHECK(other.vertex_map == bulk.vertex_map);
      CHECK(other.mesh.points == bulk.mesh.points);
      CHECK(other.stages[0].refused_by_decimater == 0);
    }
    // McDecimaterT draws at random and leaves a part of the plan; what it does is the plan all the same.
    const Result mc = run(mesh, make({spec}, Driver::mc));
    CHECK(mc.mesh.triangles.size() < mesh.triangles.size());
    CHECK(mc.mesh.triangles.size() >= bulk.mesh.triangles.size());
    CHECK(mc.stages[0].collapses + mc.stages[0].refused_by_decimater == bulk.stages[0].collapses);
    CHECK(meshes::canonical(run(mesh, make({spec}, Driver::mc)).mesh) == meshes::canonical(mc.mesh));
  }
}

TEST_CASE("the automatic driver is the fastest that can") {
  const IndexedMesh mesh = torus();
  CHECK(run(mesh, make({"fad"})).stages[0].driver == Driver::bulk);
  CHECK(run(mesh, make({"fad", "normal-flipping"})).stages[0].driver == Driver::sweep);
  CHECK(run(mesh, make({"quadric:max-err=1e-6"})).stages[0].driver == Driver::lazy);
}

TEST_CASE("stages run one after the other, constraints join the stage before them") {
  const IndexedMesh mesh = torus();
  const Result both = run(mesh, make({"fad:angle=30", "ivdd:distance=0.8e"}));
  REQUIRE(both.stages.size() == 2);
  CHECK(both.stages[0].faces_after == both.stages[1].faces_before);
  CHECK(both.stages[1].faces_after == both.mesh.triangles.size());
  const Result first = run(mesh, make({"fad:angle=30"}));
  CHECK(both.stages[0].faces_after == first.mesh.triangles.size());

  const Result held = run(mesh, make({"ivdd:distance=1.2e", "normal-flipping:angle=8"}));
  REQUIRE(held.stages.size() == 1);
  CHECK(held.stages[0].module == "ivdd:distance=1.2e + normal-flipping:angle=8");
  CHECK(held.stages[0].refused_by_decimater > 0);
  CHECK(held.mesh.triangles.size() > run(mesh, make({"ivdd:distance=1.2e"})).mesh.triangles.size());
}

TEST_CASE("every stock constraint runs with a planned and with a stock module") {
  const IndexedMesh mesh = torus();
  for (const std::string constraint :
       {"normal-flipping", "normal-deviation:angle=60", "aspect-ratio:ratio=20", "edge-length:length=3e",
        "hausdorff:tolerance=1%", "roundness:min=0.01", "independent-sets"}) {
    INFO(constraint);
    for (const Driver driver : {Driver::sweep, Driver::decimater})
      CHECK(run(mesh, make({"ivdd:distance=0.9e", constraint}, driver)).mesh.triangles.size() <
            mesh.triangles.size());
    for (const Driver driver : {Driver::lazy, Driver::decimater})
      CHECK(run(mesh, make({"quadric", constraint}, driver, ratio(0.9))).mesh.triangles.size() <
            mesh.triangles.size());
  }
}

TEST_CASE("a target without a threshold is met by search") {
  const IndexedMesh mesh = torus();
  const double faces = static_cast<double>(mesh.triangles.size());
  for (const std::string spec : {"vt", "fad", "ivdd", "ss", "vtd", "fass", "quadric"})
    for (const double part : {0.7, 0.5, 0.2}) {
      INFO(spec << " to " << part);
      const Result result = run(mesh, make({spec}, Driver::automatic, ratio(part)));
      CHECK(result.target_reached);
      CHECK(double(result.mesh.triangles.size()) <= part * faces);
      CHECK(double(result.mesh.triangles.size()) >= part * faces * 0.99);
      if (spec != "quadric" && spec != "vt") CHECK_THAT(result.stages[0].module, Contains(spec + ":"));
    }
  Target vertices;
  vertices.vertices = 700;
  CHECK(run(mesh, make({"ivdd"}, Driver::automatic, vertices)).mesh.points.size() == 700);
  Target count;
  count.faces = 1000;
  CHECK(run(mesh, make({"ivdd"}, Driver::sweep, count)).mesh.triangles.size() == 1000);
}

TEST_CASE("a target out of reach is said, and what was reached is there") {
  const IndexedMesh mesh = torus();
  const Result result = run(mesh, make({"ivdd:distance=0.7e"}, Driver::automatic, ratio(0.05)));
  CHECK_FALSE(result.target_reached);
  CHECK(result.mesh.triangles.size() < mesh.triangles.size());
  CHECK(result.stages[0].passes > 1);
  // Boundary vertices stay, so a grid has a least size.
  Target faces;
  faces.faces = 10;
  CHECK_FALSE(run(meshes::flat_grid(12), make({"fad"}, Driver::automatic, faces)).target_reached);
}

TEST_CASE("passes repeat a stage until nothing changes") {
  const IndexedMesh mesh = torus();
  const Result once = run(mesh, make({"ivdd:distance=0.9e"})),
               twice = run(mesh, make({"ivdd:distance=0.9e,passes=2"}));
  CHECK(twice.stages[0].passes == 2);
  CHECK(twice.mesh.triangles.size() < once.mesh.triangles.size());
  const Result rest = run(mesh, make({"ivdd:distance=0.9e,passes=1000"}));
  CHECK(rest.stages[0].passes < 100);
  CHECK(meshes::nonmanifold_edges(rest.mesh) == 0);
}

TEST_CASE("the vertex map leads every vertex to what it became") {
  const IndexedMesh mesh = torus();
  for (const auto& [modules, driver] : std::vector<std::pair<std::vector<std::string>, Driver>>{
           {{"fad:angle=30", "ivdd:distance=1e,passes=3"}, Driver::bulk},
           {{"quadric:max-err=1e-5"}, Driver::decimater}}) {
    const Result result = run(mesh, make(modules, driver));
    REQUIRE(result.vertex_map.size() == mesh.points.size());
    std::vector<bool> hit(result.mesh.points.size(), false);
    for (const std::uint32_t v : result.vertex_map) {
      REQUIRE(v < hit.size());
      hit[v] = true;
    }
    CHECK(std::find(hit.begin(), hit.end(), false) == hit.end());
    // Every face of the result is the image of an input face.
    std::set<std::set<std::uint32_t>> images;
    for (const auto& t : mesh.triangles)
      images.insert({result.vertex_map[t[0]], result.vertex_map[t[1]], result.vertex_map[t[2]]});
    for (const auto& t : result.mesh.triangles) CHECK(images.count({t[0], t[1], t[2]}) == 1);
  }
}

TEST_CASE("non-manifold faces are kept by bulk and counted by OpenMesh's drivers") {
  IndexedMesh mesh = torus();
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][1], 700});  // a third face on an edge
  mesh.triangles.push_back({5, 5, 6});
  const Result bulk = run(mesh, make({"ivdd:distance=0.8e"}, Driver::bulk));
  CHECK(bulk.refused_faces == 0);
  const Result sweep = run(mesh, make({"ivdd:distance=0.8e"}, Driver::sweep));
  CHECK(sweep.refused_faces == 2);
}

TEST_CASE("a collapse that a driver passes over on the way to the target is counted") {
  // Three faces around vertex 5. Vertex 3, the tip of an ear, is to go first; OpenMesh refuses that, goes on
  // to vertex 4, which turns a face, and has as few faces as asked for.
  IndexedMesh mesh;
  mesh.points = {{3, 0, 3}, {3, 0, 6}, {1, 3, 7}, {0, 0, 0}, {7, 7, 1}, {3, 0, 2}, {1, 4, 4}};
  mesh.triangles = {{5, 1, 6}, {4, 5, 3}, {1, 5, 4}, {6, 6, 5}, {5, 5, 5}, {6, 2, 2}, {6, 0, 0}};
  Recipe recipe = make({"fad:angle=170,lock=strict,pairs=all,boundary=merge,passes=3"}, Driver::decimater);
  recipe.target.faces = 2;
  const Result driven = run(mesh, recipe);
  CHECK(driven.refused_faces == 4);
  CHECK(driven.mesh.triangles.size() == 2);
  CHECK(driven.stages[0].collapses == 1);
  CHECK(driven.flipped_faces == 1);
  CHECK(driven.stages[0].refused_by_decimater == 1);
}

TEST_CASE("the Delaunay retriangulation comes last and moves no vertex") {
  const IndexedMesh mesh = torus();
  Recipe recipe = make({"fad:angle=30"});
  const Result before = run(mesh, recipe);
  CHECK(before.delaunay.flipped == 0);
  recipe.delaunay = 20;
  const Result after = run(mesh, recipe);
  CHECK(after.delaunay.flipped > 0);
  CHECK(after.delaunay.converged);
  CHECK(after.mesh.points == before.mesh.points);
  CHECK(after.mesh.triangles.size() == before.mesh.triangles.size());
  CHECK(meshes::nonmanifold_edges(after.mesh) == 0);
  recipe.delaunay = 181;
  CHECK_THROWS_WITH(check(recipe), Contains("between 0 and 180 degrees"));
}

TEST_CASE("a mesh without faces goes through unchanged") {
  IndexedMesh mesh;
  mesh.points.emplace_back(1, 2, 3);
  for (const Driver driver : {Driver::bulk, Driver::sweep, Driver::lazy, Driver::decimater, Driver::mc}) {
    const Result result = run(mesh, make({"ivdd:distance=1"}, driver));
    CHECK(result.mesh.points.size() == 1);
    CHECK(result.target_reached);
  }
}

TEST_CASE("mq weighs attributes that the mesh has, as the first module") {
  const IndexedMesh mesh = torus();
  attributes::Attributes attributes(1);
  attributes[0].kind = attributes::Kind::colour;
  attributes[0].components = 3;
  for (const auto& p : mesh.points)
    for (const float value : {p.x() > 0 ? 1.0f : 0.0f, 0.5f, 0.5f}) attributes[0].values.push_back(value);
  Givens givens;
  givens.attributes = &attributes;
  const Recipe plain = make({"mq"}, Driver::automatic, ratio(0.1)),
               weighed = make({"mq:colours=10%"}, Driver::automatic, ratio(0.1));
  const Result blind = run(mesh, plain, {}, givens), seeing = run(mesh, weighed, {}, givens);
  // A face across the step has both colours: fewer of the result's faces lie there, if colours count.
  const auto across = [](const Result& result) {
    double area = 0;
    for (const auto& t : result.mesh.triangles) {
      float low = 1, high = 0;
      for (const std::uint32_t v : t) {
        low = std::min(low, *result.attributes[0].value(v));
        high = std::max(high, *result.attributes[0].value(v));
      }
      const auto& p = result.mesh.points;
      if (high - low > 0.1f) area += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
    }
    return area;
  };
  CHECK(seeing.target_reached);
  CHECK(across(seeing) < 0.7 * across(blind));

  CHECK_THROWS_WITH(run(mesh, make({"mq:normals=1%"}, Driver::automatic, ratio(0.1)), {}, givens),
                    Contains("no normals"));
  CHECK_THROWS_WITH(check(make({"vt", "mq:colours=1%"}, Driver::automatic, ratio(0.1))),
                    Contains("first module"));
  // Also where it says the same as the first.
  CHECK_THROWS_WITH(check(make({"mq:colours=1%", "mq:colours=1%"}, Driver::automatic, ratio(0.1))),
                    Contains("first module"));
}

TEST_CASE("every module comes within 1 % of its target") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(80, 48), 0.001, 2);
  for (const char* spec : {"mq", "fad", "ivdd", "ss", "vtd", "fass", "vt", "quadric"})
    for (const double share : {0.7, 0.4, 0.15}) {
      INFO(spec << " to " << share);
      const Result result = run(mesh, make({spec}, Driver::automatic, ratio(share)));
      const double reached = double(result.mesh.triangles.size()) / double(mesh.triangles.size());
      CHECK(result.target_reached);
      CHECK(reached <= share);
      CHECK(reached > share - 0.01);
    }
}

TEST_CASE("recipes that cannot run are refused before any work") {
  const auto refused = [](const Recipe& recipe, const std::string& culprit) {
    CHECK_THROWS_AS(check(recipe), RecipeError);
    CHECK_THROWS_WITH(run(IndexedMesh(), recipe), Contains(culprit));
  };
  refused(make({}), "no module given");
  refused(make({"normal-flipping", "fad"}), "'normal-flipping' only constrains");
  refused(make({"ivdd"}), "'ivdd' needs distance=");
  refused(make({"quadric"}), "'quadric' needs max-err=");
  refused(make({"quadric:max-err=1"}, Driver::bulk), "driver 'bulk' cannot run module 'quadric'");
  refused(make({"quadric:max-err=1"}, Driver::sweep), "driver 'sweep' cannot run module 'quadric'");
  refused(make({"fad", "hausdorff"}, Driver::bulk), "driver 'bulk' cannot run module 'hausdorff'");
  refused(make({"fad"}, Driver::bulk, ratio(0)), "ratio");
  refused(make({"fad"}, Driver::bulk, ratio(1.01)), "ratio");
  refused(make({"fad"}, Driver::bulk, ratio(std::nan(""))), "ratio");
  CHECK_THROWS_WITH(parse_driver("fast"), Contains("unknown driver 'fast'; there are auto, bulk"));
  CHECK(parse_driver("sweep") == Driver::sweep);
  CHECK(to_string(Driver::mc) == "mc");
}

TEST_CASE("recipe: the mean edge counts each edge once, on the boundary as inside") {
  IndexedMesh mesh;  // a square with a diagonal: four edges of one face, one of two
  mesh.points = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(measure_scale(mesh).mean_edge == (3 + 4 + 3 + 4 + 5) / 5.0);
  CHECK(measure_scale(mesh).diagonal == 5);
  mesh.triangles.push_back({1, 1, 2});  // has no edges
  CHECK(measure_scale(mesh).mean_edge == 19 / 5.0);
  mesh.triangles.push_back({0, 1, 4});
  CHECK_THROWS_AS(measure_scale(mesh), InvalidMesh);
  CHECK(measure_scale(IndexedMesh()).mean_edge == 0);
}

TEST_CASE(
    "recipe: what mq makes is refitted unless told otherwise or bounded, what others make where asked for") {
  const auto make = [](const std::vector<std::string>& modules) {
    Recipe recipe;
    for (const std::string& text : modules) recipe.modules.push_back(parse_spec(text));
    recipe.target.ratio = 0.5;
    return recipe;
  };
  CHECK(wants_refit(make({"mq"})));
  CHECK(wants_refit(make({"ivdd:distance=0.2e", "mq"})));
  CHECK_FALSE(wants_refit(make({"mq", "ivdd:distance=0.2e"})));
  CHECK_FALSE(wants_refit(make({"mq:max-distance=1%"})));
  CHECK_FALSE(wants_refit(make({"quadric"})));
  Recipe recipe = make({"mq"});
  recipe.max_distance = parse_length("1%");
  CHECK_FALSE(wants_refit(recipe));
  recipe.refit = true;
  CHECK(wants_refit(recipe));
  recipe = make({"mq"});
  recipe.refit = false;
  CHECK_FALSE(wants_refit(recipe));
  recipe = make({"mq:max-distance=1%"});
  recipe.refit = true;
  CHECK_THROWS_AS(check(recipe), RecipeError);
}
