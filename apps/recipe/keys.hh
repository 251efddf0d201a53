/// \file
/// The keys that entries of the table are written with, and the two parts of the table.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "recipe/Catalogue.hh"
#include "text/number.hh"

namespace whittle::recipe {

std::vector<Module> planned_modules();  ///< Whittle's own
std::vector<Module> stock_modules();    ///< OpenMesh's, and ModGuardedQuadricT

inline Key make_key(std::string name, KeyKind kind, std::string meaning, std::string fallback) {
  return {std::move(name), kind, std::move(meaning), std::move(fallback)};
}

inline Key length_key(std::string name, std::string meaning, std::string fallback) {
  Key key = make_key(std::move(name), KeyKind::length, std::move(meaning), std::move(fallback));
  key.max = HUGE_VAL;
  return key;
}

/// \param slider  where it starts is the default
inline Key number_key(std::string name, double min, double max, std::string meaning, Slider slider) {
  Key key = make_key(std::move(name), KeyKind::number, std::move(meaning), text::shortest(slider.start));
  key.min = min;
  key.max = max;
  key.slider = slider;
  return key;
}

inline Key degrees_key(std::string name, std::string meaning, double fallback, double max = 180) {
  Key key = number_key(std::move(name), 0, max, std::move(meaning) + ", degrees", {0, max, fallback});
  key.measure = Measure::degrees;
  return key;
}

inline Key integer_key(std::string name, double max, std::string meaning, std::string fallback,
                       Slider slider) {
  Key key = number_key(std::move(name), 1, max, std::move(meaning), slider);
  key.kind = KeyKind::integer;
  key.fallback = std::move(fallback);
  return key;
}

inline Key choice_key(std::string name, std::vector<std::string> choices, std::string meaning) {
  Key key = make_key(std::move(name), KeyKind::choice, std::move(meaning), choices.front());
  key.choices = std::move(choices);
  return key;
}

/// What a flip guard allows; -1 turns it off.
inline Key guard_key(double fallback) {
  Key key = number_key("guard", -1, 0.999, "least cosine of a face's turn", {-1, 0.999, fallback});
  key.fallback += ", -1 is off";
  return key;
}

/// What becomes of small charts where seams move.
inline Key charts_key() {
  return choice_key("charts", {"vanish", "keep"}, "keep: no chart of the texture loses its last face");
}

/// The same key, shown at once, and picked on a histogram if there is one.
inline Key main_key(Key key, Histogram histogram = Histogram::none) {
  key.is_main = true;
  key.histogram = histogram;
  return key;
}

/// The number of a key, or its default. \pre the default is a number
inline double number_of(const Spec& spec, const std::string& key) {
  return spec.number(key).value_or(find_module(spec.name).find(key)->slider.start);
}

}  // namespace whittle::recipe
