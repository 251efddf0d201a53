/// \file
/// Which libraries an OBJ file names, and what is written beside it for that.
#pragma once

#include <string>
#include <vector>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Libraries that the input named are referred to where they are, by a path from the new file's folder, or copied to it
/// together with their images. Materials that come from another format get a library of their own, and images that were
/// within the mesh's file one file each.
/// \param path  of the OBJ file; "-" is standard output, beside which nothing is written
/// \param out   whose companions are added to
/// \return the libraries, as the OBJ file is to name them
std::vector<std::string> obj_materials(const Parts& parts, const std::filesystem::path& path, bool copies,
                                       Encoded& out);

}  // namespace whittle::files
