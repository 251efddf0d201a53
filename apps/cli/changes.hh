/// \file
/// How far a run has changed the attributes, and what has vanished as a whole, as `simplify`, `lods` and `batch` report it.
#pragma once

#include <optional>
#include <string>

#include "attributes/TextureError.hh"
#include "cli/report.hh"
#include "files/MeshFile.hh"
#include "files/image_size.hh"
#include "recipe/Recipe.hh"

namespace whittle::cli {

/// In what a change of a mesh's texture coordinates is told: texels of its image where that is known, else of 1,024 by
/// 1,024. The number of samples is left as it is.
/// \return the image's width and height for JSON; null where it is not known
Json count_in_texels_of(const std::optional<files::ImageSize>& image,
                        attributes::TextureErrorOptions& options);
/// "texels of 2048 x 1024". \param image  as above
std::string texels_text(const Json& image);

/// For each kind of attribute that both have, of its first set, `rms` and `max` over 20,000 samples of the input: of
/// texture coordinates in texels of the image, where the file has one, else of 1,024 by 1,024; of colours in 255ths of
/// a colour's components, of normals in degrees. Null where nothing can be measured.
/// \param image  of the input's texture, if it is known
Json attribute_changes(const std::optional<files::ImageSize>& image, const files::MeshFile& in,
                       const recipe::Result& result);

/// The same as a line of text with its line break; empty where there is nothing to say.
std::string changes_line(const Json& changes);

/// How many charts of the texture there were, and how many have vanished; the same of pieces, by a rule of `--pieces`. How
/// many pieces there were is null where neither a target nor a rule asks for it.
/// \{
Json charts_json(const recipe::Result& result);
Json pieces_json(const recipe::Recipe& recipe, const recipe::Result& result);
/// \}
/// Both as lines of text; empty where nothing has vanished.
std::string vanished_lines(const Json& charts, const Json& pieces);

}  // namespace whittle::cli
