#include "model/progress.hh"

#include <algorithm>
#include <vector>

#include "recipe/Catalogue.hh"
#include "recipe/planner.hh"

namespace whittle::viewer {
namespace {

/// Whether a module's progress runs linearly to the target. mq reports nothing until it has planned.
bool goes_straight(const recipe::Spec& module) {
  if (recipe::find_module(module.name).role != recipe::Role::planned) return true;
  return module.name != "mq" && (recipe::threshold_key(module).empty() || recipe::has_threshold(module));
}

std::optional<double> goal(const recipe::Target& target, std::size_t before) {
  const auto all = static_cast<double>(before);
  if (target.faces) return std::min(static_cast<double>(*target.faces), all);
  if (target.ratio) return *target.ratio * all;
  if (target.vertices) return std::min(2.0 * static_cast<double>(*target.vertices), all);  // Euler, nearly
  return std::nullopt;
}

}  // namespace

std::optional<double> part_done(const recipe::Recipe& recipe, const recipe::Progress& now,
                                std::size_t before) {
  std::vector<recipe::Spec> stages;
  for (const recipe::Spec& module : recipe.modules)
    if (recipe::find_module(module.name).role != recipe::Role::constraint) stages.push_back(module);
  const auto left = goal(recipe.target, before);
  if (!left || stages.size() != 1 || !goes_straight(stages.front())) return std::nullopt;
  const double to_remove = static_cast<double>(before) - *left;
  if (!(to_remove > 0)) return std::nullopt;
  return std::clamp((static_cast<double>(before) - static_cast<double>(now.faces)) / to_remove, 0.0, 1.0);
}

}  // namespace whittle::viewer
