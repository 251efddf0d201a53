#include "recipe/Spec.hh"

#include <algorithm>
#include <cmath>

#include "recipe/Catalogue.hh"
#include "recipe/number.hh"
#include "text/number.hh"

namespace whittle::recipe {
namespace {

std::optional<Unit> unit_of(const std::string& suffix_of_number) {
  for (const Unit unit : {Unit::model, Unit::edges, Unit::percent})
    if (suffix_of_number == suffix(unit)) return unit;
  return std::nullopt;
}

Unit known_unit(const std::string& where, const std::string& suffix_of_number) {
  if (const auto unit = unit_of(suffix_of_number)) return *unit;
  throw RecipeError(where + ": unknown unit '" + suffix_of_number +
                    "'; lengths are 0.0012, 0.8e (mean edges) or 0.5%");
}

void check_value(const std::string& module, const Key& key, const std::string& value) {
  const std::string where = "module '" + module + "': " + key.name + "=" + value;
  if (key.kind == KeyKind::choice) {
    if (std::find(key.choices.begin(), key.choices.end(), value) != key.choices.end()) return;
    std::string all;
    for (const std::string& choice : key.choices) all += (all.empty() ? "" : " or ") + choice;
    throw RecipeError(where + " is not " + all);
  }
  const auto number = leading_number(value);
  if (!number) throw RecipeError(where + " is not a number");
  const auto& [amount, unit] = *number;
  if (key.kind == KeyKind::length) {
    known_unit(where, unit);
  } else if (!unit.empty()) {
    throw RecipeError(where + " is not a plain number");
  }
  if (key.kind == KeyKind::integer && amount != std::floor(amount))
    throw RecipeError(where + " is not a whole number");
  if (amount < key.min || amount > key.max)
    throw RecipeError(where + " is out of range; " +
                      (std::isinf(key.max)
                           ? "at least " + text::shortest(key.min)
                           : "from " + text::shortest(key.min) + " to " + text::shortest(key.max)));
}

const Key& known_key(const Module& module, const std::string& name) {
  if (const Key* key = module.find(name)) return *key;
  std::string known;
  for (const Key& key : module.keys) known += (known.empty() ? "" : ", ") + key.name;
  throw RecipeError("module '" + module.name + "': unknown key '" + name + "'; " +
                    (known.empty() ? "it has none" : "there are " + known));
}

}  // namespace

const char* suffix(Unit unit) {
  return unit == Unit::edges ? "e" : unit == Unit::percent ? "%" : "";
}

double Length::in(const Scale& scale) const {
  if (unit == Unit::edges) return amount * scale.mean_edge;
  if (unit == Unit::percent) return amount / 100 * scale.diagonal;
  return amount;
}

std::string Length::text() const {
  return text::shortest(amount) + suffix(unit);
}

Length parse_length(const std::string& text) {
  const auto number = leading_number(text);
  if (!number) throw RecipeError("'" + text + "' is not a length");
  const Unit unit = known_unit("'" + text + "'", number->second);
  if (number->first < 0) throw RecipeError("'" + text + "' is negative");
  return {number->first, unit};
}

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
  const std::string* value = find(key);
  return value ? std::optional(leading_number(*value).value().first) : std::nullopt;
}

std::optional<double> Spec::length(const std::string& key, const Scale& scale) const {
  const std::string* value = find(key);
  if (!value) return std::nullopt;
  const auto [amount, unit] = leading_number(*value).value();
  return Length{amount, unit_of(unit).value()}.in(scale);
}

void Spec::set(const std::string& key, const std::string& value) {
  for (auto& [name_of_key, old] : parameters)
    if (name_of_key == key) {
      old = value;
      return;
    }
  parameters.emplace_back(key, value);
}

void Spec::clear(const std::string& key) {
  const auto is_it = [&](const auto& parameter) { return parameter.first == key; };
  parameters.erase(std::remove_if(parameters.begin(), parameters.end(), is_it), parameters.end());
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
  const Module& module = find_module(spec.name);
  if (colon == std::string::npos) return spec;

  for (std::size_t begin = colon + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0)
      throw RecipeError("module '" + spec.name + "': '" + item + "' is not key=value");
    const std::string name = item.substr(0, equals), value = item.substr(equals + 1);
    const Key& key = known_key(module, name);
    if (spec.has(name)) throw RecipeError("module '" + spec.name + "': key '" + name + "' stands twice");
    check_value(spec.name, key, value);
    spec.parameters.emplace_back(name, value);
  }
  return spec;
}

}  // namespace whittle::recipe
