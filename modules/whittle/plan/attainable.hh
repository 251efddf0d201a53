/// \file
/// How far a target can be followed before what is free would be crushed to make up for what stays.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/plan/TargetCount.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/pieces.hh"

namespace whittle {

/// A target, or the nearest one that leaves the free part of a mesh its share.
struct Attainable {
  TargetCount target;       ///< as it was asked for, or higher
  std::size_t pieces = 0;   ///< that stay
  std::size_t small = 0;    ///< of those, whose share of the target is less than four faces
  std::size_t held = 0;     ///< vertices that cannot vanish
  std::size_t charts = 0;   ///< that keep a face each, more than their share of the target
  std::size_t minimum = 0;  ///< faces that are left at least: two for a held vertex or one on the boundary,
                            ///< four for a small piece, one for a small chart
  bool is_higher = false;   ///< the target has been raised
};

namespace detail {

/// Whether the faces around each vertex leave an edge open: there, the neighbours of a vertex do not cancel in pairs.
/// Each neighbour stands for 64 mixed bits, so that others do not cancel by accident.
template <typename Real>
std::vector<bool> on_boundary(const IndexedMeshT<Real>& mesh) {
  const auto bits = [](std::uint64_t v) {  // splitmix64 (Steele, Lea and Flood 2014)
    v = (v + 1) * 0x9e3779b97f4a7c15u;
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
  };
  std::vector<std::uint64_t> sums(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles) {
    const std::uint64_t a = bits(t[0]), b = bits(t[1]), c = bits(t[2]);
    sums[t[0]] ^= b ^ c;
    sums[t[1]] ^= c ^ a;
    sums[t[2]] ^= a ^ b;
  }
  std::vector<bool> open(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) open[v] = sums[v] != 0;
  return open;
}

}  // namespace detail

/// Looks at what cannot vanish: held vertices, the last four faces of each of several pieces whose share of the target is
/// less, and the last face of each chart that keeps one.
/// Where that leaves the rest less than half of its own share, the target is raised to all that cannot vanish and the
/// whole share of the rest: it could not be reached without ruining the rest, or not at all.
/// \param goes    for each piece whether it is to vanish and does not count; or empty: none
/// \param flags   of the vertices, or empty
/// \param holds   the flags that hold a vertex
/// \param target  of what does not vanish
/// \param kept    charts of which none loses its last face
template <typename Real>
Attainable attainable(const IndexedMeshT<Real>& mesh, const Pieces& pieces, const std::vector<bool>& goes,
                      const std::vector<std::uint8_t>& flags, std::uint8_t holds, const TargetCount& target,
                      const std::vector<ChartSize>& kept = {}) {
  constexpr double kLeastShare = 0.5;
  constexpr std::size_t kLeastFaces = 4;
  Attainable out;
  out.target = target;
  const auto counts = [&](std::size_t piece) { return goes.empty() || !goes[piece]; };
  std::size_t n_faces = 0, used = 0, isolated = mesh.points.size();
  for (std::size_t p = 0; p < pieces.count(); ++p) {
    isolated -= pieces.vertices[p];
    if (!counts(p)) continue;
    n_faces += pieces.faces[p];
    used += pieces.vertices[p];
    ++out.pieces;
  }
  if (!target.any() || n_faces == 0) return out;
  const auto all = static_cast<double>(n_faces);
  const double faces_per_vertex = all / static_cast<double>(used);
  double wanted = static_cast<double>(target.faces);  // either count meets the target: the nearer one
  if (target.vertices > 0)
    wanted = std::max(wanted, faces_per_vertex *
                                  static_cast<double>(target.vertices - std::min(target.vertices, isolated)));
  if (wanted >= all) return out;
  const double ratio = wanted / all;

  std::vector<std::size_t> least(pieces.count(), 0);
  std::vector<bool> open;
  for (std::size_t v = 0; v < flags.size(); ++v) {
    const std::uint32_t piece = pieces.of_vertex[v];
    if ((flags[v] & holds) == 0 || piece == Pieces::kNone || !counts(piece)) continue;
    if (open.empty()) open = detail::on_boundary(mesh);
    least[piece] += open[v] ? 1u : 2u;
    ++out.held;
  }
  std::vector<std::size_t> of_charts(pieces.count(), 0);
  for (const ChartSize& chart : kept) {
    const std::uint32_t piece = pieces.of_vertex[chart.vertex];
    if (piece == Pieces::kNone || !counts(piece) || ratio * static_cast<double>(chart.faces) >= 1) continue;
    ++of_charts[piece];
    ++out.charts;
  }
  for (std::size_t p = 0; p < least.size(); ++p) {
    if (!counts(p)) continue;
    least[p] = std::max(least[p], of_charts[p]);
    if (out.pieces > 1 && ratio * static_cast<double>(pieces.faces[p]) < kLeastFaces) {
      least[p] = std::max(least[p], kLeastFaces);
      ++out.small;
    }
    out.minimum += std::min(pieces.faces[p], least[p]);
  }
  const auto minimum = static_cast<double>(out.minimum);
  const double share = (all - minimum) * ratio;
  if (wanted - minimum >= kLeastShare * share) return out;
  const double faces = std::ceil(minimum + share);
  out.is_higher = true;
  if (target.faces > 0) out.target.faces = static_cast<std::size_t>(faces);
  if (target.vertices > 0)
    out.target.vertices = isolated + static_cast<std::size_t>(std::ceil(faces / faces_per_vertex));
  return out;
}

}  // namespace whittle
