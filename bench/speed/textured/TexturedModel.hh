/// \file
/// Models of the suite `textured`.
#pragma once

#include <filesystem>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "attributes/Attribute.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::speed {

/// Whether the default weights were chosen by a model's figures, or only looked at with them in the end.
enum class Half { tuning, held_out, given };

std::string to_string(Half half);

struct TexturedModel {
  std::string name;  ///< also the stem of files about it
  Half half = Half::given;
  IndexedMesh mesh;
  attributes::Attributes attributes;  ///< texture coordinates or colours
};

/// Those that are made in code, those over the meshes in the cache (the bunny, and what else assets/fetch.sh has put
/// there), and the files given, in that order.
/// \param only  keeps those in whose name it is found
/// \throw files::FileError, std::runtime_error  a file cannot be read, or holds neither texture coordinates nor
///                                              colours.
std::vector<TexturedModel> textured_models(const std::filesystem::path& cache,
                                           const std::vector<std::filesystem::path>& files,
                                           const std::optional<std::regex>& only);

}  // namespace whittle::speed
