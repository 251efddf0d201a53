#include "attributes/transfer.hh"

#include <map>
#include <set>

#include "catch.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"
#include "whittle/surface/seams.hh"

using namespace whittle;
using namespace whittle::attributes;

namespace {

recipe::Recipe recipe_of(const std::string& spec) {
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(spec)};
  return recipe;
}

/// A vertex attribute whose values are the coordinates.
Attribute coordinates(const IndexedMesh& mesh) {
  Attribute out{Kind::colour, "", 3, false, false, {}, {}};
  for (const auto& p : mesh.points)
    for (int i = 0; i < 3; ++i) out.values.push_back(static_cast<float>(p[i]));
  return out;
}

/// Texture coordinates that are (x, y) left of the line x = at, and (x + 10, y) right of it.
Attribute torn(const IndexedMesh& mesh, double at) {
  Attribute out{Kind::texture, "", 2, false, false, {}, {}};
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
  for (const auto& t : mesh.triangles) {
    const double middle = (mesh.points[t[0]].x() + mesh.points[t[1]].x() + mesh.points[t[2]].x()) / 3;
    auto& corners = out.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] =
          known.emplace(std::pair(t[k], middle > at), static_cast<std::uint32_t>(known.size()));
      corners[k] = found->second;
      if (!is_new) continue;
      out.values.push_back(static_cast<float>(mesh.points[t[k]].x() + (middle > at ? 10 : 0)));
      out.values.push_back(static_cast<float>(mesh.points[t[k]].y()));
    }
  }
  return out;
}

}  // namespace

TEST_CASE("a linear attribute of a flat mesh stays linear") {
  const IndexedMesh mesh = meshes::flat_grid(20);
  const Attributes given{coordinates(mesh)};
  for (const std::string spec : {"vt", "ivdd:distance=1.2e", "ss:radius=1.1e", "fad", "vtd:distance=1.2e"}) {
    const auto result = recipe::run(mesh, recipe_of(spec), {}, {{}, {}, &given});
    INFO(spec);
    REQUIRE(result.mesh.points.size() < mesh.points.size());
    REQUIRE(result.attributes.size() == 1);
    const Attribute& out = result.attributes[0];
    REQUIRE(out.n_values() == result.mesh.points.size());
    for (std::size_t v = 0; v < result.mesh.points.size(); ++v)
      for (int i = 0; i < 3; ++i) CHECK(out.value(v)[i] == Approx(result.mesh.points[v][i]).margin(1e-5));
  }
}

TEST_CASE("normals keep their length, and a vertex that stays keeps its values bit for bit") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  Attribute normals{Kind::normal, "", 3, false, false, {}, {}};
  for (const auto& p : mesh.points) {
    const Eigen::Vector3d n = p.normalized();
    for (int i = 0; i < 3; ++i) normals.values.push_back(static_cast<float>(n[i]));
  }
  const Attributes given{normals};
  const auto result = recipe::run(mesh, recipe_of("ss:radius=0.7e"), {}, {{}, {}, &given});
  std::map<std::uint32_t, std::set<std::uint32_t>> members;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) members[result.vertex_map[v]].insert(v);
  std::size_t kept = 0;
  for (std::uint32_t w = 0; w < result.mesh.points.size(); ++w) {
    const float* n = result.attributes[0].value(w);
    CHECK(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] == Approx(1).epsilon(1e-5));
    if (members[w].size() > 1) continue;
    ++kept;
    for (int i = 0; i < 3; ++i) CHECK(n[i] == normals.value(*members[w].begin())[i]);
  }
  CHECK(kept > 100);
}

TEST_CASE("a seam stays where it is, and each side keeps its own coordinates") {
  const IndexedMesh mesh = meshes::flat_grid(20);
  const double at = mesh.points[10].x();
  const Attributes given{torn(mesh, at)};
  const auto seams = on_seams(mesh.triangles, seam_wedges(given), mesh.points.size());
  std::size_t on_seam = 0;
  for (std::size_t v = 0; v < seams.size(); ++v) {
    CHECK(seams[v] == (mesh.points[v].x() == at));
    on_seam += seams[v];
  }
  CHECK(on_seam == 20);
  for (const bool retriangulate : {false, true}) {
    recipe::Recipe recipe = recipe_of("ss:radius=1.2e,passes=3");
    if (retriangulate) recipe.delaunay = 180;
    const auto result = recipe::run(mesh, recipe, {}, {{}, {}, &given});
    CHECK(result.held == 20);
    REQUIRE(double(result.mesh.triangles.size()) < 0.55 * double(mesh.triangles.size()));
    const Attribute& out = result.attributes[0];
    REQUIRE(out.corners.size() == result.mesh.triangles.size());
    for (std::size_t f = 0; f < out.corners.size(); ++f) {
      const auto& t = result.mesh.triangles[f];
      double middle = 0;
      for (const auto v : t) middle += result.mesh.points[v].x() / 3;
      for (std::size_t k = 0; k < 3; ++k) {
        const float* uv = out.value(out.corners[f][k]);
        CHECK(uv[0] == Approx(result.mesh.points[t[k]].x() + (middle > at ? 10 : 0)).margin(1e-5));
        CHECK(uv[1] == Approx(result.mesh.points[t[k]].y()).margin(1e-5));
      }
    }
  }
}

TEST_CASE("wedges tell apart the corners that disagree, and flips carry them along") {
  const IndexedMesh mesh = meshes::flat_grid(3);
  const Attributes given{torn(mesh, mesh.points[1].x()), coordinates(mesh)};
  const auto numbers = wedges(mesh, given);
  REQUIRE(numbers.size() == mesh.triangles.size());
  std::set<std::uint32_t> all;
  for (const auto& corners : numbers) all.insert(corners.begin(), corners.end());
  CHECK(all.size() == mesh.points.size() + 3);
  CHECK(wedges(mesh, {coordinates(mesh)}).empty());

  auto turned = numbers;
  std::swap(turned.front(), turned.back());
  const Attributes moved = rewedged(given, numbers, turned);
  CHECK(moved[0].corners.front() == given[0].corners.back());
  CHECK(moved[0].corners.back() == given[0].corners.front());
  CHECK(moved[1].values == given[1].values);
}
