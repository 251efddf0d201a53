/// \file
/// mq, memoryless quadrics: down to a number of faces, as true to the shape as possible.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "whittle/mq/Run.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/plan/PlanDraft.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/errors.hh"

namespace whittle {

/// Planner of mq.
///
/// Edges are collapsed in order of the error that this adds, to the point where the planes of the faces
/// around them are nearest, until `target_faces` are left. The planes are those of the faces as they are by
/// then: the quadrics have no memory (Lindstrom and Turk 1998), which is nearer to the input in the end than
/// accumulated ones (Garland and Heckbert 1997). In a vertex's own frame its planes pass through the origin,
/// so a quadric is a symmetric matrix and nothing else.
///
/// Vertices that are locked, features or on a seam stay where they are; free ones may merge into them. The
/// boundary is held by planes of its own. A tolerance divides the error that a collapse adds by its square,
/// of both ends the least counts. Values that the extras give (normals, colours, texture coordinates) count
/// beside the shape, where vertices go as well as in what order. Computes in float on a copy of unit size.
struct MemorylessQuadric {
  std::size_t target_faces = 0;     ///< stop at so many faces or fewer; 0: go on until nothing is legal
  std::size_t target_vertices = 0;  ///< or at so many vertices, isolated ones included
  /// Edges whose two faces' normals differ by more are held by planes of their own, as the boundary is: they
  /// may get shorter, and keep their line. Degrees, 0..180; 180: none
  double feature_angle = 180;
  /// No vertex of the input lies farther than this from the faces that it is left with, nor these from the
  /// input at their middles and corners: a collapse that would break it is refused, and others are made
  /// instead. What lies between is not watched. A vertex's tolerance is a factor. Model units, not negative;
  /// HUGE_VAL: no bound
  double max_distance = HUGE_VAL;
  FlipGuard guard;  ///< against the normal before each collapse; against that of the input no face turns by
                    ///< 90 degrees

  /// \throw InvalidParameter  a value outside the range given above.
  void validate() const {
    guard.validate();
    if (!(feature_angle >= 0 && feature_angle <= 180))
      throw InvalidParameter("the feature angle must be in 0..180 degrees");
    if (!(max_distance >= 0)) throw InvalidParameter("the largest distance must not be negative");
  }

  /// The bound is what there is of a threshold.
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

  /// Without a surface, which it does not need; `bulk` uses this.
  /// \throw InvalidMesh, InvalidParameter  as the constructor of SurfaceT.
  template <typename Real>
  CollapsePlan plan(const IndexedMeshT<Real>& mesh, SurfaceExtras extras, std::size_t n_threads) const {
    validate();
    return plan_checked(mesh, checked(mesh, std::move(extras)), n_threads);
  }

 private:
  template <typename Real>
  CollapsePlan plan_checked(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                            std::size_t n_threads) const;
};

template <typename Real>
CollapsePlan MemorylessQuadric::plan_checked(const IndexedMeshT<Real>& mesh, const SurfaceExtras& extras,
                                             std::size_t n_threads) const {
  const float min_cos = static_cast<float>(guard.min_cos);
  MemorylessQuadricRun run(mesh, extras, {min_cos, feature_angle, max_distance}, n_threads);
  run.run(target_faces, target_vertices);
  CollapsePlan plan = run.take();
  for (Collapse& collapse : plan.collapses)  // what is held stays just where it is, not where its float is
    if ((extras.flags[collapse.to] & MemorylessQuadricMesh::kHeld) != 0)
      collapse.target = mesh.points[collapse.to].template cast<double>();
  return plan;
}

}  // namespace whittle
