#include "whittle/mq/PackedNormal.hh"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <random>

#include "catch.hh"

using Eigen::Vector3f;
using whittle::mq::FourVectors;
using whittle::mq::PackedNormal;

namespace {

Vector3f in_lane(const FourVectors& v, std::size_t i) {
  const auto k = static_cast<Eigen::Index>(i);
  return {v.x()[k], v.y()[k], v.z()[k]};
}

}  // namespace

TEST_CASE("a packed normal is good to a fifth of a degree") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  for (int round = 0; round < 100; ++round) {
    std::array<Vector3f, 4> normals;
    Eigen::Array<std::uint32_t, 4, 1> bits;
    for (std::size_t i = 0; i < 4; ++i) {
      const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
      normals[i] = round == 0 ? Vector3f(-Vector3f::Unit(i % 3)) : Vector3f(Vector3f(x, y, z).normalized());
      bits[static_cast<Eigen::Index>(i)] = PackedNormal(normals[i]).bits();
    }
    const FourVectors unpacked = PackedNormal::unpacked(bits);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3f v = in_lane(unpacked, i) / PackedNormal::kLength;
      CHECK((v - normals[i]).norm() < 0.0035f);
      CHECK(PackedNormal(normals[i]).bits() != 0);
    }
  }
  CHECK(PackedNormal().bits() == 0);
  CHECK(in_lane(PackedNormal::unpacked(Eigen::Array<std::uint32_t, 4, 1>::Zero()), 2).isZero());
}

TEST_CASE("a packed normal is rounded to the nearest of 511 steps") {
  for (const float step : {0.0f, 100.3f, 99.7f, -100.3f, -99.7f}) {
    const float x = step / PackedNormal::kLength;
    const Vector3f normal(x, 0, std::sqrt(1 - x * x));
    Eigen::Array<std::uint32_t, 4, 1> bits;
    bits.setConstant(PackedNormal(normal).bits());
    CHECK(in_lane(PackedNormal::unpacked(bits), 1).x() == std::round(step));
  }
}
