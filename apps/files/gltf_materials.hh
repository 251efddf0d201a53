/// \file
/// What other formats know of glTF's materials.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "files/GltfData.hh"
#include "files/MeshFile.hh"

namespace whittle::files {

/// How a material takes its base colour from texture coordinates.
struct TextureUse {
  std::size_t set = 0;  ///< TEXCOORD_n
  /// From a coordinate of the file to one of the image: KHR_texture_transform, on (u, v, 1)
  Eigen::Matrix<double, 2, 3> transform = Eigen::Matrix<double, 2, 3>::Identity();
  bool is_plain() const { return transform == Eigen::Matrix<double, 2, 3>::Identity(); }
};

/// For each material of a document how it uses texture coordinates.
std::vector<TextureUse> texture_uses(const nlohmann::json& looks);

/// Takes over the materials of a document and the images of their base colours.
/// \param looks  its materials, textures and images
/// \param path   of the file, beside which images may be
/// \param uses   how they use texture coordinates, where those are the file's own
void read_gltf_materials(const nlohmann::json& looks, GltfData& data, const std::filesystem::path& path,
                         MeshFile& file, const std::vector<TextureUse>& uses = {});

}  // namespace whittle::files
