/// \file
/// An OpenMesh mesh of the faces that OpenMesh takes, from flat arrays and back.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "recipe/Decimated.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::recipe {

struct CopyTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord1D = double;  // holds the number of a wedge exactly
};

class OpenMeshCopy {
 public:
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<CopyTraits>;

  explicit OpenMeshCopy(const IndexedMesh& mesh);

  /// Gives the mesh the numbers of wedges as half-edge texture coordinates, so that its seams are known.
  /// \param in  that it is a copy of
  void set_wedges(const IndexedMesh& in, const std::vector<IndexedMesh::Triangle>& wedges);

  /// The living vertices and faces in their old order.
  /// \param collapses  those that were carried out, the vertex that went and the one that it went into
  Decimated take(const std::vector<std::pair<int, int>>& collapses) const;

  /// The input face that a face is.
  std::uint32_t origin(Mesh::FaceHandle f) const { return face_origin_[static_cast<std::size_t>(f.idx())]; }

  Mesh mesh;

 private:
  std::vector<std::uint32_t> face_origin_;
  std::size_t refused_faces_ = 0;
};

/// While it lives, OpenMesh writes nothing to its own streams: the programs report what matters themselves.
class Silence {
 public:
  Silence() : errors_(::omerr().is_enabled()), log_(::omlog().is_enabled()) {
    ::omerr().disable();
    ::omlog().disable();
  }
  ~Silence() {
    if (errors_) ::omerr().enable();
    if (log_) ::omlog().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool errors_, log_;
};

}  // namespace whittle::recipe
