#include "recipe/Catalogue.hh"

#include <algorithm>
#include <iterator>

#include "recipe/keys.hh"
#include "text/number.hh"

namespace whittle::recipe {

const Key* Module::find(const std::string& key) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

bool Module::is_given(const Spec& spec, const std::string& key) const {
  return std::any_of(keys.begin(), keys.end(), [&](const Key& k) {
    return (k.name == key || k.instead_of == key) && spec.has(k.name);
  });
}

const std::vector<Module>& catalogue() {
  static const std::vector<Module> modules = [] {
    std::vector<Module> all = planned_modules(), stock = stock_modules();
    std::move(stock.begin(), stock.end(), std::back_inserter(all));
    return all;
  }();
  return modules;
}

const Module& find_module(const std::string& name) {
  std::string known;
  for (const Module& module : catalogue()) {
    if (module.name == name) return module;
    known += (known.empty() ? "" : ", ") + module.name;
  }
  throw RecipeError("unknown module '" + name + "'; there are " + known);
}

Spec default_module() {
  return parse_spec("mq");
}

bool moves_seams(const Spec& spec) {
  return find_module(spec.name).moves_seams || spec.word("seams") == "merge";
}

bool has_threshold(const Spec& spec) {
  const Module& module = find_module(spec.name);
  return !module.threshold.empty() && module.is_given(spec, module.threshold);
}

Spec with_threshold(Spec spec, double threshold) {
  spec.set(find_module(spec.name).threshold, text::shortest(threshold));
  return spec;
}

std::string catalogue_help() {
  std::string text;
  for (const Module& module : catalogue()) {
    text += "  " + module.name + ": " + module.meaning +
            (module.role == Role::constraint ? " (constraint)" : "") + "\n";
    for (const Key& key : module.keys) {
      text += "      " + key.name + "=";
      if (key.kind == KeyKind::length) text += "LENGTH";
      if (key.kind == KeyKind::number) text += "NUMBER";
      if (key.kind == KeyKind::integer) text += "N";
      for (std::size_t i = 0; i < key.choices.size(); ++i) text += (i ? "|" : "") + key.choices[i];
      text += "  " + key.help() + "\n";
    }
  }
  return text;
}

}  // namespace whittle::recipe
