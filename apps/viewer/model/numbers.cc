#include "model/numbers.hh"

#include "figures/json.hh"
#include "model/RecipeText.hh"

namespace whittle::viewer {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json numbers(const Session& session) {
  Json root;
  root["command"] = "view";
  root["recipe"] = options_text(session.recipe());
  root["problem"] = session.problem().empty() ? Json() : Json(session.problem());
  for (const char* name : {"original", "simplified", "stages", "distance", "plan"}) root[name] = nullptr;
  if (const Model* model = session.model())
    root["original"] = {{"file", model->path},
                        {"read", figures::to_json(model->file.report)},
                        {"mesh", figures::to_json(model->inspection.facts)}};
  if (const PlanPicture* plan = session.plan())
    root["plan"] = {{"vertices_gone", plan->vertices_gone},
                    {"faces_gone", plan->faces_gone},
                    {"targets", plan->targets.size()}};
  if (const Outcome* outcome = session.outcome()) {
    root["simplified"] = {{"vertices", outcome->mesh().points.size()},
                          {"faces", outcome->mesh().triangles.size()}};
    root["stages"] = Json::array();
    for (const recipe::StageResult& stage : outcome->result.stages)
      root["stages"].push_back(figures::to_json(stage));
    root["flipped_faces"] = outcome->result.flipped_faces;
    root["target_reached"] = outcome->result.target_reached;
    root["nonmanifold_faces_dropped"] = outcome->result.refused_faces;
    root["decimation_ms"] = outcome->milliseconds;
  }
  if (const Comparison* comparison = session.comparison()) {
    root["simplified"]["mesh"] = figures::to_json(comparison->inspection.facts);
    if (comparison->distance) root["distance"] = figures::to_json(*comparison->distance);
    root["heat_top_units"] = comparison->heat_top;
  }
  return root;
}

}  // namespace whittle::viewer
