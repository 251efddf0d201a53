#include "recipe/Stage.hh"

#include <algorithm>

#include "recipe/Catalogue.hh"

namespace whittle::recipe {

Floor make_floor(const Target& target, const IndexedMesh& mesh) {
  Floor floor;
  if (target.ratio)
    floor.faces = std::max<std::size_t>(
        1, static_cast<std::size_t>(*target.ratio * static_cast<double>(mesh.triangles.size())));
  if (target.faces) floor.faces = *target.faces;
  if (target.vertices) floor.vertices = *target.vertices;
  return floor;
}

bool Stage::is_planned() const {
  return find_module(module.name).role == Role::planned;
}

std::string Stage::text() const {
  std::string text = module.text();
  for (const Spec& constraint : constraints) text += " + " + constraint.text();
  return text;
}

std::vector<Stage> group(const std::vector<Spec>& modules) {
  std::vector<Stage> stages;
  for (const Spec& spec : modules) {
    if (find_module(spec.name).role != Role::constraint)
      stages.push_back({spec, {}});
    else if (stages.empty())
      throw RecipeError("module '" + spec.name +
                        "' only constrains; a module that decimates must stand before it");
    else
      stages.back().constraints.push_back(spec);
  }
  if (stages.empty()) throw RecipeError("no module given, and no target that the default, mq, could go to");
  return stages;
}

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

}  // namespace whittle::recipe
