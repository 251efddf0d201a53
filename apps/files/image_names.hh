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
/// \param path   of the result; "-" is standard output, beside which nothing is written
/// \param owner  what the new files are called after
std::vector<std::string> image_names(const Parts& parts, const std::filesystem::path& path, bool copies,
                                     const std::filesystem::path& owner, Encoded& out);

/// A name for the file of an image that had none: of letters, digits, - and _, with the extension of its kind.
std::string image_file_name(const Image& image, const std::string& prefix);

}  // namespace whittle::files
