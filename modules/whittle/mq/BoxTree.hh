/// \file
/// The nearest of many points or triangles.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "whittle/mq/Vertex.hh"

namespace whittle::mq {

/// Boxes around runs of items, and boxes around two of those each, up to one around all. It finds the nearest item fast
/// where items that follow one another are near one another, as the faces around a vertex are.
class BoxTree {
 public:
  struct Box {
    Vec low = Vec::Constant(std::numeric_limits<float>::infinity()),
        high = Vec::Constant(-std::numeric_limits<float>::infinity());
    void add(const Vec& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  };
  struct Found {
    std::size_t item;
    float square;  ///< of the distance; infinite where there are no items
  };

  /// \param add  `add(i, box)` puts item i into a box.
  template <typename Add>
  BoxTree(std::size_t n, Add add);

  /// \param square_of  the square of the distance of an item from `p`
  /// \return of several that are equally near, the first one.
  template <typename SquareOf>
  Found nearest(const Vec& p, SquareOf square_of) const {
    Found best{n_, std::numeric_limits<float>::infinity()};
    search(1, p, square_of, best);
    return best;
  }

 private:
  static constexpr std::size_t kRun = 8;          // items
  static constexpr float kAllowance = 1 - 1e-5f;  // for the rounding of distances

  float square(std::size_t node, const Vec& p) const {
    const Box& box = boxes_[node];
    return kAllowance * (box.low - p).cwiseMax(p - box.high).cwiseMax(0).squaredNorm();
  }
  template <typename SquareOf>
  void search(std::size_t node, const Vec& p, SquareOf& square_of, Found& best) const;

  std::size_t n_, n_runs_ = 1;
  std::vector<Box> boxes_;  // the children of i are 2 i and 2 i + 1; the runs are the last ones
};

template <typename Add>
BoxTree::BoxTree(std::size_t n, Add add) : n_(n) {
  while (kRun * n_runs_ < n) n_runs_ *= 2;
  boxes_.resize(2 * n_runs_);
  for (std::size_t i = 0; i < n; ++i) add(i, boxes_[n_runs_ + i / kRun]);
  for (std::size_t node = n_runs_ - 1; node > 0; --node)
    for (const Box& child : {boxes_[2 * node], boxes_[2 * node + 1]}) {
      boxes_[node].low = boxes_[node].low.cwiseMin(child.low);
      boxes_[node].high = boxes_[node].high.cwiseMax(child.high);
    }
}

template <typename SquareOf>
void BoxTree::search(std::size_t node, const Vec& p, SquareOf& square_of, Found& best) const {
  if (node >= n_runs_) {
    const std::size_t first = kRun * (node - n_runs_);
    for (std::size_t i = first; i < std::min(first + kRun, n_); ++i) {
      const float square = square_of(i);
      if (square < best.square || (square == best.square && i < best.item)) best = {i, square};
    }
    return;
  }
  std::array<std::size_t, 2> child{2 * node, 2 * node + 1};
  std::array<float, 2> away{square(child[0], p), square(child[1], p)};
  if (away[1] < away[0]) {
    std::swap(child[0], child[1]);
    std::swap(away[0], away[1]);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (away[k] <= best.square) search(child[k], p, square_of, best);
}

}  // namespace whittle::mq
