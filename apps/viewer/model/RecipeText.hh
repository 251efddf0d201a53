/// \file
/// Recipes as text: the options of `whittle simplify`.
#pragma once

#include <string>

#include "recipe/Recipe.hh"

namespace whittle::viewer {

/// `--module fad:angle=30 --module ivdd:distance=0.8e --ratio 0.5`, quoted for a shell where it must be.
std::string options_text(const recipe::Recipe& recipe);

/// `whittle simplify IN OUT --module …`, which gives the mesh that the viewer shows.
std::string command_text(const recipe::Recipe& recipe, const std::string& in, const std::string& out);
/// `whittle lods IN …`, whose level 1 is what the viewer shows from the plan of all levels.
/// \pre has_levels(recipe)
std::string levels_command_text(const recipe::Recipe& recipe, const std::string& in, const std::string& out);

/// Reads options, a whole command (IN, OUT and the options that say what is printed are passed over), or bare
/// specifications (`fass:radius=0.8e`). Comments begin with `#`. What `run` would object to is not looked at.
/// \throw RecipeError  a line that is none of this.
recipe::Recipe parse_options(const std::string& text);

/// A recipe file holds what parse_options() reads.
/// \throw RecipeError, FileError
recipe::Recipe load_recipe(const std::string& path);

/// \throw FileError
void save_recipe(const std::string& path, const recipe::Recipe& recipe);

}  // namespace whittle::viewer
