/// \file
/// mq, memoryless quadrics: down to a number of faces, as close to the input as possible.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "whittle/mq/Run.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/PlanDraft.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// Planner of mq.
///
/// Edges collapse in order of the error that this adds, to the point with the least squared distance from the
/// planes of the faces around them, until `target_faces` are left. The planes are those of the current faces:
/// the quadrics have no memory (Lindstrom and Turk 1998), which ends closer to the input than accumulated
/// quadrics (Garland and Heckbert 1997). Relative to a vertex its planes pass through the origin, so a
/// quadric is just a symmetric matrix.
///
/// Vertices that are locked or features stay where they are; free ones may merge into them. The boundary is
/// held by planes of its own; its vertices may merge along it. So are seams, where the extras have wedges: their
/// vertices merge along them and inner ones into them, and a chart of one face may vanish. Without wedges
/// vertices with the flag kSeam stay where they are. A tolerance divides the error that
/// a collapse adds by its square; of both ends the lesser counts. Values in the extras (normals, colours,
/// texture coordinates) count beside the shape, for the place of a vertex and for the order. Computes in
/// float on a copy of unit size; the plan is the same for any number of threads.
struct MemorylessQuadric {
  std::size_t target_faces = 0;     ///< stop at so many faces or fewer; 0: go on until no collapse is legal
  std::size_t target_vertices = 0;  ///< or at so many vertices, isolated ones included
  /// Edges whose two faces' normals differ by more are held by planes of their own, as the boundary is: their
  /// vertices may merge along the line. Degrees, 0..180; 180: none
  double feature_angle = 180;
  /// The largest distance of each vertex of the input from the faces near it, and of the centres and corners
  /// of those from the input: collapses that would exceed it are refused, and others made instead. Points in
  /// between are not checked. A vertex's tolerance is a factor. Model units, not negative; HUGE_VAL: no bound
  double max_distance = HUGE_VAL;
  /// Whether each chart, what seams and the boundary enclose, keeps a face at least. Otherwise a chart may
  /// vanish, and its neighbours close over it
  bool keep_charts = false;
  FlipGuard guard;  ///< against the normal before each collapse; against that of the input no face may turn
                    ///< by 90 degrees

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const {
    guard.validate();
    if (!(feature_angle >= 0 && feature_angle <= 180))
      throw InvalidParameter("the feature angle must be in 0..180 degrees");
    if (!(max_distance >= 0)) throw InvalidParameter("the largest distance must not be negative");
  }

  /// Whether the parameters say where to stop. Otherwise the plan goes on until nothing is legal, which is what a
  /// progressive mesh wants; `bulk`, `decimate` and Whittle's drivers then ask for a target of their own.
  bool has_end() const { return target_faces > 0 || target_vertices > 0 || max_distance < HUGE_VAL; }

  /// Seams move, where the extras have wedges.
  bool moves_seams() const { return true; }

  /// The executors refit what comes of the plan to the input (`refit`), as far as there is no bound.
  bool refits() const { return !(max_distance < HUGE_VAL); }

  /// With the bound times a factor; there is no other threshold.
  MemorylessQuadric scaled(double factor) const {
    MemorylessQuadric planner = *this;
    if (max_distance < HUGE_VAL) planner.max_distance *= factor;
    return planner;
  }

  /// \throw InvalidParameter
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const {
    validate();
    return plan_checked(surface.mesh(), surface.extras(), 1);
  }

  /// Plans without a surface, which mq does not need.
  /// \throw InvalidMesh, InvalidParameter  as the constructor of SurfaceT.
  template <typename Real>
  CollapsePlan plan(const IndexedMeshT<Real>& mesh, SurfaceExtras extras, std::size_t n_threads) const {
    validate();
    return plan_checked(mesh, detail::checked(mesh, std::move(extras)), n_threads);
  }

 private:
  template <typename Real>
  CollapsePlan plan_checked(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                            std::size_t n_threads) const;
};

template <typename Real>
CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                             std::size_t n_threads) const {
  if (mesh.triangles.size() > mq::CornerTable::kMostFaces)
    throw InvalidMesh("mq plans on at most " + std::to_string(mq::CornerTable::kMostFaces) + " triangles");
  const float min_cos = static_cast<float>(guard.min_cos);
  mq::Run run(mesh, extras, {min_cos, feature_angle, max_distance, keep_charts}, n_threads);
  run.run(target_faces, target_vertices);
  CollapsePlan plan = run.take();
  const std::uint8_t held = mq::held_flags(extras);
  for (Collapse& collapse : plan.collapses)  // a held vertex keeps its coordinates, unrounded
    if ((extras.flags[collapse.to] & held) != 0)
      collapse.target = mesh.points[collapse.to].template cast<double>();
  return plan;
}

#ifdef WHITTLE_COMPILED  // by linking whittle::compiled, which has them
extern template CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<float>&, const SurfaceExtras&,
                                                             std::size_t) const;
extern template CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<double>&,
                                                             const SurfaceExtras&, std::size_t) const;
#endif

}  // namespace whittle
