/// \file
/// Geometry of one triangle, in double precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

#include "whittle/IndexedMesh.hh"

namespace whittle::measure {

/// The corners of a face.
struct Corners {
  Eigen::Vector3d a, b, c;

  /// Normal whose length is twice the area.
  Eigen::Vector3d normal() const { return (b - a).cross(c - a); }
  double area() const { return 0.5 * normal().norm(); }

  /// Area of at most 1e-12 of the longest edge squared: its normal is mostly rounding error. True for NaN.
  bool degenerate() const {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !(area() > 1e-12 * longest);
  }
};

inline Corners corners(const IndexedMesh& mesh, const IndexedMesh::Triangle& triangle) {
  return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

/// The point of a triangle closest to `p`: finds the Voronoi region of the triangle (a corner, an edge or the
/// inside) that `p` lies in, as in Ericson, Real-Time Collision Detection, 5.1.5.
inline Eigen::Vector3d closest_point(const Eigen::Vector3d& p, const Corners& t) {
  const Eigen::Vector3d ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double ab_ap = ab.dot(ap), ac_ap = ac.dot(ap);
  if (ab_ap <= 0 && ac_ap <= 0) return t.a;

  const Eigen::Vector3d bp = p - t.b;
  const double ab_bp = ab.dot(bp), ac_bp = ac.dot(bp);
  if (ab_bp >= 0 && ac_bp <= ab_bp) return t.b;

  const double weight_c = ab_ap * ac_bp - ab_bp * ac_ap;
  if (weight_c <= 0 && ab_ap >= 0 && ab_bp <= 0) return t.a + ab * (ab_ap / (ab_ap - ab_bp));

  const Eigen::Vector3d cp = p - t.c;
  const double ab_cp = ab.dot(cp), ac_cp = ac.dot(cp);
  if (ac_cp >= 0 && ab_cp <= ac_cp) return t.c;

  const double weight_b = ab_cp * ac_ap - ab_ap * ac_cp;
  if (weight_b <= 0 && ac_ap >= 0 && ac_cp <= 0) return t.a + ac * (ac_ap / (ac_ap - ac_cp));

  const double weight_a = ab_bp * ac_cp - ab_cp * ac_bp;
  const double along_b = ac_bp - ab_bp, along_c = ab_cp - ac_cp;
  if (weight_a <= 0 && along_b >= 0 && along_c >= 0) {
    return t.b + (t.c - t.b) * (along_b / (along_b + along_c));
  }
  const double sum = weight_a + weight_b + weight_c;
  return t.a + ab * (weight_b / sum) + ac * (weight_c / sum);
}

}  // namespace whittle::measure
