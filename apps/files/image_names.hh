/// \file
/// How a result names the images of its materials.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// For each image its name as a file beside `path` names it: where it is, or where it is copied to; images that were within
/// the mesh's file get one each. Empty: it cannot be named.
/// \param path  of the result; nothing is written beside standard output, a device or a pipe
std::vector<std::string> image_names(const Parts& parts, const std::filesystem::path& path, bool copies,
                                     Encoded& out);

/// A name for the file of an image that had none: of letters, digits, - and _, with the extension of its kind.
std::string image_file_name(const Image& image, const std::string& prefix);

}  // namespace whittle::files
