/// \file
/// A plan for a mesh, and the plan carried out by whichever driver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "recipe/Recipe.hh"
#include "recipe/Stage.hh"
#include "recipe/planner.hh"
#include "whittle/plan/CollapsePlan.hh"
#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::recipe {

/// A plan of one or more passes.
struct Plan {
  CollapsePlan collapses;
  std::size_t passes = 0;
  double seconds = 0;
};

/// Asked now and then with the number of faces left; false ends the work with Cancelled. Empty: never ends.
using GoOn = std::function<bool(std::size_t faces)>;

/// How a stage is to be run.
struct Job {
  const Stage& stage;
  Driver driver;
  const Planner* planner;  ///< null for a stock module
  Scale scale;
  Floor floor;
  std::size_t max_passes = 1;
  GoOn go_on;
};

/// Plans up to `max_passes` passes, fewer where the floor is reached or a pass changes nothing.
Plan make_plan(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job, std::size_t max_passes);

/// What became of a mesh.
struct Pass {
  IndexedMesh mesh;
  std::vector<std::uint32_t> vertex_map;   ///< input vertex to output vertex
  std::vector<std::uint32_t> face_origin;  ///< output face to input face
  std::size_t collapses = 0;               ///< executed
  std::size_t refused = 0;                 ///< planned, and passed over on the way to the floor
  std::size_t refused_faces = 0;           ///< input faces that OpenMesh could not take
  PlanRecord record;
  double plan_seconds = 0, execute_seconds = 0;
};

/// The shortest beginning of the plan that reaches the floor, or all of it.
std::size_t collapses_to_floor(const CollapsePlan& plan, const IndexedMesh& mesh, const Floor& floor);

/// Executes a plan on the flat arrays.
Pass bulk_pass(const IndexedMesh& mesh, const CollapsePlan& plan, const Floor& floor);

/// Executes a plan through an OpenMesh decimater, under the stage's constraints; without a plan, the stage's
/// stock module.
Pass openmesh_pass(const IndexedMesh& mesh, const SurfaceExtras& extras, const Job& job,
                   const CollapsePlan* plan);

/// The Delaunay retriangulation of a mesh by edge flips. Faces that OpenMesh cannot take are counted in
/// `refused_faces`.
/// \param wedges  for each corner a number; edges across which the numbers differ stay, and the numbers go
///                with the corners. Empty: no such edges.
IndexedMesh retriangulate(const IndexedMesh& mesh, double max_dihedral, DelaunayFlipsReport& report,
                          std::size_t& refused_faces, std::vector<IndexedMesh::Triangle>& wedges);

}  // namespace whittle::recipe
