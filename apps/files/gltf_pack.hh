/// \file
/// Making glTF files small: KHR_mesh_quantization and EXT_meshopt_compression.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "files/Choice.hh"
#include "files/GltfOutput.hh"
#include "files/GltfViews.hh"

namespace whittle::files {

/// Does of what follows what the options say.
/// \param is_own  the nodes are of this program
void pack_gltf(GltfOutput& output, const WriteOptions& options, bool is_own, WriteReport& report);

/// Rounds positions to whole numbers, with a transform in a node of their own that brings them back; normals and tangents
/// to 8 bits, texture coordinates within 0..1 to 16. What cannot be rounded so stays, and is noted, and so is how much was
/// rounded.
/// \param bits   of a coordinate, 8..16; the largest extent of each mesh has 2^bits - 1 steps
/// \param folds  whether the nodes are of this program: they take the transform themselves
void quantize_gltf(GltfViews& views, int bits, bool folds, WriteReport& report);

/// Puts triangles and vertices into an order that caches and the packing like.
/// \param report  its `first_vertex` follows
void reorder_gltf(GltfViews& views, WriteReport& report);

/// Packs vertices and indices. The unpacked views are in a second buffer that has no bytes.
/// \return the bytes of the first buffer
std::string compress_gltf(GltfViews& views);

}  // namespace whittle::files
