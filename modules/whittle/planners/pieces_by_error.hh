/// \file
/// Pieces that cost less than what else would have to go.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/mq/Run.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/FlipGuard.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/pieces.hh"

namespace whittle {
namespace detail {

/// For each piece whether it has a vertex that the user holds: locked, a feature, or of tolerance 0.
inline std::vector<bool> held_pieces(const Pieces& pieces, const SurfaceExtras& extras) {
  std::vector<bool> held(pieces.count(), false);
  for (std::size_t v = 0; v < pieces.of_vertex.size(); ++v) {
    const bool is_held = (v < extras.flags.size() && (extras.flags[v] & (kLocked | kFeature)) != 0) ||
                         (v < extras.tolerance.size() && extras.tolerance[v] == 0);
    if (is_held && pieces.of_vertex[v] != Pieces::kNone) held[pieces.of_vertex[v]] = true;
  }
  return held;
}

/// For each piece twice the integral over it of the squared distance from its centroid: what it costs to merge it into
/// a point, as mq counts, whose quadrics weigh a face by twice its area. Lengths count in units of `scale`.
template <typename Real>
std::vector<double> piece_costs(const IndexedMeshT<Real>& mesh, const Pieces& pieces, double scale) {
  struct Sums {
    Eigen::Vector3d first = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
    double area = 0, square = 0;
    bool has_first = false;
  };
  std::vector<Sums> sums(pieces.count());
  for (const auto& t : mesh.triangles) {
    Sums& sum = sums[pieces.of_vertex[t[0]]];
    if (!std::exchange(sum.has_first, true)) sum.first = mesh.points[t[0]].template cast<double>();
    const auto place = [&](std::size_t k) {
      return Eigen::Vector3d((mesh.points[t[k]].template cast<double>() - sum.first) / scale);
    };
    const Eigen::Vector3d a = place(0), b = place(1), c = place(2), middle = (a + b + c) / 3;
    const double area = (b - a).cross(c - a).norm() / 2;
    sum.area += area;
    sum.moment += area * middle;
    sum.square +=
        area / 12 * (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + 9 * middle.squaredNorm());
  }
  std::vector<double> costs;
  costs.reserve(sums.size());
  for (const Sums& sum : sums)
    costs.push_back(sum.area > 0 ? 2 * std::max(0.0, sum.square - sum.moment.squaredNorm() / sum.area) : 0);
  return costs;
}

}  // namespace detail

/// Chooses the pieces that vanish as a whole on the way to a target: in order of the error, a piece goes where that
/// costs less than the next collapse elsewhere, and at the end where nothing else is left. A piece with a held vertex
/// stays, and so does the dearest.
///
/// A collapse costs what mq's quadrics say, an integral of squared distances; a piece the same integral of its
/// distances from its centroid.
/// \param n_threads  the choice is the same for any number
/// \return for each piece whether it goes
/// \throw InvalidMesh, InvalidParameter  as the constructor of SurfaceT.
template <typename Real>
std::vector<bool> pieces_by_error(const IndexedMeshT<Real>& mesh, const Pieces& pieces, SurfaceExtras extras,
                                  const TargetCount& target, std::size_t n_threads) {
  const std::size_t n = pieces.count();
  std::vector<bool> goes(n, false);
  if (n < 2) return goes;
  extras = detail::checked(mesh, std::move(extras));
  mq::Run run(mesh, extras, {static_cast<float>(FlipGuard().min_cos), 180, HUGE_VAL}, n_threads);
  std::vector<float> collapse_costs;
  run.run(0, 0, &collapse_costs);
  const CollapsePlan plan = run.take();
  std::vector<double> costs = detail::piece_costs(mesh, pieces, run.scale());
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto p, auto q) { return costs[p] < costs[q]; });

  std::vector<bool> stays = detail::held_pieces(pieces, extras);
  stays[order.back()] = true;

  std::vector<std::size_t> faces = pieces.faces, vertices = pieces.vertices;
  std::size_t n_faces = mesh.triangles.size(), n_vertices = mesh.points.size();
  auto next = order.begin();
  const auto is_met = [&] { return target.is_met(n_faces, n_vertices); };
  const auto drop_below = [&](double cost) {
    for (; next != order.end() && costs[*next] < cost && !is_met(); ++next) {
      if (stays[*next]) continue;
      goes[*next] = true;
      n_faces -= faces[*next];
      n_vertices -= vertices[*next];
    }
  };
  for (std::size_t i = 0; i < plan.collapses.size() && !is_met(); ++i) {
    drop_below(static_cast<double>(collapse_costs[i]));
    const Collapse& collapse = plan.collapses[i];
    const std::uint32_t p = pieces.of_vertex[collapse.to];
    if (goes[p]) continue;
    faces[p] -= collapse.faces;
    n_faces -= collapse.faces;
    --vertices[p];
    --n_vertices;
  }
  drop_below(std::numeric_limits<double>::infinity());
  return goes;
}

#ifdef WHITTLE_COMPILED
extern template std::vector<bool> pieces_by_error(const IndexedMeshT<float>&, const Pieces&, SurfaceExtras,
                                                  const TargetCount&, std::size_t);
extern template std::vector<bool> pieces_by_error(const IndexedMeshT<double>&, const Pieces&, SurfaceExtras,
                                                  const TargetCount&, std::size_t);
#endif

}  // namespace whittle
