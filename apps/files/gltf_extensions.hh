/// \file
/// Which extensions a glTF document names.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace whittle::files {

/// Says that the document uses an extension, once.
/// \param required  it cannot be read without
inline void use_gltf_extension(nlohmann::json& document, const std::string& name, bool required = false) {
  const auto add = [&](nlohmann::json& list) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  };
  add(document["extensionsUsed"]);
  if (required) add(document["extensionsRequired"]);
}

}  // namespace whittle::files
