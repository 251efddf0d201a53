/// \file
/// Changes of a recipe, as a user makes them with sliders and buttons.
#pragma once

#include <cstddef>
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

/// Whether every result of the recipe's target slider is in one plan, as `whittle lods` makes it: mq with its
/// defaults down to a ratio, and nothing else.
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

/// How a length is written.
enum class Unit { model, edges, percent };
const char* suffix(Unit unit);  ///< "", "e", "%"
const char* name(Unit unit);    ///< for people

/// A length as it stands in a specification.
struct Length {
  double amount = 0;
  Unit unit = Unit::model;
  std::string text() const;
  double in_model_units(const recipe::Scale& scale) const;
};
/// \pre text is a length that parse_spec() has taken
Length parse_length(const std::string& text);
/// The same length in another unit, with four digits.
Length in_unit(const Length& length, Unit unit, const recipe::Scale& scale);

/// What a slider of a key runs over, and where it stands while the key is not given.
struct SliderRange {
  double low = 0, high = 1, start = 0;
  bool logarithmic = false;
};
SliderRange slider_range(const recipe::Key& key, Unit unit, const recipe::Scale& scale);

/// The key of the module at a place that a length or an angle picked on a histogram sets; empty if none does.
enum class Quantity { edge_length, face_angle, quality };
std::string picked_key(const recipe::Spec& spec, Quantity quantity);

}  // namespace whittle::viewer
