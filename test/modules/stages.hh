/// \file
/// For tests of several stages or passes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/plan/Stages.hh"
#include "whittle/plan/execute.hh"

namespace stages {

constexpr auto kNever = [](const whittle::StagesT<double>&) { return false; };

inline void check_same(const std::vector<whittle::Collapse>& a, const std::vector<whittle::Collapse>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].from == b[i].from);
    CHECK(a[i].to == b[i].to);
    CHECK(a[i].faces == b[i].faces);
    CHECK(a[i].rest == b[i].rest);
    CHECK(a[i].target == b[i].target);
  }
}

/// The least cosine between a face after a plan and the face that it was.
inline double least_cosine(const whittle::ExecutedT<double>& out, const meshes::IndexedMesh& input) {
  const whittle::SurfaceT<double> before(input), after(out.mesh);
  double least = 1;
  for (std::uint32_t f = 0; f < after.n_faces(); ++f)
    least = std::min(least, after.normal(f).normalized().dot(before.normal(out.face_origin[f]).normalized()));
  return least;
}

/// The same input for every test of several stages: a shaken torus with flags and tolerances.
inline whittle::SurfaceExtras some_extras(const meshes::IndexedMesh& mesh) {
  whittle::SurfaceExtras extras;
  std::mt19937 random(5);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    extras.flags.push_back(random() % 10 == 0 ? std::uint8_t(whittle::kLocked << random() % 2)
                                              : std::uint8_t(0));
    extras.tolerance.push_back(0.25f * static_cast<float>(random() % 8));
  }
  return extras;
}
inline meshes::IndexedMesh some_mesh() {
  return meshes::shaken(meshes::torus(24, 14), 0.01, 11);
}

}  // namespace stages
