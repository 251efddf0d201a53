#include "recipe/pieces.hh"

#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::recipe;
using Catch::Matchers::Contains;

namespace {

Recipe with_pieces(const std::string& module, const std::string& rule, double ratio) {
  Recipe recipe;
  recipe.modules = {parse_spec(module)};
  recipe.pieces = parse_pieces(rule);
  if (ratio > 0) recipe.target.ratio = ratio;
  return recipe;
}

std::string reasons_of(const Recipe& recipe, const Result& result) {
  std::string all;
  for (const std::string& reason : reasons(recipe, result)) all += reason + "; ";
  return all;
}

}  // namespace

TEST_CASE("by default all pieces stay, and the largest is not crushed for them") {
  const IndexedMesh mesh = meshes::dusty_torus(100);  // 2,688 + 800 faces
  for (const std::string module : {"mq", "quadric"}) {
    Recipe recipe = with_pieces(module, "keep", 0.05);
    const Result result = run(mesh, recipe);
    INFO(module);
    CHECK_FALSE(result.target_reached);
    CHECK(result.attainable.is_higher);
    CHECK(result.attainable.small == 100);
    CHECK(result.mesh.triangles.size() <= result.attainable.target.faces);
    CHECK(result.mesh.triangles.size() > result.attainable.target.faces - 8);
    CHECK(measure::facts(result.mesh).components == 101);
    CHECK(measure::facts(result.mesh).euler_characteristic == 200);
    CHECK_THAT(reasons_of(recipe, result), Contains("100 small pieces keep up to four faces each"));

    recipe.force = true;
    const Result forced = run(mesh, recipe);
    CHECK_FALSE(forced.attainable.is_higher);
    CHECK(forced.mesh.triangles.size() < result.mesh.triangles.size());
  }
}

TEST_CASE("a recipe without modules takes away the pieces below a length, and nothing else") {
  const IndexedMesh mesh = meshes::dusty_torus(100);
  Recipe recipe;
  recipe.pieces = parse_pieces("1%");
  Givens givens;
  attributes::Attributes tiles{{attributes::Kind::texture, "", 2, false, false, {}, {}}};
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {  // every face is a chart
    tiles[0].corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (std::uint32_t k = 0; k < 3; ++k)
      tiles[0].values.insert(tiles[0].values.end(), {static_cast<float>(f), static_cast<float>(k)});
  }
  givens.attributes = &tiles;
  const Result result = run(mesh, recipe, {}, givens);
  CHECK(result.stages.empty());
  CHECK(result.pieces_gone == 100);
  CHECK(result.held == 0);
  CHECK_FALSE(result.refit.has_value());
  REQUIRE(result.mesh.triangles.size() == 2688);
  for (std::size_t f = 0; f < 2688; ++f) {
    CHECK(result.face_origin[f] == f);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(result.mesh.points[result.mesh.triangles[f][k]] == mesh.points[mesh.triangles[f][k]]);
    for (std::size_t k = 0; k < 3; ++k) {
      const float* value = result.attributes[0].value(result.attributes[0].corners[f][k]);
      CHECK(value[0] == static_cast<float>(f));
      CHECK(value[1] == static_cast<float>(k));
    }
  }
  CHECK(plan(mesh, recipe).collapses.empty());
  recipe.max_distance = parse_length("1%");
  CHECK_THROWS_AS(run(mesh, recipe), RecipeError);
  recipe.max_distance.reset();
  recipe.target.ratio = 0.5;
  CHECK_THROWS_AS(run(mesh, recipe), RecipeError);
}

TEST_CASE("pieces vanish by error on the way to a target") {
  const IndexedMesh mesh = meshes::dusty_torus(100);
  for (const std::string module : {"mq", "quadric", "ivdd", "mq:passes=2"}) {
    INFO(module);
    const Result result = run(mesh, with_pieces(module, "by-error", 0.1));
    CHECK(result.target_reached);
    CHECK(result.pieces_gone == 100);
    CHECK(result.faces_of_pieces_gone == 800);
    CHECK(result.attainable.pieces == 1);
    CHECK(result.held == 0);
    CHECK(result.mesh.triangles.size() > 340);
    CHECK(result.face_origin.size() == result.mesh.triangles.size());
    CHECK(measure::facts(result.mesh).components == 1);
    CHECK(measure::facts(result.mesh).euler_characteristic == 0);
    REQUIRE(result.vertex_map.size() == mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      CHECK((result.vertex_map[v] < result.mesh.points.size()) == (v < 48 * 28));
    for (const std::uint32_t f : result.face_origin) CHECK(f < 2688);
  }
}

TEST_CASE("pieces below a length vanish, with a target or without") {
  const IndexedMesh mesh = meshes::together({meshes::placed(meshes::octahedron(), 1, {0, 0, 0}),
                                             meshes::placed(meshes::octahedron(), 0.1, {3, 0, 0}),
                                             meshes::placed(meshes::octahedron(), 0.01, {5, 0, 0})});
  const auto left = [&](const std::string& rule) {
    return run(mesh, with_pieces("fad:angle=1", rule, 0)).mesh.triangles.size();
  };
  CHECK(left("0.01") == 24);
  CHECK(left("0.05") == 16);  // the diagonals are 3.5, 0.35 and 0.035
  CHECK(left("0.4") == 8);
  CHECK(left("1000%") == 8);  // the largest stays
  const Result result = run(mesh, with_pieces("fad:angle=1", "0.4", 0));
  CHECK(result.mesh.points.size() == 6);
  for (std::size_t v = 0; v < 6; ++v) CHECK(result.mesh.points[result.vertex_map[v]] == mesh.points[v]);
}

TEST_CASE("a piece with a locked vertex stays, and so do the values of the others") {
  const IndexedMesh mesh =
      meshes::together({meshes::octahedron(), meshes::placed(meshes::octahedron(), 0.1, {3, 0, 0}),
                        meshes::placed(meshes::octahedron(), 0.1, {5, 0, 0})});
  attributes::Attribute number;
  number.name = "number";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) number.values.push_back(static_cast<float>(v));
  const attributes::Attributes attributes = {number};
  Givens givens;
  givens.attributes = &attributes;
  givens.flags.assign(mesh.points.size(), 0);
  givens.flags[12] = kLocked;
  const Result result = run(mesh, with_pieces("fad:angle=1", "1", 0), {}, givens);
  CHECK(result.pieces_gone == 1);
  CHECK(result.held == 1);
  CHECK(result.mesh.triangles.size() == 16);
  REQUIRE(result.attributes.size() == 1);
  CHECK(result.attributes[0].values == std::vector<float>{0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17});
  CHECK(result.vertex_map[6] == Result::kNoVertex);
  CHECK(result.vertex_map[12] == 6);
}

TEST_CASE("where locked vertices hold too much, the others keep their share of the target") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  Givens givens;
  givens.flags.assign(mesh.points.size(), 0);
  std::fill_n(givens.flags.begin(), 672, kLocked);
  Recipe recipe = with_pieces("mq", "keep", 0.1);
  const Result result = run(mesh, recipe, {}, givens);
  CHECK_FALSE(result.target_reached);
  CHECK(result.mesh.triangles.size() <= 1344 + 135);
  CHECK(result.mesh.triangles.size() > 1344 + 131);
  CHECK_THAT(reasons_of(recipe, result), Contains("672 vertices are locked"));
  recipe.force = true;
  CHECK(run(mesh, recipe, {}, givens).mesh.triangles.size() < 1344 + 60);
}

TEST_CASE("a rule for pieces is a word or a length") {
  CHECK(parse_pieces("keep").what == recipe::PieceRule::What::keep);
  CHECK(parse_pieces("by-error").what == recipe::PieceRule::What::by_error);
  CHECK(parse_pieces("1.5%").text() == "1.5%");
  CHECK(parse_pieces("keep").text() == "keep");
  CHECK(parse_pieces("by-error").text() == "by-error");
  for (const std::string text : {"", "all", "0", "-1", "by_error", "1x"})
    CHECK_THROWS_AS(parse_pieces(text), RecipeError);
  CHECK_THROWS_WITH(check(with_pieces("fad", "by-error", 0)), Contains("target"));
}
