/// \file
/// One pass of one stage: a plan made and carried out, by whichever driver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "recipe/Recipe.hh"
#include "recipe/planner.hh"
#include "whittle/CollapsePlan.hh"
#include "whittle/IndexedMesh.hh"

namespace whittle::recipe {

/// Stop when the mesh has no more than this; 0 for no such bound.
struct Floor {
  std::size_t faces = 0, vertices = 0;
  bool any() const { return faces > 0 || vertices > 0; }
  bool reached(const IndexedMesh& mesh) const {
    return (faces > 0 && mesh.triangles.size() <= faces) || (vertices > 0 && mesh.points.size() <= vertices);
  }
};

/// A priority module with the constraints that joined it.
struct Stage {
  Spec module;
  std::vector<Spec> constraints;
};

struct Pass {
  IndexedMesh mesh;
  std::vector<std::uint32_t> vertex_map;   ///< input vertex to output vertex
  std::vector<std::uint32_t> face_origin;  ///< output face to input face
  std::size_t collapses = 0;               ///< executed
  std::size_t refused = 0;                 ///< planned, not executed, and not for the floor's sake
  std::size_t refused_faces = 0;           ///< input faces that OpenMesh could not take
  PlanRecord record;
  double plan_seconds = 0, execute_seconds = 0;
};

/// Plans and executes on the flat arrays.
Pass bulk_pass(const IndexedMesh& mesh, const Planner& planner, const Floor& floor);

/// Runs a stage through an OpenMesh decimater. `planner` is used if the stage's module is a planned one.
Pass openmesh_pass(const IndexedMesh& mesh, Driver driver, const Stage& stage, const Planner& planner,
                   const Scale& scale, const Floor& floor);

}  // namespace whittle::recipe
