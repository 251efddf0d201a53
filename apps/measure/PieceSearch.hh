/// \file
/// Bounds the distance between two surfaces over all of their points, piece by piece.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "measure/Monitor.hh"
#include "measure/Watch.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// A face of one of two surfaces, or a part of one, with what is known of its distance from the other surface.
struct Piece {
  std::array<Eigen::Vector3d, 3> corners;
  std::array<double, 3> distances;       ///< of the corners
  std::array<std::uint32_t, 3> nearest;  ///< the other surface's face nearest to each corner
  std::uint32_t best;                    ///< the other surface's face that gave `upper`
  std::uint32_t face;                    ///< of its own surface, an index into the mesh's triangles
  bool on_original;
  double upper;  ///< no point of the piece is farther from the other surface

  double lower() const { return std::max({distances[0], distances[1], distances[2]}); }
};

/// The distance from one triangle is convex, so if the corners of a piece lie within d of the *same* triangle, all of the
/// piece does. That, for the triangles nearest to its corners, is the piece's upper bound; where it says too little, the
/// piece is cut in two. All faces count, degenerate ones, too.
///
/// The bounds hold in spite of rounding: a point computed on a triangle is off by some units in the last place of the
/// coordinates, however thin the triangle is, and so is the middle of an edge. `slack` covers that.
class PieceSearch {
 public:
  /// Builds search trees over both.
  /// \param threads  0: all cores; the result is the same for every number.
  /// \throw InvalidMesh  one of the meshes has no face, or a coordinate that is not finite.
  /// \throw Cancelled
  PieceSearch(const IndexedMesh& original, const IndexedMesh& simplified, unsigned threads,
              const Monitor& monitor);
  PieceSearch(const PieceSearch&) = delete;
  PieceSearch& operator=(const PieceSearch&) = delete;
  ~PieceSearch();

  /// What is to become of a piece.
  enum class Fate { done, cut };

  /// Looks at every face, then at the parts of those that are cut. `decide(piece)` is called with each piece, in an order
  /// that does not depend on the threads, always from the calling thread.
  /// \throw Cancelled
  void run(const std::function<Fate(const Piece&)>& decide);

  std::size_t pieces() const { return pieces_; }  ///< looked at so far

  /// What the coordinates of the pieces and all distances are to be multiplied with: a power of two.
  double unit() const { return unit_; }
  /// Bounds on what rounding does: `upper` has it already, a distance at a corner may be so much too large.
  double slack() const { return slack_; }

 private:
  struct Side;

  std::vector<Piece> faces_of(bool of_original);
  std::array<Piece, 2> halves(const Piece& piece) const;
  void bound(Piece& piece) const;
  const Side& other_side(bool of_original) const { return of_original ? *simplified_ : *original_; }

  double unit_ = 1, slack_ = 0;
  std::size_t pieces_ = 0;
  unsigned threads_;
  Watch watch_;
  std::unique_ptr<const Side> original_, simplified_;
};

}  // namespace whittle::measure
