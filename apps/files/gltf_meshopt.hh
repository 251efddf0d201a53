/// \file
/// Views of a glTF document that are packed by EXT_meshopt_compression.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace whittle::files {

/// A packed view, and where its bytes go when it is unpacked.
struct PackedView {
  std::size_t buffer = 0, offset = 0, length = 0;  ///< where it is packed
  std::size_t stride = 0, count = 0;               ///< bytes of each value, and how many there are
  std::string mode, filter;
  std::size_t begin = 0;  ///< where it goes among the unpacked bytes
};

/// Makes all packed views of a document plain ones of another buffer.
/// \param buffer  the number of that buffer
/// \throw Fault  damaged
std::vector<PackedView> take_packed_views(nlohmann::json& document, std::size_t buffer);

/// The bytes of that buffer.
/// \param most  bytes that it may have
/// \throw Fault  damaged, or more
std::string unpacked(const std::vector<PackedView>& views, const std::vector<std::string_view>& buffers,
                     std::size_t most);

}  // namespace whittle::files
