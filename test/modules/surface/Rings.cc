#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/surface/Rings.hh"

using whittle::Ring;
using whittle::detail::Rings;
using whittle::detail::RingShape;
using Triangles = std::vector<Rings::Triangle>;

namespace {

Rings rings_of(const Triangles& triangles, std::size_t n_vertices, std::size_t n_threads = 1) {
  whittle::detail::Crew crew(n_threads);
  return {triangles, n_vertices, true, crew};
}

/// A disc of `n` faces around vertex 0, or a fan of them if it is open; the faces in an order of their own.
Triangles fan(std::uint32_t n, bool is_open) {
  Triangles triangles;
  for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({0, 1 + i, is_open || i + 1 < n ? 2 + i : 1});
  std::mt19937 random(n);
  for (std::size_t i = triangles.size(); i > 1; --i) std::swap(triangles[i - 1], triangles[random() % i]);
  for (auto& t : triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  return triangles;
}

}  // namespace

TEST_CASE("the ring goes counter-clockwise and pairs faces with vertices") {
  const auto mesh = meshes::grid(3, [](std::uint32_t, std::uint32_t) { return 0.0; });
  const Rings rings = rings_of(mesh.triangles, mesh.points.size());

  const Ring closed = rings[4];
  REQUIRE(rings.shape(4) == RingShape::closed);
  REQUIRE(closed.is_closed());
  REQUIRE(closed.size() == 6);
  REQUIRE(closed.n_faces() == 6);
  CHECK(closed[6] == closed[0]);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& t = mesh.triangles[rings.face(4, i)];
    CHECK(std::set<std::uint32_t>(t.begin(), t.end()) ==
          std::set<std::uint32_t>{4, closed[i], closed[i + 1]});
    const auto a = mesh.points[closed[i]] - mesh.points[4];
    const auto b = mesh.points[closed[i + 1]] - mesh.points[4];
    CHECK(a.cross(b).z() > 0);
  }

  const Ring open = rings[1];
  CHECK(rings.shape(1) == RingShape::open);
  CHECK_FALSE(open.is_closed());
  CHECK(std::vector<std::uint32_t>(open.begin(), open.end()) == std::vector<std::uint32_t>{2, 5, 4, 0});
  CHECK(open.n_faces() == 3);
  CHECK(open.front() == 2);
  CHECK(open.back() == 0);
}

// Up to 8 and up to 24 faces the rings are found in a way of their own.
TEST_CASE("discs and fans of any valence are put in order") {
  for (const std::uint32_t n : {1u, 2u, 3u, 6u, 8u, 9u, 23u, 24u, 25u, 300u}) {
    INFO(n << " faces");
    const Triangles open = fan(n, true);
    const Rings open_rings = rings_of(open, n + 2);
    const Ring ring = open_rings[0];
    REQUIRE(ring.n_faces() == n);
    REQUIRE(ring.size() == n + 1);
    for (std::uint32_t i = 0; i <= n; ++i) CHECK(ring[i] == 1 + i);

    if (n < 3) continue;
    const Triangles closed = fan(n, false);
    const Rings rings = rings_of(closed, n + 1);
    const Ring disc = rings[0];
    REQUIRE(disc.is_closed());
    REQUIRE(disc.size() == n);
    for (std::uint32_t i = 0; i < n; ++i) {
      CHECK(disc[i + 1] == disc[i] % n + 1);
      const auto& t = closed[rings.face(0, i)];
      CHECK(std::set<std::uint32_t>(t.begin(), t.end()) == std::set<std::uint32_t>{0, disc[i], disc[i + 1]});
    }
  }
}

TEST_CASE("what is neither a disc nor a fan is complex, and has no ring") {
  const auto is_complex = [](const Triangles& triangles, std::size_t n_vertices) {
    const Rings rings = rings_of(triangles, n_vertices);
    return rings.shape(0) == RingShape::complex && rings[0].size() == 0;
  };
  for (const std::uint32_t n : {3u, 12u, 40u}) {  // one for each way of finding the order
    INFO(n << " faces");
    Triangles two_fans = fan(n, true);
    for (const auto& t : fan(n, true))
      two_fans.push_back({t[0] ? t[0] + n + 1 : 0, t[1] ? t[1] + n + 1 : 0, t[2] ? t[2] + n + 1 : 0});
    CHECK(is_complex(two_fans, 2 * n + 3));

    Triangles disc_and_fan = fan(n, false);
    disc_and_fan.push_back({0, n + 1, n + 2});
    CHECK(is_complex(disc_and_fan, n + 3));

    Triangles two_discs = fan(n, false);
    for (const auto& t : fan(n, false))
      two_discs.push_back({t[0] ? t[0] + n : 0, t[1] ? t[1] + n : 0, t[2] ? t[2] + n : 0});
    CHECK(is_complex(two_discs, 2 * n + 1));

    Triangles third_face_leaves = fan(n, true);  // three faces share the edge to 2, two of them leave by it
    third_face_leaves.push_back({0, 2, n + 2});
    CHECK(is_complex(third_face_leaves, n + 3));

    Triangles third_face_arrives = fan(n, true);
    third_face_arrives.push_back({0, n + 2, 2});
    CHECK(is_complex(third_face_arrives, n + 3));

    Triangles winding = fan(n, false);  // the face that goes on past the beginning is found first
    winding.insert(winding.begin(), {0, 1, n + 1});
    CHECK(is_complex(winding, n + 2));

    Triangles repeated = fan(n, false);
    repeated.push_back(repeated.front());
    CHECK(is_complex(repeated, n + 1));

    Triangles degenerate = fan(n, true);
    degenerate.push_back({0, 0, 1});
    CHECK(is_complex(degenerate, n + 2));
    degenerate.back() = {0, n + 1, n + 1};
    CHECK(is_complex(degenerate, n + 2));
  }
  CHECK(rings_of({{0, 1, 2}}, 4).shape(3) == RingShape::empty);
  CHECK(rings_of({{0, 1, 2}}, 4)[3].size() == 0);
}

TEST_CASE("rings do not depend on the number of threads") {
  const auto mesh = meshes::grid(150, [](std::uint32_t, std::uint32_t) { return 0.0; });
  const Rings one = rings_of(mesh.triangles, mesh.points.size());
  for (const std::size_t n_threads : {2u, 3u, 5u}) {
    const Rings many = rings_of(mesh.triangles, mesh.points.size(), n_threads);
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      REQUIRE(many.shape(v) == one.shape(v));
      REQUIRE(std::equal(one[v].begin(), one[v].end(), many[v].begin(), many[v].end()));
    }
  }
}
