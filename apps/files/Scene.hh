/// \file
/// The glTF document that a mesh was read from, for what a decimation does not change.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// A document with its data, and where its meshes are in the one mesh that is decimated.
///
/// Each mesh of the document is there once, however many nodes show it, as large as where it is shown largest, so that
/// one length means the same everywhere; and so far from the others that they do not touch. Skinned meshes keep their
/// own size. What is written back is all of the document but the triangles.
struct Scene {
  using Json = nlohmann::json;

  /// What a value of a part was in the file.
  struct Channel {
    std::string name;            ///< "TEXCOORD_1"; "0/POSITION" of the first morph target
    std::size_t components = 0;  ///< in the file
    bool bytes = false;          ///< a colour of bytes
  };
  /// A primitive of triangles; they are the parts of the mesh, in the same order.
  struct Piece {
    std::size_t mesh = 0, primitive = 0;  ///< of the document
    std::vector<Channel> channels;
  };
  /// From a mesh of the document to the one that is decimated: scale, then offset.
  struct Placement {
    double scale = 1;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  };

  Json document;
  std::vector<std::string> buffers;  ///< the bytes of each
  std::filesystem::path path;        ///< of the file; "-" is standard input
  std::vector<Piece> pieces;
  std::vector<Placement> placements;            ///< of each mesh of the document
  std::vector<IndexedMesh::Point> file_points;  ///< of the vertices of the file, in their meshes' coordinates
  std::vector<std::uint32_t> mesh_of;           ///< for each vertex of the file its mesh
  double diagonal = 0;                          ///< of the bounding box of all that the nodes show
};

}  // namespace whittle::files
