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
  if (name == "ivdd" || name == "vtd") return recipe::parse_spec(name + ":distance=0.8e");
  if (name == "ss" || name == "fass") return recipe::parse_spec(name + ":radius=0.8e");
  if (name == "fad") return recipe::parse_spec("fad:angle=30");
  if (name == "quadric") return recipe::parse_spec("quadric:max-err=1e-6");
  return recipe::parse_spec(name);
}

Recipe first_recipe() {
  Recipe recipe;
  recipe.modules.push_back(fresh_module("fass"));
  return recipe;
}

bool has_levels(const recipe::Recipe& recipe) {
  return recipe.modules.size() == 1 && recipe.modules[0].text() == "mq" && recipe.target.ratio &&
         !recipe.max_distance && !recipe.delaunay && recipe.driver == recipe::Driver::automatic;
}

Recipe with_needed_target(Recipe recipe, const std::string& module) {
  if (module == "mq" && !recipe.target.any()) recipe.target.ratio = 0.5;
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
  auto& list = spec.parameters;
  const auto at = std::find_if(list.begin(), list.end(), [&](const auto& p) { return p.first == key; });
  if (value.empty()) {
    if (at != list.end()) list.erase(at);
  } else if (at != list.end()) {
    at->second = value;
  } else {
    list.emplace_back(key, value);
  }
  recipe.modules[place] = recipe::parse_spec(spec.text());
  return recipe;
}

const char* suffix(Unit unit) {
  return unit == Unit::edges ? "e" : unit == Unit::percent ? "%" : "";
}

const char* name(Unit unit) {
  return unit == Unit::edges ? "mean edges" : unit == Unit::percent ? "% of diagonal" : "model units";
}

std::string Length::text() const {
  return text::shortest(amount) + suffix(unit);
}

double Length::in_model_units(const Scale& scale) const {
  return unit == Unit::edges     ? amount * scale.mean_edge
         : unit == Unit::percent ? amount / 100 * scale.diagonal
                                 : amount;
}

Length parse_length(const std::string& text) {
  if (text.empty()) return {};
  const std::string digits = text.substr(0, text.size() - 1);
  if (text.back() == 'e') return {to_number(digits).value_or(0), Unit::edges};
  if (text.back() == '%') return {to_number(digits).value_or(0), Unit::percent};
  return {to_number(text).value_or(0), Unit::model};
}

Length in_unit(const Length& length, Unit unit, const Scale& scale) {
  if (length.unit == unit) return length;
  const double one = Length{1, unit}.in_model_units(scale);
  return {one > 0 ? rounded(length.in_model_units(scale) / one, 4) : 0, unit};
}

SliderRange slider_range(const Key& key, Unit unit, const Scale& scale) {
  if (key.kind == KeyKind::length) {
    const double one = Length{1, unit}.in_model_units(scale);
    const double high = one > 0 ? rounded(4 * scale.mean_edge / one, 2) : 4;
    return {0, high, rounded(high / 5, 2), false};
  }
  if (key.name == "passes") return {1, 20, 1, false};
  if (key.name == "count") return {1, 12, 1, false};
  if (key.name == "angle") return {0, 180, 30, false};
  if (key.name == "included") return {0, 180, 150, false};
  if (key.name == "guard") return {-1, 0.999, 0.2, false};
  if (key.name == "ratio") return {1, 20, 5, false};
  if (key.name == "min") return {0, 1, 0.1, false};
  if (key.name == "area") {
    const double square = scale.mean_edge * scale.mean_edge;
    return {rounded(0.1 * square, 2), rounded(100 * square, 2), rounded(4 * square, 2), true};
  }
  if (key.name == "max-err") return {1e-12, 1, 1e-6, true};
  return {key.min, std::isinf(key.max) ? 100 : key.max, key.min, false};
}

std::string picked_key(const Spec& spec, Quantity quantity) {
  const auto& keys = recipe::find_module(spec.name).keys;
  const auto has = [&](const char* wanted) {
    return std::any_of(keys.begin(), keys.end(), [&](const Key& k) { return k.name == wanted; });
  };
  if (quantity == Quantity::face_angle) return has("angle") ? "angle" : "";
  if (quantity == Quantity::edge_length)
    return has("distance") ? "distance" : has("radius") ? "radius" : has("length") ? "length" : "";
  return "";
}

}  // namespace whittle::viewer
