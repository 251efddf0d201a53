/// \file
/// A recipe for each of several bodies.
#include <algorithm>

#include "catch.hh"
#include "meshes.hh"
#include "recipe/run_apart.hh"

using namespace whittle;

namespace {

/// Two plates, one of many faces and one of few, with texture coordinates at vertices of the one and at corners of the other.
struct TwoPlates {
  IndexedMesh mesh = meshes::flat_grid(21);
  attributes::Attribute texture;
  std::vector<std::uint32_t> body;

  TwoPlates() {
    const std::size_t first = mesh.points.size(), faces = mesh.triangles.size();
    const IndexedMesh small = meshes::flat_grid(11);
    for (const auto& p : small.points) mesh.points.push_back(p + Eigen::Vector3d(100, 0, 0));
    for (auto triangle : small.triangles) {
      for (std::uint32_t& v : triangle) v += static_cast<std::uint32_t>(first);
      mesh.triangles.push_back(triangle);
    }
    texture.kind = attributes::Kind::texture;
    texture.components = 2;
    for (const auto& p : mesh.points)
      texture.values.insert(texture.values.end(), {static_cast<float>(p.x()), static_cast<float>(p.y())});
    body.assign(mesh.triangles.size(), 1);
    std::fill_n(body.begin(), faces, 0);
  }
};

}  // namespace

TEST_CASE("run_apart: a target holds for each body, and each keeps its parts and attributes") {
  const TwoPlates in;
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec("mq")};
  recipe.target.ratio = 0.25;
  const attributes::Attributes attributes{in.texture};
  std::vector<std::uint32_t> parts = in.body;
  recipe::Givens givens;
  givens.attributes = &attributes;
  givens.parts = &parts;
  const recipe::Result result = recipe::run_apart(in.mesh, in.body, recipe, {}, givens);
  CHECK(result.target_reached);
  REQUIRE(result.parts.size() == result.mesh.triangles.size());
  const auto large = std::count(result.parts.begin(), result.parts.end(), 0u);
  const auto small = std::count(result.parts.begin(), result.parts.end(), 1u);
  CHECK(large == 200);
  CHECK(small == 50);
  CHECK(result.stages.size() == 2);
  REQUIRE(result.attributes.size() == 1);
  const attributes::Attribute& texture = result.attributes[0];
  for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = result.mesh.points[result.mesh.triangles[f][k]];
      CHECK((p.x() > 50) == (result.parts[f] == 1));
      CHECK(texture.value(texture.at(result.mesh, f, k))[0] == Approx(p.x()).margin(1e-4));
    }
  for (std::size_t v = 0; v < in.mesh.points.size(); ++v)
    CHECK((result.mesh.points[result.vertex_map[v]].x() > 50) == (in.mesh.points[v].x() > 50));
}
