/// \file
/// Whether two faces intersect, decided exactly.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "whittle/surface/orientation.hh"

/// Triangles are closed: to touch at a point is to meet. What two faces share, a vertex or an edge by its indices, is no
/// meeting; any other point of both is. So two vertices at one place do meet. A face without area, whose corners lie exactly
/// on a line, has no inside that something could run into, and meets nothing.
namespace whittle::detail {

/// The corners of a triangle.
using Corners3 = std::array<Eigen::Vector3d, 3>;

namespace meeting {

using Corners2 = std::array<Eigen::Vector2d, 3>;
using Signs = std::array<int, 3>;

inline std::size_t following(std::size_t i) {
  return i == 2 ? 0 : i + 1;
}

/// Without one coordinate.
inline Eigen::Vector2d flat(const Eigen::Vector3d& p, std::size_t axis) {
  const auto k = static_cast<Eigen::Index>(axis);
  return {p[(k + 1) % 3], p[(k + 2) % 3]};
}
inline Corners2 flat(const Corners3& t, std::size_t axis) {
  return {flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)};
}

/// An axis along which the triangle has an area; 3 if there is none, as it has no area at all.
inline std::size_t axis_of(const Corners3& t) {
  std::size_t axis = 0;
  while (axis < 3) {
    const Corners2 seen = flat(t, axis);
    if (orient2d(seen[0], seen[1], seen[2]) != 0) break;
    ++axis;
  }
  return axis;
}

/// On which side of the plane of a triangle the corners of another lie.
inline Signs sides(const Corners3& plane, const Corners3& of) {
  return {orient3d(plane[0], plane[1], plane[2], of[0]), orient3d(plane[0], plane[1], plane[2], of[1]),
          orient3d(plane[0], plane[1], plane[2], of[2])};
}
inline bool are_all(const Signs& signs, int sign) {
  return signs[0] == sign && signs[1] == sign && signs[2] == sign;
}

inline bool lies_in(const Corners2& t, const Eigen::Vector2d& p) {
  const Signs turns{orient2d(t[0], t[1], p), orient2d(t[1], t[2], p), orient2d(t[2], t[0], p)};
  const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
  return *least >= 0 || *most <= 0;
}

/// Whether two segments pq and ab in a plane have a point in common.
inline bool segments_meet(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b) {
  const int at_a = orient2d(p, q, a), at_b = orient2d(p, q, b), at_p = orient2d(a, b, p),
            at_q = orient2d(a, b, q);
  if (at_a * at_b > 0 || at_p * at_q > 0) return false;
  if (at_a != 0 || at_b != 0 || at_p != 0 || at_q != 0) return true;
  return (p.cwiseMax(q).array() >= a.cwiseMin(b).array()).all() &&
         (a.cwiseMax(b).array() >= p.cwiseMin(q).array()).all();
}

/// Whether the edge of `t` from its corner k has a point in common with `s`, in a plane.
inline bool edge_meets(const Corners2& s, const Corners2& t, std::size_t k) {
  const Eigen::Vector2d &p = t[k], &q = t[following(k)];
  return lies_in(s, p) || lies_in(s, q) || segments_meet(p, q, s[0], s[1]) ||
         segments_meet(p, q, s[1], s[2]) || segments_meet(p, q, s[2], s[0]);
}

/// How the edges of two triangles go around one another: the orientation of edge i of `s` with edge k of `t`, by need.
class EdgePairs {
 public:
  EdgePairs(const Corners3& s, const Corners3& t) : s_(s), t_(t) {}

  int operator()(std::size_t i, std::size_t k) {
    constexpr int kUnknown = 2;
    int& sign = signs_[3 * i + k];
    if (sign == kUnknown) sign = orient3d(s_[i], s_[following(i)], t_[k], t_[following(k)]);
    return sign;
  }

  /// Whether the edge of `t` from its corner k, whose ends are not both in the plane of `s`, goes through `s`.
  /// \param ends  on which sides of the plane of `s` the corners of `t` lie
  bool goes_through_s(std::size_t k, const Signs& ends) {
    return goes_through({ends[k], ends[following(k)]}, [&](std::size_t i) { return (*this)(i, k); });
  }
  bool goes_through_t(std::size_t i, const Signs& ends) {
    return goes_through({ends[i], ends[following(i)]}, [&](std::size_t k) { return (*this)(i, k); });
  }

 private:
  template <typename Around>
  static bool goes_through(const std::array<int, 2>& ends, Around around) {
    if (ends[0] == ends[1] || ends[0] * ends[1] > 0) return false;
    const Signs signs{around(0), around(1), around(2)};
    const auto [least, most] = std::minmax_element(signs.begin(), signs.end());
    return *least >= 0 || *most <= 0;
  }

  const Corners3 &s_, &t_;
  std::array<int, 9> signs_ = {2, 2, 2, 2, 2, 2, 2, 2, 2};
};

}  // namespace meeting

/// Whether the corners do not lie on a line, exactly.
inline bool has_area(const Corners3& t) {
  return meeting::axis_of(t) < 3;
}

/// Whether two triangles that share no vertex have a point in common. Where they do, an edge of one has a point of the other.
inline bool triangles_meet(const Corners3& s, const Corners3& t) {
  using namespace meeting;
  const Signs of_t = sides(s, t);
  if (are_all(of_t, 1) || are_all(of_t, -1)) return false;
  const Signs of_s = sides(t, s);
  if (are_all(of_s, 1) || are_all(of_s, -1)) return false;
  if (are_all(of_t, 0) || are_all(of_s, 0)) {
    const std::size_t axis = axis_of(s);
    if (axis == 3 || !has_area(t)) return false;
    const Corners2 flat_s = flat(s, axis), flat_t = flat(t, axis);
    if (lies_in(flat_t, flat_s[0])) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (edge_meets(flat_s, flat_t, k)) return true;
    return false;
  }
  // An edge in the other's plane meets it only if an edge beside it does, or one of the other's edges meets this one.
  EdgePairs pairs(s, t);
  for (std::size_t k = 0; k < 3; ++k)
    if (pairs.goes_through_s(k, of_t) || pairs.goes_through_t(k, of_s)) return true;
  return false;
}

/// Whether two triangles whose first corner is a vertex that they share have another point in common. Where they do, so have
/// all points on the way there from the vertex, and beyond it until one of the two ends, at the edge opposite the vertex.
inline bool triangles_meet_beyond_vertex(const Corners3& s, const Corners3& t) {
  using namespace meeting;
  constexpr std::size_t kOpposite = 1;  // the edge from this corner
  const auto side = [](const Corners3& plane, const Corners3& of) -> Signs {
    return {0, orient3d(plane[0], plane[1], plane[2], of[1]), orient3d(plane[0], plane[1], plane[2], of[2])};
  };
  const Signs of_t = side(s, t);
  if (of_t[1] * of_t[2] > 0) return false;
  const Signs of_s = side(t, s);
  if (of_s[1] * of_s[2] > 0) return false;
  if (are_all(of_t, 0) || are_all(of_s, 0)) {
    const std::size_t axis = axis_of(s);
    if (axis == 3 || !has_area(t)) return false;
    const Corners2 flat_s = flat(s, axis), flat_t = flat(t, axis);
    return edge_meets(flat_s, flat_t, kOpposite) || edge_meets(flat_t, flat_s, kOpposite);
  }
  EdgePairs pairs(s, t);
  return pairs.goes_through_s(kOpposite, of_t) || pairs.goes_through_t(kOpposite, of_s);
}

/// Whether two triangles with an edge in common, ab c and ab d, overlap: they lie in one plane on the same side of the edge.
inline bool triangles_overlap(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              const Eigen::Vector3d& d) {
  using namespace meeting;
  if (orient3d(a, b, c, d) != 0) return false;
  const std::size_t axis = axis_of({a, b, c});
  if (axis == 3) return false;
  const Eigen::Vector2d flat_a = flat(a, axis), flat_b = flat(b, axis);
  return orient2d(flat_a, flat_b, flat(c, axis)) == orient2d(flat_a, flat_b, flat(d, axis));
}

/// Whether two faces have a point in common that is in none of the vertices and edges that they share.
/// \param f,g    their vertices; a face with a vertex twice has no area
/// \param place  the place of a vertex, an Eigen::Vector3d
template <typename Place>
bool faces_intersect(const std::array<std::uint32_t, 3>& f, const std::array<std::uint32_t, 3>& g,
                     const Place& place) {
  using meeting::following;
  const auto twice = [](const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  };
  if (twice(f) || twice(g)) return false;
  std::array<std::size_t, 3> in_f{}, in_g{};  // the places of what they share
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (f[i] == g[k]) {
        in_f[shared] = i;
        in_g[shared++] = k;
      }
  const auto corners = [&](const std::array<std::uint32_t, 3>& t, std::size_t first) -> Corners3 {
    const std::size_t second = following(first);
    return {place(t[first]), place(t[second]), place(t[following(second)])};
  };
  switch (shared) {
    case 0:
      return triangles_meet(corners(f, 0), corners(g, 0));
    case 1:
      return triangles_meet_beyond_vertex(corners(f, in_f[0]), corners(g, in_g[0]));
    case 2:
      return triangles_overlap(place(f[in_f[0]]), place(f[in_f[1]]), place(f[3 - in_f[0] - in_f[1]]),
                               place(g[3 - in_g[0] - in_g[1]]));
    default:
      return has_area(corners(f, 0));
  }
}

}  // namespace whittle::detail
