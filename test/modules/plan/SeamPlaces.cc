#include "whittle/plan/SeamPlaces.hh"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "catch.hh"

using whittle::detail::Lists;
using whittle::detail::SeamPlaces;
using whittle::detail::WedgedFaces;
using Triangles = WedgedFaces::Triangles;

namespace {

/// A disc of three faces around one vertex, each a chart by itself.
struct ThreeCharts {
  std::uint32_t middle;
  std::vector<Eigen::Vector3d> points;
  Triangles triangles, wedges;

  /// \param middle_first  whether the vertex is the first or the last
  explicit ThreeCharts(bool middle_first) : middle(middle_first ? 0 : 3) {
    points = {{2, 0, 0}, {0, 2, 0}, {-2, -2, 0}};
    points.insert(middle_first ? points.begin() : points.end(), {0, 0, 0});
    const std::uint32_t first = middle_first ? 1 : 0;
    for (std::uint32_t f = 0; f < 3; ++f) {
      triangles.push_back({middle, first + f, first + (f + 1) % 3});
      const auto& t = triangles.back();
      wedges.push_back({10 * f + t[0], 10 * f + t[1], 10 * f + t[2]});
    }
  }
  Eigen::Vector3d at(const SeamPlaces::Place& place) const {
    Eigen::Vector3d p(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) p += place.shares[k] * points[triangles[place.face][k]];
    return p;
  }
};

}  // namespace

TEST_CASE("the two sides that are left take their values where they met, though other seams are nearer") {
  for (const bool middle_first : {true, false}) {
    const ThreeCharts mesh(middle_first);
    const WedgedFaces faces(mesh.triangles, mesh.wedges, 4);
    SeamPlaces places(mesh.points, faces);
    const std::array<std::uint32_t, 1> members{mesh.middle};
    // Face 2 has vanished; the seam that it had with face 0 is 0.5 away, that of faces 0 and 1 is 1 away.
    places.find({1, 0.5, 0}, Lists::Range(members.data(), members.data() + 1), {{0, 5}, {1, 6}});
    REQUIRE(places.n_groups() == 2);
    for (std::uint32_t i = 0; i < 2; ++i) {
      const auto& place = places.place(places.group(i));
      CHECK(place.face == i);
      CHECK(mesh.at(place) == Eigen::Vector3d(0, 0.5, 0));
    }
  }
}

TEST_CASE("where three sides are left, the corner stays with the one that the others' seam does not reach") {
  const ThreeCharts mesh(true);
  const WedgedFaces faces(mesh.triangles, mesh.wedges, 4);
  SeamPlaces places(mesh.points, faces);
  const std::array<std::uint32_t, 1> members{mesh.middle};
  places.find({0, 1, 0}, Lists::Range(members.data(), members.data() + 1), {{0, 5}, {1, 6}, {2, 7}});
  REQUIRE(places.n_groups() == 3);
  for (std::uint32_t i = 0; i < 2; ++i)
    CHECK(mesh.at(places.place(places.group(i))) == Eigen::Vector3d(0, 1, 0));
  CHECK(mesh.at(places.place(places.group(2))) == Eigen::Vector3d(0, 0, 0));
  CHECK(places.place(places.group(2)).face == 2);
}
