#include "recipe/Stage.hh"

#include <algorithm>

namespace whittle::recipe {
namespace {

/// The driver that runs a stage. \throw RecipeError  the one that is wanted cannot.
Driver choose_driver(Driver wanted, const Stage& stage) {
  if (wanted == Driver::automatic)
    return !stage.is_planned() ? Driver::lazy : stage.constraints.empty() ? Driver::bulk : Driver::sweep;
  if (!stage.is_planned() && (wanted == Driver::bulk || wanted == Driver::sweep))
    throw RecipeError("driver '" + to_string(wanted) + "' cannot run module '" + stage.module.name +
                      "', which has no plan; use lazy, decimater or mc");
  if (wanted == Driver::bulk && !stage.constraints.empty())
    throw RecipeError("driver 'bulk' cannot run module '" + stage.constraints.front().name +
                      "', which needs an OpenMesh mesh; use sweep, lazy, decimater or mc");
  return wanted;
}

}  // namespace

std::string Stage::text() const {
  std::string text = module.text();
  for (const Spec& constraint : constraints) text += " + " + constraint.text();
  return text;
}

std::vector<Stage> stages_of(const Recipe& recipe) {
  std::vector<Stage> stages;
  for (const Spec& spec : recipe.modules) {
    if (find_module(spec.name).role != Role::constraint) {
      const std::size_t index = stages.size();
      stages.push_back({spec, {}, recipe.driver, index});
    } else if (stages.empty()) {
      throw RecipeError("module '" + spec.name +
                        "' only constrains; a module that decimates must stand before it");
    } else {
      stages.back().constraints.push_back(spec);
    }
  }
  const bool only_pieces =
      recipe.pieces.what == PieceRule::What::below && !recipe.target.any() && !recipe.max_distance;
  if (stages.empty() && !only_pieces)
    throw RecipeError("no module given, and no target that the default, " + default_module().name +
                      ", could go to");
  for (Stage& stage : stages) stage.driver = choose_driver(recipe.driver, stage);
  return stages;
}

std::uint8_t flags_that_hold(const std::vector<Stage>& stages) {
  const bool seams_move = stages.empty() || std::any_of(stages.begin(), stages.end(), [](const Stage& stage) {
                            return moves_seams(stage.module);
                          });
  return static_cast<std::uint8_t>(kLocked | kFeature | (seams_move ? 0 : kSeam));
}

}  // namespace whittle::recipe
