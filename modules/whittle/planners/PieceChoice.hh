/// \file
/// Which pieces of a mesh vanish as a whole, and how far the others go.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/plan/TargetCount.hh"
#include "whittle/plan/attainable.hh"
#include "whittle/planners/pieces_by_error.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/pieces.hh"

namespace whittle {

/// Which pieces, parts that share no vertex, may vanish as a whole. The largest stays, and so do those with a vertex
/// that is locked, a feature or of tolerance 0.
struct PieceRule {
  /// Those that cost less than what else would have to go to reach the target: see `pieces_by_error`.
  bool by_error = false;
  /// Those whose bounding box has a smaller diagonal. Model units, >= 0; 0: none.
  double below = 0;

  bool keeps_all() const { return !by_error && below == 0; }
  /// \throw InvalidParameter
  void validate() const {
    if (!(below >= 0 && std::isfinite(below)))
      throw InvalidParameter("the size of pieces must be a finite length of at least 0");
  }
};

namespace detail {

/// The pieces that vanish, and the target of the others. While the others are decimated, those that vanish are locked,
/// and belong to the target.
struct PieceChoice {
  Pieces pieces;           ///< empty where neither the rule nor a target asks for them
  std::vector<bool> goes;  ///< for each piece; empty where none goes
  Attainable attainable;   ///< the target of the others

  bool has_gone(std::size_t vertex) const {
    return !goes.empty() && pieces.of_vertex[vertex] != Pieces::kNone && goes[pieces.of_vertex[vertex]];
  }
  std::size_t n_gone() const { return static_cast<std::size_t>(std::count(goes.begin(), goes.end(), true)); }
  std::size_t faces_gone() const { return sum_gone(pieces.faces); }

  void lock(std::vector<std::uint8_t>& flags) const {
    if (goes.empty()) return;
    flags.resize(pieces.of_vertex.size(), 0);
    for (std::size_t v = 0; v < flags.size(); ++v)
      if (has_gone(v)) flags[v] |= kLocked;
  }
  TargetCount target_with_pieces() const {
    TargetCount target = attainable.target;
    if (target.faces > 0) target.faces += sum_gone(pieces.faces);
    if (target.vertices > 0) target.vertices += sum_gone(pieces.vertices);
    return target;
  }

 private:
  std::size_t sum_gone(const std::vector<std::size_t>& counts) const {
    std::size_t sum = 0;
    for (std::size_t p = 0; p < goes.size(); ++p)
      if (goes[p]) sum += counts[p];
    return sum;
  }
};

/// The pieces whose boxes are smaller than a length, without those that stay.
template <typename Real>
std::vector<bool> pieces_below(const IndexedMeshT<Real>& mesh, const Pieces& pieces,
                               const SurfaceExtras& extras, double length) {
  const std::vector<double> diagonals = piece_diagonals(mesh, pieces);
  std::vector<bool> goes;
  goes.reserve(diagonals.size());
  for (const double diagonal : diagonals) goes.push_back(diagonal < length);
  const auto largest = std::max_element(diagonals.begin(), diagonals.end());
  if (largest != diagonals.end()) goes[static_cast<std::size_t>(largest - diagonals.begin())] = false;
  const std::vector<bool> held = held_pieces(pieces, extras);
  for (std::size_t p = 0; p < goes.size(); ++p) goes[p] = goes[p] && !held[p];
  return goes;
}

/// \param holds  the flags that hold a vertex for the planner
/// \param kept   charts of which none loses its last face
/// \param force  leave the target as it is, even if it ruins what is free
/// \throw InvalidMesh, InvalidParameter  as `pieces_by_error`.
template <typename Real>
PieceChoice choose_pieces(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras, const PieceRule& rule,
                          std::uint8_t holds, const std::vector<ChartSize>& kept, const TargetCount& target,
                          bool force, std::size_t n_threads) {
  PieceChoice choice;
  choice.attainable.target = target;
  if (rule.keeps_all() && !target.any()) return choice;
  choice.pieces = pieces_of(mesh);
  if (rule.by_error && target.any())
    choice.goes = pieces_by_error(mesh, choice.pieces, extras, target, n_threads);
  if (rule.below > 0) {
    const std::vector<bool> small = pieces_below(mesh, choice.pieces, extras, rule.below);
    choice.goes.resize(small.size(), false);
    for (std::size_t p = 0; p < small.size(); ++p) choice.goes[p] = choice.goes[p] || small[p];
  }
  if (choice.n_gone() == 0) choice.goes.clear();
  choice.attainable = attainable(mesh, choice.pieces, choice.goes, extras.flags, holds, target, kept);
  if (force) {
    choice.attainable.target = target;
    choice.attainable.is_higher = false;
  }
  return choice;
}

}  // namespace detail
}  // namespace whittle
