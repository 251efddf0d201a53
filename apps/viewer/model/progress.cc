#include "model/progress.hh"

#include <algorithm>
#include <vector>

#include "recipe/Catalogue.hh"

namespace whittle::viewer {
namespace {

/// Whether the counts that a module reports lead straight to the target: not where it plans in one go, or
/// where a threshold is searched for.
bool goes_straight(const recipe::Spec& spec) {
  const recipe::Module& module = recipe::find_module(spec.name);
  if (module.role != recipe::Role::planned) return true;
  return !module.plans_to_target && (module.threshold.empty() || recipe::has_threshold(spec));
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
