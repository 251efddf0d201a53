/// \file
/// How glTF names data: within the document, or in a file beside it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace whittle::files {

inline bool is_data_uri(std::string_view uri) {
  return uri.substr(0, 5) == "data:";
}

/// The bytes within `data:` something `;base64,` something. \throw Fault  it is not that
std::string decode_data_uri(std::string_view uri);

/// %20 and the like as the characters that they stand for.
std::string decode_percents(std::string_view uri);

/// The reverse, for the name of a file.
std::string encode_percents(std::string_view name);

/// The bytes of a file that a document names.
/// \param path  of the document; "-" is standard input, which has no files beside it
/// \throw Fault  not in its folder, or it cannot be read
std::string read_beside(const std::filesystem::path& path, std::string_view uri);

}  // namespace whittle::files
