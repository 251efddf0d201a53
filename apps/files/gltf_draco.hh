/// \file
/// Parts of a glTF document that are packed by KHR_draco_mesh_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace whittle::files {

/// A part that is packed.
struct DracoPart {
  struct Values {
    std::size_t accessor = 0;  ///< which says what the values are; it has none
    std::uint32_t number = 0;  ///< of Draco's attribute
  };
  std::size_t mesh = 0, primitive = 0;  ///< of the document
  std::size_t view = 0;
  std::map<std::string, Values> attributes;
};

/// Takes all packed parts' corners and packed attributes out of a document; but for parts of which all is there unpacked
/// as well.
/// \throw Fault  damaged
std::vector<DracoPart> take_draco_parts(nlohmann::json& document);

/// Unpacks parts, and gives them accessors and views of their own in one more buffer.
/// \param model       of the document without them
/// \param buffers     the bytes of each buffer
/// \param file_bytes  how long the file is; what is unpacked may take a multiple of it, but not any
/// \return the bytes of that buffer, the one behind `buffers`; empty where nothing is packed
/// \throw Fault  damaged, or far larger than the file
std::string unpack_draco(const std::vector<DracoPart>& parts, tinygltf::Model& model,
                         const std::vector<std::string_view>& buffers, std::size_t file_bytes);

/// Takes the extension from the parts of a document; what is said of them besides is kept.
void erase_draco(nlohmann::json& document);

}  // namespace whittle::files
