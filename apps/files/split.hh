/// \file
/// A mesh as renderers want it: every vertex has one value of each attribute.
#pragma once

#include <cstdint>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// A vertex of the mesh is as many vertices here as its corners have different values, one after the other in
/// the order of the mesh; so the mesh's order is that in which their places come first.
struct Split {
  std::vector<std::uint32_t> vertex;             ///< the mesh's, of each vertex
  std::vector<std::uint32_t> corner;             ///< one that has this vertex's values; none: no face uses it
  std::vector<IndexedMesh::Triangle> triangles;  ///< of these vertices

  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /// The value of an attribute that a vertex has; `none` where no corner tells.
  std::uint32_t value(const attributes::Attribute& attribute, std::size_t index) const {
    if (attribute.per_vertex()) return vertex[index];
    return corner[index] == none ? none : attribute.corners[corner[index] / 3][corner[index] % 3];
  }
};

Split split(const IndexedMesh& mesh, const std::vector<const attributes::Attribute*>& attributes);

/// The components of an attribute at every vertex; a default where no corner tells.
std::vector<float> values_at(const Split& vertices, const attributes::Attribute& attribute);

/// For each vertex of the mesh the first that it is here; empty where they are the same.
std::vector<std::uint32_t> first_of_each(const Split& vertices, const IndexedMesh& mesh);

/// The mesh and its attributes, of which some have values at vertices now.
struct SplitMesh {
  IndexedMesh mesh;
  attributes::Attributes attributes;
  std::vector<std::uint32_t> first;  ///< as first_of_each
};
/// \param at_vertices  those of `attributes` that are to have their values there
SplitMesh split_mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                     const std::vector<const attributes::Attribute*>& at_vertices);

}  // namespace whittle::files
