#include "recipe/planner.hh"

namespace whittle::recipe {
namespace {

FaceAngle make_face_angle(const Spec& spec) {
  FaceAngle planner;
  if (spec.has("angle") && spec.has("included"))
    throw RecipeError("module 'fad': angle and included are the same threshold; give one");
  if (const auto angle = spec.number("angle")) planner.max_normal_angle = *angle;
  if (const auto included = spec.number("included")) planner.max_normal_angle = 180 - *included;
  if (spec.word("pairs") == "all") planner.pairs = FaceAngle::Pairs::all;
  if (const auto count = spec.number("count")) planner.count = static_cast<int>(*count);
  if (const auto area = spec.number("area")) {
    if (*area == 0) throw RecipeError("module 'fad': area=0 is out of range; it must be positive");
    planner.max_area = *area;
  }
  if (spec.word("lock") == "strict") planner.lock = FaceAngle::Lock::strict;
  if (spec.word("apex") == "lexicographic") planner.apex = FaceAngle::Apex::lexicographic;
  return planner;
}

VertexDistance make_vertex_distance(const Spec& spec, const Scale& scale) {
  VertexDistance planner;
  if (const auto distance = spec.length("distance", scale)) planner.max_distance = *distance;
  if (spec.word("placement") == "circumcenter") planner.placement = VertexDistance::Placement::circumcenter;
  return planner;
}

}  // namespace

Planner make_planner(const Spec& spec, const Scale& scale) {
  Planner planner =
      spec.name == "fad" ? Planner(make_face_angle(spec)) : Planner(make_vertex_distance(spec, scale));
  if (const auto guard = spec.number("guard"))
    std::visit([&](auto& p) { p.guard.min_cos = *guard; }, planner);
  return planner;
}

bool has_threshold(const Spec& spec) {
  for (const char* key : {"angle", "included", "distance", "max-err"})
    if (spec.has(key)) return true;
  return false;
}

bool has_default_threshold(const Spec& spec) {
  return spec.name == "fad";
}

Planner with_threshold(const Planner& planner, double threshold) {
  Planner changed = planner;
  if (auto* fad = std::get_if<FaceAngle>(&changed)) fad->max_normal_angle = threshold;
  if (auto* ivdd = std::get_if<VertexDistance>(&changed)) ivdd->max_distance = threshold;
  return changed;
}

std::string threshold_key(const Planner& planner) {
  return std::holds_alternative<FaceAngle>(planner) ? "angle" : "distance";
}

ThresholdRange threshold_range(const Planner& planner, const Scale& scale) {
  if (std::holds_alternative<FaceAngle>(planner)) return {1, 180};
  return {scale.mean_edge / 8, 2 * scale.diagonal};
}

}  // namespace whittle::recipe
