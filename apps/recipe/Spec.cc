#include "recipe/Spec.hh"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "recipe/Catalogue.hh"

namespace whittle::recipe {
namespace {

/// A number with what follows it; nothing where the text does not begin with a finite number.
std::optional<std::pair<double, std::string>> split_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return std::pair(value, std::string(rest, end));
}

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : std::string("?");
}

void check_unit(const std::string& where, const std::string& unit) {
  if (!unit.empty() && unit != "e" && unit != "%")
    throw RecipeError(where + ": unknown unit '" + unit + "'; lengths are 0.0012, 0.8e (mean edges) or 0.5%");
}

void check_value(const std::string& module, const Key& key, const std::string& value) {
  const std::string where = "module '" + module + "': " + key.name + "=" + value;
  if (key.kind == KeyKind::choice) {
    if (std::find(key.choices.begin(), key.choices.end(), value) != key.choices.end()) return;
    std::string all;
    for (const std::string& choice : key.choices) all += (all.empty() ? "" : " or ") + choice;
    throw RecipeError(where + " is not " + all);
  }
  const auto number = split_number(value);
  if (!number) throw RecipeError(where + " is not a number");
  const auto& [amount, unit] = *number;
  if (key.kind == KeyKind::length) {
    check_unit(where, unit);
  } else if (!unit.empty()) {
    throw RecipeError(where + " is not a plain number");
  }
  if (key.kind == KeyKind::integer && amount != std::floor(amount))
    throw RecipeError(where + " is not a whole number");
  if (amount < key.min || amount > key.max)
    throw RecipeError(where + " is out of range; " +
                      (std::isinf(key.max) ? "at least " + shortest(key.min)
                                           : "from " + shortest(key.min) + " to " + shortest(key.max)));
}

}  // namespace

const std::string* Spec::find(const std::string& key) const {
  for (const auto& [name_of_key, value] : parameters)
    if (name_of_key == key) return &value;
  return nullptr;
}

std::optional<std::string> Spec::word(const std::string& key) const {
  const std::string* value = find(key);
  return value ? std::optional(*value) : std::nullopt;
}

std::optional<double> Spec::number(const std::string& key) const {
  return length(key, {1, 100});
}

std::optional<double> Spec::length(const std::string& key, const Scale& scale) const {
  const std::string* value = find(key);
  if (!value) return std::nullopt;
  const auto [amount, unit] = split_number(*value).value();
  return Length{amount, unit}.in(scale);
}

double Length::in(const Scale& scale) const {
  if (unit == "e") return amount * scale.mean_edge;
  if (unit == "%") return amount / 100 * scale.diagonal;
  return amount;
}

std::string Length::text() const {
  return shortest(amount) + unit;
}

Length parse_length(const std::string& text) {
  const auto number = split_number(text);
  if (!number) throw RecipeError("'" + text + "' is not a length");
  check_unit("'" + text + "'", number->second);
  if (number->first < 0) throw RecipeError("'" + text + "' is negative");
  return {number->first, number->second};
}

std::string Spec::text() const {
  std::string out = name;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    out += (i ? "," : ":") + parameters[i].first + "=" + parameters[i].second;
  return out;
}

Spec parse_spec(const std::string& text) {
  Spec spec;
  const std::size_t colon = text.find(':');
  spec.name = text.substr(0, colon);
  const ModuleInfo& module = find_module(spec.name);
  if (colon == std::string::npos) return spec;

  for (std::size_t begin = colon + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0)
      throw RecipeError("module '" + spec.name + "': '" + item + "' is not key=value");
    const std::string name = item.substr(0, equals), value = item.substr(equals + 1);
    const auto key =
        std::find_if(module.keys.begin(), module.keys.end(), [&](const Key& k) { return k.name == name; });
    if (key == module.keys.end()) {
      std::string known;
      for (const Key& k : module.keys) known += (known.empty() ? "" : ", ") + k.name;
      throw RecipeError("module '" + spec.name + "': unknown key '" + name + "'; " +
                        (known.empty() ? "it has none" : "there are " + known));
    }
    if (spec.has(name)) throw RecipeError("module '" + spec.name + "': key '" + name + "' stands twice");
    check_value(spec.name, *key, value);
    spec.parameters.emplace_back(name, value);
  }
  return spec;
}

}  // namespace whittle::recipe
