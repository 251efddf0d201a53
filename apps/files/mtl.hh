/// \file
/// OBJ's libraries of materials, .mtl files.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "files/MeshFile.hh"

namespace whittle::files {

/// Finds the libraries that an OBJ file names, and what the materials of its parts are there. Paths are
/// followed as they are relative to the file that they stand in, also out of its folder; there only what has a material
/// counts as a library. Those that are missing or refused are noted, and stay named.
/// \param obj  where the OBJ file is; "-": nothing is read
void read_libraries(MeshFile& file, const std::filesystem::path& obj);

/// Whether a text has a material in it.
bool is_library(std::string_view text);

/// A library with the names of its images replaced.
/// \param new_name  called with each as it stands there
std::string with_images(std::string_view library,
                        const std::function<std::string(const std::string&)>& new_name);

/// A library of materials that have no other file.
/// \param image_names  for each of Parts::images, as the library is to name it; empty: it has none
std::string mtl_text(const Parts& parts, const std::vector<std::string>& image_names);

/// What OBJ calls a material: its name, or "material" and its number where that is empty or another's.
std::vector<std::string> obj_material_names(const std::vector<Material>& materials);

}  // namespace whittle::files
