/// \file
/// A recipe's modules in the groups that run together, each with its driver, and where a run stops.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "recipe/Recipe.hh"
#include "recipe/Spec.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::recipe {

/// Stop when the mesh has no more than this; 0 for no such bound.
struct Floor {
  std::size_t faces = 0, vertices = 0;
  bool any() const { return faces > 0 || vertices > 0; }
  bool reached(std::size_t n_faces, std::size_t n_vertices) const {
    return (faces > 0 && n_faces <= faces) || (vertices > 0 && n_vertices <= vertices);
  }
  bool reached(const IndexedMesh& mesh) const { return reached(mesh.triangles.size(), mesh.points.size()); }
};

Floor make_floor(const Target& target, const IndexedMesh& mesh);

/// A module that decimates with the constraints that joined it.
struct Stage {
  Spec module;
  std::vector<Spec> constraints;

  bool is_planned() const;   ///< by a planner of Whittle's
  std::string text() const;  ///< "fad:angle=30 + normal-flipping"
};

/// \throw RecipeError  no module, or a constraint in first place.
std::vector<Stage> group(const std::vector<Spec>& modules);

/// The driver that runs a stage. \throw RecipeError  the one that is wanted cannot.
Driver choose_driver(Driver wanted, const Stage& stage);

}  // namespace whittle::recipe
