/// \file
/// FAD, face angle dependency: vertices whose faces lie nearly in a plane are removed.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/PlanDraft.hh"
#include "whittle/Surface.hh"
#include "whittle/errors.hh"
#include "whittle/triangle.hh"

namespace whittle {

/// Planner of FAD (Paper 1, III.II; Paper 2, whole).
///
/// Vertices are scanned in index order. An interior vertex goes if the angles between the normals of its
/// faces are at most `max_normal_angle`; its hole is closed by a fan from one vertex of its ring, which is a
/// half-edge collapse to that vertex, so no vertex moves. Angles are those of the mesh that the pass begins
/// with, and a removed vertex keeps its ring for the pass (*ring lock*): judged anew after every removal, the
/// mesh would erode to nothing, each step below the threshold. Several passes do erode it, step by step, as
/// far as they are asked to.
struct FaceAngle {
  /// Which pairs of faces around the vertex are compared.
  enum class Pairs {
    adjacent,  ///< the two faces of each edge at the vertex (Paper 1)
    all        ///< every two faces at the vertex (Paper 2, "all the included angles")
  };
  /// What a removal keeps in place for the rest of the pass.
  enum class Lock {
    ring,   ///< the vertices of its ring may not be removed
    strict  ///< nor may any vertex whose ring touches that ring
  };
  /// Where the fan that closes the hole starts.
  enum class Apex {
    delaunay,       ///< at the ring vertex with the best worst triangle (Paper 1)
    lexicographic,  ///< at the ring vertex with the largest x, then y, then z (Paper 2)
  };
  static constexpr int kAllAngles = 0;
  static constexpr double kPi = 3.14159265358979323846;

  double max_normal_angle = 30;  ///< degrees, in [0, 180]. The included angle of Paper 2 is 180 minus this.
  Pairs pairs = Pairs::adjacent;
  int count = kAllAngles;      ///< how many angles must qualify, at least 1; `kAllAngles`: every one
  double max_area = HUGE_VAL;  ///< largest area of the vertex's faces together, in square model units, > 0
  Lock lock = Lock::ring;
  Apex apex = Apex::delaunay;
  /// With `merge`, a boundary vertex goes, too, if moreover the boundary turns there by at most the
  /// threshold; the fan then starts at one of its neighbours along the boundary.
  Boundary boundary = Boundary::keep;
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  FaceAngle scaled(double factor) const {
    FaceAngle planner = *this;
    planner.max_normal_angle *= factor;
    return planner;
  }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const;

 private:
  template <typename Real>
  bool is_flat(const SurfaceT<Real>& surface, std::uint32_t v, const Ring& ring,
               std::vector<Eigen::Vector3d>& normals) const;

  template <typename Real>
  void order_apexes(const SurfaceT<Real>& surface, const Ring& ring,
                    std::vector<std::pair<double, std::uint32_t>>& apexes) const;
};

inline void FaceAngle::validate() const {
  if (!(max_normal_angle >= 0 && max_normal_angle <= 180))
    throw InvalidParameter("FaceAngle: the angle must be between 0 and 180 degrees");
  if (count < 0) throw InvalidParameter("FaceAngle: the count of angles must be at least 1");
  if (!(max_area > 0)) throw InvalidParameter("FaceAngle: the area must be positive");
  guard.validate();
}

template <typename Real>
bool FaceAngle::is_flat(const SurfaceT<Real>& surface, std::uint32_t v, const Ring& ring,
                        std::vector<Eigen::Vector3d>& normals) const {
  normals.clear();
  double area = 0;
  for (const std::uint32_t f : ring.faces) {
    const Eigen::Vector3d n = surface.normal(f);
    const double length = n.norm();
    if (!(length > 0)) return false;  // a degenerate face has no angle to its neighbours
    area += length / 2;
    normals.push_back(n / length);
  }
  if (area > max_area) return false;

  // Rounding may take the cosine of two equal unit normals a few ulps below 1, hence the allowance.
  const double angle = std::min(180.0, max_normal_angle * surface.tolerance(v));
  const double min_cos = std::cos(angle * (kPi / 180)) - 1e-12;
  const bool closed = ring.shape == Ring::Shape::closed;
  const std::size_t n = normals.size();
  int within = 0, angles = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t last = pairs == Pairs::all ? n - 1 : std::min(i + 1, n - 1);
    for (std::size_t j = i + 1; j <= last; ++j, ++angles) within += normals[i].dot(normals[j]) >= min_cos;
  }
  if (pairs == Pairs::adjacent && closed) {
    within += normals[n - 1].dot(normals[0]) >= min_cos;
    ++angles;
  }
  if (!closed) {
    const Eigen::Vector3d in = (surface.point(v) - surface.point(ring.vertices.front())).normalized();
    const Eigen::Vector3d out = (surface.point(ring.vertices.back()) - surface.point(v)).normalized();
    if (in.dot(out) < min_cos) return false;
  }
  return count == kAllAngles ? within == angles : within >= count;
}

template <typename Real>
void FaceAngle::order_apexes(const SurfaceT<Real>& surface, const Ring& ring,
                             std::vector<std::pair<double, std::uint32_t>>& apexes) const {
  apexes.clear();
  const std::size_t n = ring.vertices.size();
  for (std::size_t a = 0; a < n; ++a) {
    double worst = HUGE_VAL;
    const Eigen::Vector3d p = surface.point(ring.vertices[a]);
    for (std::size_t i = 1; i + 1 < n; ++i)  // the fan; of an open ring, only its ends have one
      worst = std::min(worst, triangle_quality(p, surface.point(ring.vertices[(a + i) % n]),
                                               surface.point(ring.vertices[(a + i + 1) % n])));
    if (ring.shape == Ring::Shape::closed || a == 0 || a == n - 1)
      apexes.emplace_back(worst, ring.vertices[a]);
  }
  std::sort(apexes.begin(), apexes.end(), [&](const auto& l, const auto& r) {
    if (apex == Apex::delaunay) return l.first != r.first ? l.first > r.first : l.second < r.second;
    const Eigen::Vector3d p = surface.point(l.second), q = surface.point(r.second);
    return std::lexicographical_compare(q.begin(), q.end(), p.begin(), p.end());
  });
}

template <typename Real>
CollapsePlan FaceAngle::plan(const SurfaceT<Real>& surface) const {
  validate();
  PlanDraftT<Real> draft(surface, guard);
  RingWalk<Real> walk(surface);
  std::vector<bool> kept(surface.n_vertices(), false);
  std::vector<Eigen::Vector3d> normals;
  std::vector<std::pair<double, std::uint32_t>> apexes;
  using Verdict = typename PlanDraftT<Real>::Verdict;

  for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
    if (kept[v] || !surface.is_free(v, boundary)) continue;
    const Ring& ring = walk.around(v);
    if (lock == Lock::strict &&
        std::any_of(ring.vertices.begin(), ring.vertices.end(), [&](std::uint32_t w) { return kept[w]; }))
      continue;
    if (!is_flat(surface, v, ring, normals)) continue;

    order_apexes(surface, ring, apexes);
    Verdict verdict = Verdict::refused_by_link, first_verdict = verdict;
    for (std::size_t i = 0; i < apexes.size() && verdict != Verdict::accepted; ++i) {
      const std::uint32_t to = apexes[i].second;
      verdict = draft.merge({to, v}, surface.point(to));
      if (i == 0) first_verdict = verdict;
    }
    if (verdict != Verdict::accepted) {
      draft.count_refusal(first_verdict);
      continue;
    }
    if (first_verdict != Verdict::accepted) draft.count_fallback();
    for (const std::uint32_t w : ring.vertices) kept[w] = true;
  }
  return draft.take();
}

}  // namespace whittle
