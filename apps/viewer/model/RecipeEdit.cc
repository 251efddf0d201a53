#include "model/RecipeEdit.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/number.hh"

namespace whittle::viewer {

using recipe::Key;
using recipe::KeyKind;
using recipe::Recipe;
using recipe::RecipeError;
using recipe::Scale;
using recipe::Spec;

namespace {

void check_place(const Recipe& recipe, std::size_t place) {
  if (place >= recipe.modules.size())
    throw RecipeError("there is no module " + std::to_string(place + 1) + " in the chain");
}

}  // namespace

Spec fresh_module(const std::string& name) {
  const recipe::Module& module = recipe::find_module(name);
  Spec spec{name, {}};
  if (module.threshold.empty()) return spec;
  const Key& key = *module.find(module.threshold);
  spec.set(key.name,
           key.kind == KeyKind::length ? Length{0.8, Unit::edges}.text() : text::shortest(key.slider.start));
  return spec;
}

Recipe first_recipe() {
  Recipe recipe;
  recipe.modules.push_back(fresh_module("fass"));
  return recipe;
}

bool has_levels(const recipe::Recipe& recipe) {
  return recipe.modules.size() == 1 && recipe.modules[0].text() == recipe::default_module().text() &&
         recipe.target.ratio && !recipe.max_distance && !recipe.delaunay && recipe.refit.value_or(true) &&
         recipe.driver == recipe::Driver::automatic;
}

Recipe with_needed_target(Recipe recipe, const std::string& module) {
  if (recipe::find_module(module).needs_target() && !recipe.target.any()) recipe.target.ratio = 0.5;
  return recipe;
}

Recipe with_module(Recipe recipe, std::size_t place, const std::string& spec) {
  check_place(recipe, place);
  recipe.modules[place] = recipe::parse_spec(spec);
  const std::string name = recipe.modules[place].name;
  return with_needed_target(std::move(recipe), name);
}

Recipe with_added(Recipe recipe, const std::string& spec) {
  recipe.modules.push_back(recipe::parse_spec(spec));
  const std::string name = recipe.modules.back().name;
  return with_needed_target(std::move(recipe), name);
}

Recipe without(Recipe recipe, std::size_t place) {
  check_place(recipe, place);
  recipe.modules.erase(recipe.modules.begin() + static_cast<std::ptrdiff_t>(place));
  return recipe;
}

Recipe with_moved(Recipe recipe, std::size_t from, std::size_t to) {
  check_place(recipe, from);
  check_place(recipe, to);
  const auto at = [&](std::size_t i) { return recipe.modules.begin() + static_cast<std::ptrdiff_t>(i); };
  if (from < to)
    std::rotate(at(from), at(from + 1), at(to + 1));
  else
    std::rotate(at(to), at(from), at(from + 1));
  return recipe;
}

Recipe with_value(Recipe recipe, std::size_t place, const std::string& key, const std::string& value) {
  check_place(recipe, place);
  Spec spec = recipe.modules[place];
  if (value.empty())
    spec.clear(key);
  else
    spec.set(key, value);
  recipe.modules[place] = recipe::parse_spec(spec.text());
  return recipe;
}

const char* name(Unit unit) {
  return unit == Unit::edges ? "mean edges" : unit == Unit::percent ? "% of diagonal" : "model units";
}

Length in_unit(const Length& length, Unit unit, const Scale& scale) {
  if (length.unit == unit) return length;
  const double one = Length{1, unit}.in(scale);
  return {one > 0 ? rounded(length.in(scale) / one, 4) : 0, unit};
}

recipe::Slider slider_of(const Key& key, Unit unit, const Scale& scale) {
  if (key.kind == KeyKind::length) {
    const double one = Length{1, unit}.in(scale);
    const double high = one > 0 ? rounded(4 * scale.mean_edge / one, 2) : 4;
    return {0, high, rounded(high / 5, 2)};
  }
  recipe::Slider slider = key.slider;
  if (slider.in_square_edges) {
    const double square = scale.mean_edge * scale.mean_edge;
    for (double* end : {&slider.low, &slider.high, &slider.start}) *end = rounded(*end * square, 2);
    slider.in_square_edges = false;
  }
  return slider;
}

std::string picked_key(const Spec& spec, Quantity quantity) {
  using recipe::Histogram;
  const Histogram wanted = quantity == Quantity::edge_length  ? Histogram::edge_length
                           : quantity == Quantity::face_angle ? Histogram::face_angle
                                                              : Histogram::none;
  for (const Key& key : recipe::find_module(spec.name).keys)
    if (wanted != Histogram::none && key.histogram == wanted) return key.name;
  return "";
}

std::optional<double> picked_value(const Spec& spec, const std::string& key, const Scale& scale) {
  if (key.empty()) return std::nullopt;
  if (spec.has(key)) return spec.length(key, scale);
  const recipe::Module& module = recipe::find_module(spec.name);
  const Key& info = *module.find(key);
  if (info.kind == KeyKind::length || module.is_given(spec, key)) return std::nullopt;
  return info.slider.start;
}

}  // namespace whittle::viewer
