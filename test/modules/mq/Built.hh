/// \file
/// The mesh that mq plans on, by the input's vertex numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/Worker.hh"
#include "whittle/mq/build.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/threads.hh"

namespace fixture {

constexpr whittle::mq::Options kUsual{0.2f, 180, HUGE_VAL};

inline whittle::mq::Mesh built(const meshes::IndexedMesh& input, whittle::SurfaceExtras extras = {},
                               const whittle::mq::Options& options = kUsual, std::size_t n_threads = 1) {
  whittle::detail::Crew crew(n_threads);
  return whittle::mq::build(input, whittle::detail::checked(input, std::move(extras)), options, crew);
}

/// A worker for the whole mesh.
inline whittle::mq::Worker worker_of(const whittle::mq::Mesh& mesh) {
  return {mesh.partition, whittle::mq::kNoPart};
}

inline std::uint32_t vertex(const whittle::mq::Mesh& mesh, std::uint32_t input) {
  const auto found = std::find(mesh.input.begin(), mesh.input.end(), input);
  REQUIRE(found != mesh.input.end());
  return static_cast<std::uint32_t>(found - mesh.input.begin());
}

/// The half-edge from one vertex of the input to another.
inline whittle::mq::Corner corner(const whittle::mq::Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  using namespace whittle::mq;
  const std::uint32_t a = vertex(mesh, from), b = vertex(mesh, to);
  for (std::size_t f = 0; f < mesh.table.n_faces(); ++f)
    for (Corner c = corner_of(f); c < corner_of(f) + 3 && !mesh.table.is_dead(c); ++c)
      if (mesh.table.vertex(c) == a && mesh.table.vertex(next(c)) == b) return c;
  FAIL("no half-edge from " << from << " to " << to);
  return kNoCorner;
}

/// Meshes of all kinds that a corner table takes whole: closed, open, with holes, small.
inline std::vector<meshes::IndexedMesh> sound_meshes() {
  return {meshes::shaken(meshes::torus(24, 12), 0.01, 1), meshes::shaken(meshes::flat_grid(12), 0.1, 2),
          meshes::octahedron(), meshes::cone(9, 0.5)};
}

}  // namespace fixture
