/// \file
/// How far a run has changed the attributes, as `simplify`, `lods` and `batch` report it.
#pragma once

#include <optional>
#include <string>

#include "cli/report.hh"
#include "files/MeshFile.hh"
#include "files/image_size.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {

/// For each kind of attribute that both have, of its first set, `rms` and `max` over 20,000 samples of the input: of
/// texture coordinates in texels of the image, where the file has one, else of 1,024 by 1,024; of colours in 255ths of
/// a colour's components, of normals in degrees. Null where nothing can be measured.
/// \param image  of the input's texture, if it is known
Json attribute_changes(const std::optional<files::ImageSize>& image, const files::MeshFile& in,
                       const recipe::Result& result);

/// The same as a line of text with its line break; empty where there is nothing to say.
std::string changes_line(const Json& changes);

}  // namespace whittle::cli
