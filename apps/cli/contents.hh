/// \file
/// What a file has besides its mesh, as `info` tells it: materials, groups, images, the scene.
#pragma once

#include <string>

#include "cli/report.hh"
#include "files/MeshFile.hh"

namespace whittle::cli {

/// The materials by name, with how many faces each has.
Json materials_json(const files::Parts& parts);

/// Of a glTF file the document is read once more, unless it came from standard input; `scene` is null for other formats.
/// \param path  of the file
/// \param in    as it was read for other formats
Json contents_json(const std::string& path, const files::MeshFile& in);

/// The same as lines of text; empty where there is nothing of this kind.
std::string contents_text(const Json& contents);

}  // namespace whittle::cli
