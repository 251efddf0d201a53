/// \file
/// What is done on an OpenMesh mesh.
#pragma once

#include "recipe/Decimated.hh"
#include "recipe/Stage.hh"
#include "whittle/DelaunayFlips.hh"

namespace whittle::recipe {

/// Executes a plan through the stage's OpenMesh decimater, under its constraints, and counts in the report.
Decimated execute_by_openmesh(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                              const SurfaceExtras& extras, const CollapsePlan& plan, StageResult& report);

/// A pass of a stage without a plan: its stock module orders the collapses.
Decimated run_stock_modules(const Task& task, const Stage& stage, const IndexedMesh& mesh,
                            const SurfaceExtras& extras, StageResult& report);

/// The Delaunay retriangulation of a mesh by edge flips. Faces that OpenMesh cannot take are counted in
/// `refused_faces`.
/// \param wedges  for each corner a number; edges across which the numbers differ stay, and the numbers go
///                with the corners. Empty: no such edges.
IndexedMesh retriangulate(const IndexedMesh& mesh, double max_dihedral, DelaunayFlipsReport& report,
                          std::size_t& refused_faces, std::vector<IndexedMesh::Triangle>& wedges);

}  // namespace whittle::recipe
