/// \file
/// What a polygon of many corners is cut with: which points lie in a triangle, which corners are to be looked at, and
/// whether sides cross, each without going through all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace whittle::files {

/// A point of the plane.
struct PlanePoint {
  double x, y;
};

/// Twice the area of a triangle; positive: counterclockwise.
inline double doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Points of which some go, in a tree of boxes.
class PointTree {
 public:
  /// \param points  numbers of places, at most 2 in size
  void build(const std::vector<PlanePoint>& at, std::vector<std::uint32_t>& points) {
    at_ = &at;
    points_.swap(points);
    nodes_.clear();
    leaf_of_.assign(at.size(), none);
    if (!points_.empty()) add(0, static_cast<std::uint32_t>(points_.size()), none);
  }

  /// Nothing where it was none of them.
  void remove(std::uint32_t point) {
    for (std::uint32_t node = leaf_of_[point]; node != none; node = nodes_[node].parent) --nodes_[node].left;
    leaf_of_[point] = none;
  }

  bool has(std::uint32_t point) const { return leaf_of_[point] != none; }

  /// Whether `test` holds for one of those left that lie in a triangle or on its sides. It is called for some around, too.
  /// \param looks  grows by what was looked at
  template <typename Test>
  bool any(const std::array<PlanePoint, 3>& triangle, std::size_t& looks, Test test) const {
    if (nodes_.empty()) return false;
    std::array<std::uint32_t, 2 * kDeepest> waiting{};
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      ++looks;
      if (node.left == 0 || is_apart(node, triangle)) continue;
      if (node.second != none) {
        waiting[count++] = node.second;
        waiting[count++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        ++looks;
        if (has(points_[i]) && test(points_[i])) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1), kLeaf = 8;
  static constexpr std::size_t kDeepest = 40;  // halves of 32-bit numbers

  struct Node {
    double low[2], high[2];
    std::uint32_t begin, end, left, parent, first, second;
  };

  std::uint32_t add(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    Node node{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, begin, end, end - begin, parent, none, none};
    for (std::uint32_t i = begin; i < end; ++i) {
      const PlanePoint& p = (*at_)[points_[i]];
      node.low[0] = std::min(node.low[0], p.x);
      node.low[1] = std::min(node.low[1], p.y);
      node.high[0] = std::max(node.high[0], p.x);
      node.high[1] = std::max(node.high[1], p.y);
    }
    nodes_.push_back(node);
    if (end - begin <= kLeaf) {
      for (std::uint32_t i = begin; i < end; ++i) leaf_of_[points_[i]] = number;
      return number;
    }
    const bool by_x = node.high[0] - node.low[0] > node.high[1] - node.low[1];
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t k) {
                       const PlanePoint &p = (*at_)[i], &q = (*at_)[k];
                       return by_x ? p.x < q.x : p.y < q.y;
                     });
    const std::uint32_t first = add(begin, middle, number), second = add(middle, end, number);
    nodes_[number].first = first;
    nodes_[number].second = second;
    return number;
  }

  /// Whether a box lies outside of a side of a triangle that turns left, by more than rounding.
  static bool is_apart(const Node& box, const std::array<PlanePoint, 3>& triangle) {
    constexpr double rounding = 1e-12;
    for (std::size_t k = 0; k < 3; ++k) {
      const PlanePoint &a = triangle[k], &b = triangle[(k + 1) % 3];
      const PlanePoint corner{b.y > a.y ? box.low[0] : box.high[0], b.x > a.x ? box.high[1] : box.low[1]};
      if (doubled_area(a, b, corner) < -rounding) return true;
    }
    return false;
  }

  const std::vector<PlanePoint>* at_ = nullptr;
  std::vector<std::uint32_t> points_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  ///< of those left
};

/// Numbers below a count, of which the next one in the round is found.
class NumberRing {
 public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  void clear(std::uint32_t count) {
    words_.assign(count / 64 + 1, 0);
    over_.assign(count / 4096 + 1, 0);
  }
  void insert(std::uint32_t i) {
    words_[i / 64] |= std::uint64_t{1} << i % 64;
    over_[i / 4096] |= std::uint64_t{1} << i / 64 % 64;
  }
  void erase(std::uint32_t i) {
    words_[i / 64] &= ~(std::uint64_t{1} << i % 64);
    if (words_[i / 64] == 0) over_[i / 4096] &= ~(std::uint64_t{1} << i / 64 % 64);
  }

  /// The least from `begin` on, else the least of all; none where there is none.
  std::uint32_t next(std::uint32_t begin) const {
    const std::uint32_t found = from(begin);
    return found == none && begin > 0 ? from(0) : found;
  }

 private:
  static std::uint64_t without_first(std::uint64_t bits, std::uint32_t count) {
    return bits >> count << count;
  }
  static std::uint32_t first_bit(std::uint64_t bits) {
    return static_cast<std::uint32_t>(__builtin_ctzll(bits));
  }

  std::uint32_t from(std::uint32_t begin) const {
    const std::uint32_t word = begin / 64;
    if (const std::uint64_t bits = without_first(words_[word], begin % 64); bits != 0)
      return 64 * word + first_bit(bits);
    for (std::uint32_t top = (word + 1) / 64; top < over_.size(); ++top) {
      const std::uint64_t bits =
          top == (word + 1) / 64 ? without_first(over_[top], (word + 1) % 64) : over_[top];
      if (bits == 0) continue;
      const std::uint32_t found = 64 * top + first_bit(bits);
      return 64 * found + first_bit(words_[found]);
    }
    return none;
  }

  std::vector<std::uint64_t> words_, over_;  // a bit each; a bit for each word that is not 0
};

/// Whether two sides of a polygon have a point in common that is inside of both: a sweep from left to right that compares
/// neighbours (Shamos and Hoey 1976).
bool any_sides_cross(const std::vector<PlanePoint>& at);

/// Whether two sides do, by more than rounding. They begin at a and c, and end at b and d.
inline bool sides_cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  constexpr double rounding = 1e-12;
  const auto apart = [](double left, double right) {
    return (left > rounding && right < -rounding) || (left < -rounding && right > rounding);
  };
  return apart(doubled_area(a, b, c), doubled_area(a, b, d)) &&
         apart(doubled_area(c, d, a), doubled_area(c, d, b));
}

}  // namespace whittle::files
