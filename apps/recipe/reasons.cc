#include <algorithm>

#include "recipe/Catalogue.hh"
#include "recipe/Recipe.hh"
#include "recipe/Stage.hh"

namespace whittle::recipe {

namespace {

bool can_move_seams(const Recipe& recipe) {
  const std::vector<Stage> stages = stages_of(recipe);
  return std::any_of(stages.begin(), stages.end(), [](const Stage& stage) {
    return find_module(stage.module.name).find("seams") != nullptr;
  });
}

}  // namespace

std::vector<std::string> reasons(const Recipe& recipe, const Result& result) {
  std::vector<std::string> why;
  if (result.target_reached) return why;
  if (result.stopped_by_bound) why.push_back("the bound on the distance allows no more");
  if (result.attainable.is_higher)
    why.push_back("what cannot vanish has at least " + std::to_string(result.attainable.minimum) +
                  " faces, and the rest was left its share of the target");
  if (result.attainable.small > 0)
    why.push_back(std::to_string(result.attainable.small) + " small pieces keep up to four faces each");
  if (result.attainable.charts > 0)
    why.push_back(std::to_string(result.attainable.charts) + " charts keep a face each");
  PlanRecord record;
  for (const StageResult& stage : result.stages) record += stage.record;
  for (const Stage& stage : stages_of(recipe))
    if (has_threshold(stage.module)) why.push_back("the threshold of '" + stage.text() + "' allows no more");
  if (result.held > result.held_on_seams)
    why.push_back(std::to_string(result.held - result.held_on_seams) + " vertices are locked");
  if (result.held_on_seams > 0)
    why.push_back(std::to_string(result.held_on_seams) + " vertices on seams stay in place" +
                  (can_move_seams(recipe) ? ", which seams=merge lets merge" : ""));
  if (record.refused_by_flip_guard > 0)
    why.push_back("the flip guard refused " + std::to_string(record.refused_by_flip_guard) + " merges");
  if (record.refused_by_link > 0)
    why.push_back("the link condition refused " + std::to_string(record.refused_by_link) + " merges");
  if (record.refused_by_seam > 0)
    why.push_back("seams of the texture refused " + std::to_string(record.refused_by_seam) + " merges");
  if (record.refused_by_bound > 0 && !result.stopped_by_bound)
    why.push_back("the module's bound refused " + std::to_string(record.refused_by_bound) + " merges");
  for (const StageResult& stage : result.stages)
    if (stage.refused_by_decimater > 0) {
      why.push_back("the constraints or the driver refused " + std::to_string(stage.refused_by_decimater) +
                    " collapses");
      break;
    }
  if (why.empty()) why.push_back("no further collapse is legal");
  return why;
}

}  // namespace whittle::recipe
