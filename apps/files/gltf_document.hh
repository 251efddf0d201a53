/// \file
/// glTF's JSON, checked and reduced to what a mesh is made of.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "files/MeshBuilder.hh"
#include "files/gltf_draco.hh"
#include "files/gltf_meshopt.hh"

namespace whittle::files {

/// Accessors of the places of a node's instances, by EXT_mesh_gpu_instancing. -1: there is none.
struct GltfPlaces {
  int translation = -1, rotation = -1, scale = -1;
  bool any() const { return translation >= 0 || rotation >= 0 || scale >= 0; }
};

/// A mesh of the document, at a place of the scene.
struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  std::string name = {};    ///< of the node
  bool is_skinned = false;  ///< its own transform does not count then
  GltfPlaces places = {};   ///< where the mesh is shown instead of once
};

struct GltfBuffer {
  bool has_uri = false;  ///< else it is the binary chunk of a GLB
  std::string uri;
  std::size_t bytes = 0;   ///< declared
  bool is_packed = false;  ///< it has no bytes: all of its views are packed elsewhere
};

struct GltfDocument {
  std::string json;  ///< accessors, views and meshes, for tinygltf
  std::vector<GltfBuffer> buffers;
  std::vector<PackedView> packed;       ///< they become one more buffer
  std::vector<DracoPart> draco;         ///< they get their accessors when they are unpacked
  std::vector<GltfInstance> instances;  ///< of the scene, in the order of its nodes; kept: of all nodes
  nlohmann::json looks;                 ///< materials, textures and images
};

/// \param keeps_scene  whether all is to be written back; else what else is in the document is noted
/// \throw Fault  damaged, not glTF 2, or with extensions that are needed to read it
GltfDocument parse_gltf(std::string_view json, bool keeps_scene, MeshBuilder& builder);

/// All of a document, but for the data that stand in it. \pre parse_gltf takes it
nlohmann::json whole_gltf(std::string_view json);

}  // namespace whittle::files
