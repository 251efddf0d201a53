/// \file
/// A model as every contender gets it.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstddef>
#include <cstdint>
#include <string>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::speed {

using Arrays = IndexedMeshT<float>;
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// The same mesh as arrays and as an OpenMesh mesh with status properties and nothing else.
struct Subject {
  std::string name;  ///< the file's stem, with "x4" for each subdivision
  Arrays arrays;
  OpenMeshMesh mesh;
  std::size_t refused_faces = 0;  ///< faces that OpenMesh did not take
  double mean_edge = 0;           ///< in model units
  std::uint64_t checksum = 0;     ///< of the arrays

  std::size_t n_faces() const { return arrays.triangles.size(); }
  std::size_t array_bytes() const {
    return arrays.points.size() * sizeof(Arrays::Point) + arrays.triangles.size() * sizeof(Arrays::Triangle);
  }
};

Subject make_subject(std::string name, Arrays arrays);

/// What the times under "build" are taken of: an OpenMesh mesh from arrays.
/// \return how many faces OpenMesh did not take.
std::size_t build(const Arrays& arrays, OpenMeshMesh& mesh);

/// FNV-1a, 64 bits, over the coordinates and then the indices as they lie in memory.
std::uint64_t checksum(const Arrays& arrays);

}  // namespace whittle::speed
