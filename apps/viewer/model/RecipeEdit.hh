/// \file
/// Changes of a recipe, as a user makes them with sliders and buttons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "recipe/Catalogue.hh"
#include "recipe/Recipe.hh"

namespace whittle::viewer {

/// A module as it is added to a chain: with a threshold that does something on most meshes.
recipe::Spec fresh_module(const std::string& name);

/// What the viewer starts with.
recipe::Recipe first_recipe();

/// The recipe with a target of half the faces if the module needs a target and there is none.
recipe::Recipe with_needed_target(recipe::Recipe recipe, const std::string& module);

/// Whether every result of the recipe's target slider is in one plan, as `whittle lods` makes it: the default
/// module with its defaults down to a ratio, and nothing else.
bool has_levels(const recipe::Recipe& recipe);

/// Each gives the changed recipe. A module is named by its place in the chain, from 0.
/// \throw RecipeError  no such module, key or place, a value out of range.
/// \{
recipe::Recipe with_module(recipe::Recipe recipe, std::size_t place, const std::string& spec);
recipe::Recipe with_added(recipe::Recipe recipe, const std::string& spec);
recipe::Recipe without(recipe::Recipe recipe, std::size_t place);
recipe::Recipe with_moved(recipe::Recipe recipe, std::size_t from, std::size_t to);
/// An empty value takes the key away: the module's default holds.
recipe::Recipe with_value(recipe::Recipe recipe, std::size_t place, const std::string& key,
                          const std::string& value);
/// \}

using recipe::Length;
using recipe::Unit;

const char* name(Unit unit);  ///< for people
/// The same length in another unit, with four digits.
Length in_unit(const Length& length, Unit unit, const recipe::Scale& scale);

/// What the slider of a key runs over on a mesh, and where it stands while the key is not given.
/// \param unit  of a length
/// \return nothing that is in squares of edges any more.
recipe::Slider slider_of(const recipe::Key& key, Unit unit, const recipe::Scale& scale);

/// The key of the module at a place that a length or an angle picked on a histogram sets; empty if none does.
enum class Quantity { edge_length, face_angle, quality };
std::string picked_key(const recipe::Spec& spec, Quantity quantity);

/// The value that a picked key has, in the histogram's units: its default where it is not given; none where it
/// has no default or another key says the same.
std::optional<double> picked_value(const recipe::Spec& spec, const std::string& key,
                                   const recipe::Scale& scale);

}  // namespace whittle::viewer
