/// \file
/// FAD, face angle dependency: vertices whose faces lie nearly in a plane are removed.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/plan/PlanDraft.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/constants.hh"
#include "whittle/surface/errors.hh"
#include "whittle/surface/triangle.hh"

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
    delaunay,  ///< at the ring vertex with the best worst triangle (Paper 1); of more than 256 neighbours
               ///< the best of 256 that are spread evenly
    lexicographic,  ///< at the ring vertex with the largest x, then y, then z (Paper 2)
  };
  static constexpr int kAllAngles = 0;

  double max_normal_angle = 30;  ///< degrees, in [0, 180]. The included angle of Paper 2 is 180 minus this.
  Pairs pairs = Pairs::adjacent;
  int count = kAllAngles;      ///< how many angles must qualify, at least 1; `kAllAngles`: every one
  double max_area = HUGE_VAL;  ///< largest area of the vertex's faces together, in square model units, > 0
  Lock lock = Lock::ring;
  Apex apex = Apex::delaunay;
  /// With `merge`, a boundary vertex goes, too, if moreover the boundary turns there by at most the
  /// threshold; the fan then starts at one of its neighbours along the boundary.
  Boundary boundary = Boundary::keep;
  /// With `merge`, a vertex on a seam goes, too, if moreover the seam turns there by at most the threshold; the fan
  /// then starts at one of its neighbours along the seam.
  Seams seams = Seams::keep;
  FlipGuard guard;

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const;

  bool moves_seams() const { return seams == Seams::merge; }

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
  /// A vertex and its ring as points, and the normals between them; kept from one vertex to the next.
  struct Umbrella {
    std::uint32_t vertex;
    bool is_closed;
    /// Where in the ring the line goes on that the vertex is on, the boundary or a seam; both 0 where it is on none.
    std::array<std::size_t, 2> line;
    Eigen::Vector3d center;
    std::vector<Eigen::Vector3d> spokes;  ///< from the centre to the ring
    std::vector<Eigen::Vector3d> normals;
    std::vector<double> squared_areas;  ///< of the normals, four times

    template <typename Real>
    void open(const SurfaceT<Real>& surface, std::uint32_t v);
    bool is_on_line() const { return line[0] != line[1]; }
    double worst_triangle(std::size_t from) const;
    /// Whether every two normals are sure to be within an angle, as all are within half of it of their mean.
    bool lies_within(double min_cos) const;
  };
  static constexpr std::size_t kMany = 64;         // faces, of which a vertex with more is a hub
  static constexpr std::size_t kMostApexes = 256;  // that are rated
  using RatedApex = std::pair<double, std::uint32_t>;

  /// Of an angle in degrees. Rounding may take the cosine of two equal normals a few ulps below 1, hence the
  /// allowance.
  static double cosine(double degrees) {
    return std::cos(std::min(180.0, degrees) * (detail::kPi / 180)) - 1e-12;
  }

  bool is_flat(const Umbrella& umbrella, double min_cos) const;

  template <typename Real>
  void order_apexes(const SurfaceT<Real>& surface, const Umbrella& umbrella,
                    std::vector<RatedApex>& apexes) const;
};

inline void FaceAngle::validate() const {
  if (!(max_normal_angle >= 0 && max_normal_angle <= 180))
    throw InvalidParameter("FaceAngle: the angle must be between 0 and 180 degrees");
  if (count < 0) throw InvalidParameter("FaceAngle: the count of angles must be at least 1");
  if (!(max_area > 0)) throw InvalidParameter("FaceAngle: the area must be positive");
  guard.validate();
}

template <typename Real>
void FaceAngle::Umbrella::open(const SurfaceT<Real>& surface, std::uint32_t v) {
  const Ring ring = surface.ring(v);
  vertex = v;
  is_closed = ring.is_closed();
  center = surface.point(v);
  spokes.clear();
  normals.clear();
  squared_areas.clear();
  for (const std::uint32_t w : ring) spokes.push_back(surface.point(w) - center);
  const std::size_t n = spokes.size();
  line = {0, is_closed ? 0 : n - 1};
  if (surface.is_on_seam(v)) {
    const auto ends = surface.seams().neighbours(v);
    for (std::size_t i = 0; i < 2; ++i)
      line[i] = static_cast<std::size_t>(std::find(ring.begin(), ring.end(), ends[i]) - ring.begin());
  }
  for (std::size_t i = 0; i < ring.n_faces(); ++i) {
    normals.push_back(spokes[i].cross(spokes[i + 1 < n ? i + 1 : 0]));
    squared_areas.push_back(normals.back().squaredNorm());
  }
}

inline bool FaceAngle::is_flat(const Umbrella& umbrella, double min_cos) const {
  const auto &spokes = umbrella.spokes, &normals = umbrella.normals;
  const auto& squared_areas = umbrella.squared_areas;
  const bool is_closed = umbrella.is_closed;
  double area = 0;
  for (const double squared : squared_areas) {
    if (!(squared > 0)) return false;  // a degenerate face has no angle to its neighbours
    if (max_area < HUGE_VAL) area += std::sqrt(squared) / 2;
  }
  if (area > max_area) return false;

  const double limit = min_cos * std::abs(min_cos);
  const std::size_t n = normals.size();
  const auto is_within = [&](std::size_t i, std::size_t j) {
    const double cosine = normals[i].dot(normals[j]);
    return cosine * std::abs(cosine) >= limit * squared_areas[i] * squared_areas[j];
  };
  const bool is_every = count == kAllAngles;
  std::size_t within = 0, angles = 0;
  const bool is_done = is_every && n > kMany && pairs == Pairs::all && umbrella.lies_within(min_cos);
  for (std::size_t i = 0; i < n && !is_done; ++i) {
    const std::size_t last = pairs == Pairs::all ? n - 1 : std::min(i + 1, n - 1);
    for (std::size_t j = i + 1; j <= last; ++j, ++angles) {
      within += is_within(i, j);
      if (is_every && within == angles) return false;
    }
  }
  if (pairs == Pairs::adjacent && is_closed) {
    within += is_within(n - 1, 0);
    ++angles;
  }
  if (umbrella.is_on_line() &&
      (-spokes[umbrella.line[0]]).normalized().dot(spokes[umbrella.line[1]].normalized()) < min_cos)
    return false;
  return is_every ? within == angles : within >= static_cast<std::size_t>(count);
}

inline bool FaceAngle::Umbrella::lies_within(double min_cos) const {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < normals.size(); ++i) mean += normals[i] / std::sqrt(squared_areas[i]);
  mean.normalize();
  double least = 1;
  for (std::size_t i = 0; i < normals.size(); ++i)
    least = std::min(least, normals[i].dot(mean) / std::sqrt(squared_areas[i]));
  constexpr double kRounding = 1e-9;
  return least > 0 && 2 * least * least - 1 > min_cos + kRounding;  // the cosine of twice the largest angle
}

/// A measure of the worst triangle of the fan from a place in the ring: the square of `triangle_quality`, but
/// for a factor.
inline double FaceAngle::Umbrella::worst_triangle(std::size_t from) const {
  const std::size_t n = spokes.size();
  double worst = HUGE_VAL;
  const auto after = [&](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  std::size_t left = after(from);
  Eigen::Vector3d to_left = spokes[left] - spokes[from];
  for (std::size_t right = after(left); right != from; left = right, right = after(right)) {
    const Eigen::Vector3d to_right = spokes[right] - spokes[from];
    const double squares =
        to_left.squaredNorm() + to_right.squaredNorm() + (spokes[right] - spokes[left]).squaredNorm();
    const double quality = squares > 0 ? to_left.cross(to_right).squaredNorm() / (squares * squares) : 0;
    worst = std::min(worst, quality);
    to_left = to_right;
  }
  return worst;
}

/// Orders the places in the ring where the fan may start, best first.
template <typename Real>
void FaceAngle::order_apexes(const SurfaceT<Real>& surface, const Umbrella& umbrella,
                             std::vector<RatedApex>& apexes) const {
  apexes.clear();
  const std::size_t n = umbrella.spokes.size();
  const Ring ring = surface.ring(umbrella.vertex);
  const auto rate = [&](std::size_t i) {
    apexes.emplace_back(apex == Apex::delaunay ? umbrella.worst_triangle(i) : 0, ring[i]);
  };
  if (umbrella.is_on_line()) {  // the fan starts where the line goes on
    rate(umbrella.line[0]);
    rate(umbrella.line[1]);
  } else if (apex == Apex::delaunay && n > kMostApexes) {  // to rate all of them takes a time in n squared
    for (std::size_t i = 0; i < kMostApexes; ++i) rate(i * n / kMostApexes);
  } else {
    for (std::size_t i = 0; i < n; ++i) rate(i);
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
  std::vector<std::uint8_t> kept(surface.n_vertices(), false);
  Umbrella umbrella;
  std::vector<RatedApex> apexes;
  using Verdict = typename PlanDraftT<Real>::Verdict;
  const auto is_kept = [&](std::uint32_t w) { return kept[w] != 0; };
  const double min_cos = cosine(max_normal_angle);

  for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
    if (kept[v] || !surface.is_free(v, boundary, seams)) continue;
    const Ring ring = surface.ring(v);
    if (lock == Lock::strict && std::any_of(ring.begin(), ring.end(), is_kept)) continue;
    umbrella.open(surface, v);
    const double tolerance = surface.tolerance(v);
    if (!is_flat(umbrella, tolerance == 1 ? min_cos : cosine(max_normal_angle * tolerance))) continue;

    order_apexes(surface, umbrella, apexes);
    if (surface.is_on_seam(v))
      apexes.erase(
          std::remove_if(apexes.begin(), apexes.end(),
                         [&](const RatedApex& a) { return !surface.seams().may_remove(v, a.second); }),
          apexes.end());
    if (apexes.empty()) continue;
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
    for (const std::uint32_t w : ring) kept[w] = true;
  }
  return draft.take();
}

}  // namespace whittle
