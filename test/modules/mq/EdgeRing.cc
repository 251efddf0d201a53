#include "whittle/mq/EdgeRing.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <vector>

#include "catch.hh"
#include "whittle/surface/constants.hh"

using namespace whittle::mq;
using Eigen::Vector3f;

namespace {

/// A vertex 0 in the middle of `n` others around it in a plane.
struct Wheel {
  explicit Wheel(std::uint32_t n) {
    vertices.push_back({Vector3f::Zero(), 0});
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * whittle::detail::kPi * i / n;
      vertices.push_back({{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0}, 0});
    }
    for (std::uint32_t i = 0; i < n; ++i)
      ring.add({1 + i, 1 + (i + 1) % n, corner_of(i), PackedNormal(Vector3f::UnitZ())});
    ring.begin_second_end();
  }
  std::vector<Vertex> vertices;
  EdgeRing ring;
};

constexpr float kGuard = 0.2f * 0.2f;

}  // namespace

TEST_CASE("an edge's ring turns any number of faces, and forgets those of the edge before") {
  for (std::uint32_t n = 3; n <= 13; ++n) {
    Wheel wheel(n);
    REQUIRE(wheel.ring.size() == n);
    CHECK(wheel.ring.turn(wheel.vertices, 0, 0, {0.1f, 0, 0}, kGuard));
    // Out over a rim: each face must be looked at, the last one too.
    for (std::uint32_t i = 0; i < n; ++i) {
      const Vector3f out = wheel.vertices[1 + i].position + wheel.vertices[1 + (i + 1) % n].position;
      CHECK_FALSE(wheel.ring.turn(wheel.vertices, 0, 0, out, kGuard));
    }
    wheel.ring.clear();
    CHECK(wheel.ring.size() == 0);
    CHECK(wheel.ring.turn(wheel.vertices, 0, 0, {50, 0, 0}, kGuard));
  }
}

TEST_CASE("an edge's ring measures turns against the face before") {
  Wheel wheel(6);
  // To the height h above the middle each face turns by the angle whose tangent is h over the rim's distance.
  const auto height = [](double degrees) {
    return static_cast<float>(std::sqrt(0.75) * std::tan(degrees * whittle::detail::kPi / 180));
  };
  const double most = std::acos(0.2) * 180 / whittle::detail::kPi;
  CHECK(wheel.ring.turn(wheel.vertices, 0, 0, {0, 0, height(most - 0.1)}, kGuard));
  CHECK_FALSE(wheel.ring.turn(wheel.vertices, 0, 0, {0, 0, height(most + 0.1)}, kGuard));
  CHECK(wheel.ring.turn(wheel.vertices, 0, 0, {0, 0, height(most + 0.1)}, -1));
}

TEST_CASE("an edge's ring turns no face over against the input, whatever the guard") {
  Wheel wheel(6);
  for (const Vector3f& input : {Vector3f(0, 0, -1), Vector3f(1, 0, 0)}) {
    EdgeRing ring;
    for (const auto& side : wheel.ring) ring.add({side.from, side.to, side.corner, PackedNormal(input)});
    CHECK_FALSE(ring.turn(wheel.vertices, 0, 0, {0.1f, 0, 0}, -1));
  }
  EdgeRing ring;  // faces that had no normal in the input
  for (const auto& side : wheel.ring) ring.add({side.from, side.to, side.corner, PackedNormal()});
  CHECK(ring.turn(wheel.vertices, 0, 0, {0.1f, 0, 0}, -1));
}

TEST_CASE("an edge's ring moves the faces at the second end from there") {
  // Two squares' halves side by side: 0 and 1 are the ends, the faces 0 2 3 and 1 4 5 stay.
  const std::vector<Vertex> vertices{{{0, 0, 0}, 0},  {{1, 0, 0}, 0}, {{-1, 1, 0}, 0},
                                     {{-1, 0, 0}, 0}, {{2, 0, 0}, 0}, {{2, 1, 0}, 0}};
  EdgeRing ring;
  ring.add({2, 3, 0, PackedNormal(Vector3f::UnitZ())});
  ring.begin_second_end();
  ring.add({4, 5, 4, PackedNormal(Vector3f::UnitZ())});
  CHECK(ring.n_at_start() == 1);
  CHECK(ring.turn(vertices, 0, 1, {0.5f, 0, 0}, kGuard));
  CHECK_FALSE(ring.turn(vertices, 0, 1, {-1.5f, 0, 0}, kGuard));  // over the first face's far edge
  CHECK_FALSE(ring.turn(vertices, 0, 1, {2.5f, 0, 0}, kGuard));   // over the second's
  // What changes is the second face's quadric, from its own end.
  REQUIRE(ring.turn(vertices, 0, 1, {1, 0, 0}, kGuard));
  std::map<std::uint32_t, SymmetricMatrix> changes;
  ring.update([&](std::uint32_t v, const SymmetricMatrix& change, const Vector3f& /*area*/) {
    changes[v] += change;
  });
  CHECK(changes[4].zz == 0);  // it has not moved
  CHECK(changes[2].zz == 1);  // twice the area
}

TEST_CASE("an edge's ring with all faces at the first end ignores the second end") {
  // Seen from 1, which lies beyond its far edge, the face would turn over.
  const std::vector<Vertex> vertices{{{0, 0, 0}, 0}, {{0, 2, 0}, 0}, {{1, 1, 0}, 0}, {{-1, 1, 0}, 0}};
  EdgeRing ring;
  ring.add({2, 3, 0, PackedNormal(Vector3f::UnitZ())});
  ring.begin_second_end();
  CHECK(ring.turn(vertices, 0, 1, {0, 0.1f, 0}, kGuard));
  CHECK_FALSE(ring.turn(vertices, 0, 1, {0, 1.1f, 0}, kGuard));
}

TEST_CASE("an edge's ring lets a face without area turn anywhere") {
  std::vector<Vertex> vertices{{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{2, 0, 0}, 0}};
  EdgeRing ring;
  ring.add({1, 2, 0, PackedNormal()});
  CHECK(ring.turn(vertices, 0, 0, {0, 1, 0}, kGuard));
  CHECK(ring.turn(vertices, 0, 0, {0, -1, 0}, kGuard));
}

TEST_CASE("an edge's ring gives the change of the quadrics and the survivor's sum") {
  for (const std::uint32_t n : {3u, 4u, 5u, 9u}) {
    Wheel wheel(n);
    const Vector3f target(0.1f, -0.05f, 0.2f);
    REQUIRE(wheel.ring.turn(wheel.vertices, 0, 0, target, kGuard));
    std::map<std::uint32_t, SymmetricMatrix> changes;
    std::map<std::uint32_t, Vector3f> turned;
    const EdgeRing::Sums sums =
        wheel.ring.update([&](std::uint32_t v, const SymmetricMatrix& change, const Vector3f& area) {
          changes[v] += change;
          turned.emplace(v, Vector3f::Zero()).first->second += area;
        });

    SymmetricMatrix expected;
    Vector3f area = Vector3f::Zero();
    std::map<std::uint32_t, Vector3f> expected_turned;
    std::map<std::uint32_t, SymmetricMatrix> expected_changes;
    const auto quadric = [](const Vector3f& p, const Vector3f& q, const Vector3f& r) {
      const Vector3f normal = (q - p).cross(r - p);
      return SymmetricMatrix::outer(normal, 1 / normal.norm());
    };
    for (const auto& side : wheel.ring) {
      const Vector3f &q = wheel.vertices[side.from].position, &r = wheel.vertices[side.to].position;
      const SymmetricMatrix after = quadric(target, q, r);
      expected += after;
      area += (q - target).cross(r - target);
      for (const std::uint32_t v : {side.from, side.to}) {
        expected_changes[v] += after;
        expected_changes[v] -= quadric(Vector3f::Zero(), q, r);
        expected_turned.emplace(v, Vector3f::Zero()).first->second +=
            (q - target).cross(r - target) - q.cross(r);
      }
    }
    REQUIRE(changes.size() == n);
    const Vector3f probe(0.3f, 0.7f, -0.4f);
    CHECK((sums.quadric * probe - expected * probe).norm() < 1e-5f);
    CHECK((sums.area - area).norm() < 1e-5f);
    for (const auto& [v, change] : turned) CHECK((change - expected_turned[v]).norm() < 1e-5f);
    for (const auto& [v, change] : changes)
      CHECK((change * probe - expected_changes[v] * probe).norm() < 1e-5f);
  }
}

TEST_CASE("an edge's ring turns a face by up to just under 90 degrees against the input") {
  Wheel wheel(6);
  const auto height = [](double cosine) {
    return static_cast<float>(std::sqrt(0.75) * std::sqrt(1 / (cosine * cosine) - 1));
  };
  CHECK(wheel.ring.turn(wheel.vertices, 0, 0, {0, 0, height(0.015)}, -1));
  CHECK_FALSE(wheel.ring.turn(wheel.vertices, 0, 0, {0, 0, height(0.006)}, -1));
}
