/// \file
/// Where an edge's ends merge, and at what cost.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "whittle/mq/Four.hh"
#include "whittle/mq/Mesh.hh"
#include "whittle/mq/SymmetricMatrix.hh"
#include "whittle/mq/Worker.hh"

namespace whittle::mq {

struct Placement {
  Vec offset;  ///< from the start of the half-edge
  float cost;
};
using Placements = std::array<Placement, 4>;

/// Four edges by their vertices.
struct FourEdges {
  std::array<std::uint32_t, 4> start, end;
};

/// Where it is not known how to do better: in the middle.
inline Placement middle_place(const Vec& e, const SymmetricMatrix& sum) {
  const Vec middle = e / 2;
  return {middle, std::max(0.0f, middle.dot(sum * middle))};
}

/// Of edges that have an end that stays, puts the placement at that end in place of the best one.
/// \param pull_b  the quadric at the end times the edge
inline void place_at_held_ends(const Mesh& mesh, const FourEdges& edges, const FourVectors& e,
                               const FourMatrices& at_a, const FourVectors& pull_b, Placements& placements) {
  const Four zero(0.0f), at_start = e.dot(pull_b).max(0.0f), at_end = e.dot(at_a * e).max(0.0f);
  std::array<Placements, 3> choices{placements};
  Eigen::Matrix4f::Map(&choices[1][0].offset.x()) = transposed(zero, zero, zero, at_start);
  Eigen::Matrix4f::Map(&choices[2][0].offset.x()) = transposed(e.x(), e.y(), e.z(), at_end);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t start = edges.start[i], end = edges.end[i];
    const std::size_t choice = mesh.hold(start, end) == kFixed   ? 1u
                               : mesh.hold(end, start) == kFixed ? 2u
                                                                 : 0u;
    placements[i] = choices[choice][i];
  }
}

/// How much a change of the enclosed volume counts, squared and divided by the trace of the quadrics.
constexpr float kVolumeWeight = 10;

/// The areas at four vertices.
EIGEN_ALWAYS_INLINE FourVectors areas_at(const Mesh& mesh, const std::array<std::uint32_t, 4>& v) {
  return gathered({mesh.areas[v[0]].sum.data(), mesh.areas[v[1]].sum.data(), mesh.areas[v[2]].sum.data(),
                   mesh.areas[v[3]].sum.data()});
}

/// Minimises the sum of the squared distances to both ends' planes, u Ha u + (u - e) Hb (u - e), with a
/// slight pull to the middle that decides where the planes leave a direction open. With it counts the square of the change
/// of the enclosed volume, g u - gb e by the areas g of both ends and gb of the second. Along a thin tip the planes say
/// little about where it ends, and the volume says it. It decides about the place alone and is not part of the cost.
/// \param e  the edges, from their starts
inline Placements best_places(const Mesh& mesh, const FourEdges& edges, const FourVectors& e,
                              const FourMatrices& at_a, const FourMatrices& at_b) {
  const FourMatrices sum = at_a + at_b;
  const FourVectors pull_b = at_b * e;
  const Four pull = 1e-5f * sum.trace();
  const FourVectors middle = Four(0.5f) * e;
  FourVectors pivots = e;
  const FourVectors area_b = areas_at(mesh, edges.end), area = areas_at(mesh, edges.start) + area_b;
  const Four share = kVolumeWeight / sum.trace().max(kLeastLength), kept = area_b.dot(e);
  const FourVectors u = (sum + FourMatrices::identity(pull) + FourMatrices::outer(area, share))
                            .solve(pull_b + pull * middle + (share * kept) * area, pivots);
  const FourVectors off = u - middle;
  const Four swept = area.dot(u);
  const Four cost = (e - u).dot(pull_b) - pull * u.dot(off) + share * swept * (kept - swept);
  const Four least = pivots.x().min(pivots.y()).min(pivots.z()),
             far = 4 * e.squaredNorm() - off.squaredNorm();
  Placements placements;
  Eigen::Matrix4f::Map(&placements[0].offset.x()) = transposed(u.x(), u.y(), u.z(), cost.max(0.0f));

  // Zero times a number that is not finite is not zero.
  const bool irregular = !(least.min(far).minCoeff() > 0 && (0 * (least + far)).sum() == 0);
  if (irregular)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (least[k] > 0 && far[k] >= 0) continue;
      placements[i] = middle_place(
          mesh.vertices[edges.end[i]].position - mesh.vertices[edges.start[i]].position, one_of(sum, k));
    }
  if (!mesh.all_free) place_at_held_ends(mesh, edges, e, at_a, pull_b, placements);
  if (!mesh.weights.empty())
    for (std::size_t i = 0; i < 4; ++i)
      placements[i].cost *= std::max(mesh.weights[edges.start[i]], mesh.weights[edges.end[i]]);
  return placements;
}

/// Places four edges at once, which takes hardly longer than one; some may be the same.
inline Placements place(const Mesh& mesh, const std::array<Corner, 4>& corners) {
  FourEdges edges;
  std::array<const float*, 4> starts, ends;
  std::array<const SymmetricMatrix*, 4> at_start, at_end;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t a = mesh.table.vertex(corners[i]), b = mesh.table.vertex(next(corners[i]));
    edges.start[i] = a;
    edges.end[i] = b;
    starts[i] = mesh.vertices[a].position.data();
    ends[i] = mesh.vertices[b].position.data();
    at_start[i] = &mesh.quadrics[a];
    at_end[i] = &mesh.quadrics[b];
  }
  const FourVectors e = gathered(ends) - gathered(starts);
  FourMatrices at_a = gathered(at_start), at_b = gathered(at_end);
  if (!mesh.values.empty()) {
    const auto along = mesh.values.along(edges.start, edges.end, e);
    at_a += along[0];
    at_b += along[1];
  }
  return best_places(mesh, edges, e, at_a, at_b);
}

/// Prefetches the memory that `place` will read.
inline void prefetch(const Mesh& mesh, Corner c, const Worker& worker) {
#if defined(__GNUC__)
  const auto& face = mesh.table.face(c);
  if (worker.part != kNoPart && worker.part != face.notes.part) return;
  if (face.vertex[0] == CornerTable::kDead) return;
  for (const std::uint32_t v : face.vertex) {
    __builtin_prefetch(&mesh.vertices[v]);
    __builtin_prefetch(&mesh.quadrics[v]);
    __builtin_prefetch(&mesh.areas[v]);
  }
#endif
}

}  // namespace whittle::mq
