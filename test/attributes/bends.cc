#include "attributes/bends.hh"

#include <cmath>

#include "attributes/values.hh"
#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::attributes;

namespace {

template <typename At>
Attribute texture_at_vertices(const IndexedMesh& mesh, At at) {
  Attribute out{Kind::texture, "", 2, false, false, {}, {}};
  for (const auto& p : mesh.points) {
    const Eigen::Vector2d uv = at(p);
    out.values.push_back(static_cast<float>(uv[0]));
    out.values.push_back(static_cast<float>(uv[1]));
  }
  return out;
}

/// A grid of n by n vertices on a sphere's cap: it bends the same everywhere.
IndexedMesh cap(std::uint32_t n, double depth) {
  const double middle = (n - 1) / 2.0;
  return meshes::grid(n, [=](std::uint32_t i, std::uint32_t j) {
    return -depth * ((i - middle) * (i - middle) + (j - middle) * (j - middle));
  });
}

}  // namespace

TEST_CASE("bends of two faces are the height of the tip, and how far its value is from linear") {
  IndexedMesh mesh;  // the second face stands up along the diagonal of the first one's square
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.25}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  Attribute texture = texture_at_vertices(mesh, [](const auto& p) { return Eigen::Vector2d(p.x(), p.y()); });
  CHECK(bends(mesh, texture).shape == Approx(0.25));
  CHECK(bends(mesh, texture).value == Approx(0).margin(1e-7));
  texture.values[6] += 0.5F;
  CHECK(bends(mesh, texture).value == Approx(0.5));

  // A seam between the two: nothing is left to look at.
  texture.corners = {{0, 1, 2}, {4, 3, 5}};
  texture.values.insert(texture.values.end(), {7, 7, 8, 8});
  CHECK(bends(mesh, texture).shape == 0);
  CHECK(bends(mesh, texture).value == 0);
}

TEST_CASE("bends leave out a tenth: a line at which a texture is mirrored, but not what bends everywhere") {
  const IndexedMesh mesh = cap(41, 0.001);
  const Attribute mirrored =
      texture_at_vertices(mesh, [](const auto& p) { return Eigen::Vector2d(std::abs(p.x() - 20), p.y()); });
  CHECK(bends(mesh, mirrored).value < 1e-3);
  CHECK(bends(mesh, mirrored).shape == Approx(0.002).epsilon(0.05));
  const Attribute bent = texture_at_vertices(
      mesh, [](const auto& p) { return Eigen::Vector2d(p.x() + 0.01 * p.y() * p.y(), p.y()); });
  CHECK(bends(mesh, bent).value == Approx(0.02).epsilon(0.05));
}

TEST_CASE("values that bend more than the shape weigh less by default, down to a tenth") {
  const auto weight = [](double depth, double bend) {
    const IndexedMesh mesh = cap(41, depth);
    const Attribute texture = texture_at_vertices(mesh, [&](const auto& p) {
      return Eigen::Vector2d((p.x() + bend * p.y() * p.y()) / 40, p.y() / 40);
    });
    return default_weights(mesh, {texture}).texture;
  };
  const double whole = weight(0.001, 0);
  CHECK(whole == Approx(0.1 * 40).epsilon(0.01));
  CHECK(weight(0.01, 0.001) == Approx(whole).epsilon(0.05));
  // Heights of 0.002, bends of 0.02 / 40 at 4 units: 0.002. Half of the shape's is allowed.
  CHECK(weight(0.001, 0.01) == Approx(whole / 2).epsilon(0.05));
  CHECK(weight(0, 0.01) == Approx(whole / 10).epsilon(0.05));
}
