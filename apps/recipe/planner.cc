#include "recipe/planner.hh"

#include <algorithm>
#include <charconv>

namespace whittle::recipe {
namespace {

FaceAngle make_face_angle(const Spec& spec) {
  FaceAngle planner;
  if (spec.has("angle") && spec.has("included"))
    throw RecipeError("module '" + spec.name + "': angle and included are the same threshold; give one");
  if (const auto angle = spec.number("angle")) planner.max_normal_angle = *angle;
  if (const auto included = spec.number("included")) planner.max_normal_angle = 180 - *included;
  if (spec.word("pairs") == "all") planner.pairs = FaceAngle::Pairs::all;
  if (const auto count = spec.number("count")) planner.count = static_cast<int>(*count);
  if (const auto area = spec.number("area")) {
    if (*area == 0)
      throw RecipeError("module '" + spec.name + "': area=0 is out of range; it must be positive");
    planner.max_area = *area;
  }
  if (spec.word("lock") == "strict") planner.lock = FaceAngle::Lock::strict;
  if (spec.word("apex") == "lexicographic") planner.apex = FaceAngle::Apex::lexicographic;
  return planner;
}

ScanOrder order_of(const Spec& spec) {
  return spec.word("order") == "error" ? ScanOrder::error : ScanOrder::index;
}

SphereScan make_sphere_scan(const Spec& spec, const Scale& scale) {
  SphereScan planner;
  if (const auto radius = spec.length("radius", scale)) planner.radius = *radius;
  if (spec.word("placement") == "quadric") planner.placement = SphereScan::Placement::quadric;
  planner.order = order_of(spec);
  return planner;
}

/// VT, IVDD and VTD, which share the two places of a triangle's point.
template <typename P>
P make_triangle_planner(const Spec& spec) {
  P planner;
  if (spec.word("placement") == "circumcenter") planner.placement = TrianglePlacement::circumcenter;
  if (spec.word("placement") == "quadric") planner.placement = TrianglePlacement::quadric;
  if constexpr (!std::is_same_v<P, Vtd>) planner.order = order_of(spec);
  return planner;
}

Planner make(const Spec& spec, const Scale& scale) {
  if (spec.name == "fad") return make_face_angle(spec);
  if (spec.name == "ss") return make_sphere_scan(spec, scale);
  if (spec.name == "fass") return Fass{make_face_angle(spec), make_sphere_scan(spec, scale)};
  if (spec.name == "vt") return make_triangle_planner<Circumcenter>(spec);
  if (spec.name == "mq") {
    MemorylessQuadric planner;
    if (const auto angle = spec.number("feature")) planner.feature_angle = *angle;
    if (const auto distance = spec.length("max-distance", scale)) planner.max_distance = *distance;
    if (spec.has("max-distance") && spec.has("passes"))
      throw RecipeError(
          "module 'mq': a pass would measure max-distance from what the last one has left; it takes one");
    return planner;
  }
  const double distance = spec.length("distance", scale).value_or(0);
  if (spec.name == "vtd") {
    auto planner = make_triangle_planner<Vtd>(spec);
    planner.max_distance = distance;
    if (spec.word("fold") == "literal") planner.fold = Vtd::Fold::literal;
    return planner;
  }
  auto planner = make_triangle_planner<VertexDistance>(spec);
  planner.max_distance = distance;
  return planner;
}

/// The fewest digits that name the number.
std::string shortest(double number) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + sizeof digits, number).ptr;
  return {digits, static_cast<std::size_t>(end - digits)};
}

/// Calls `visit` for a planner, or for each planner of a chain.
template <typename P, typename Visit>
void for_each_planner(P& planner, Visit visit) {
  if constexpr (std::is_same_v<P, Fass>) {
    visit(planner.face_angle);
    visit(planner.sphere_scan);
  } else {
    visit(planner);
  }
}

}  // namespace

Planner make_planner(const Spec& spec, const Scale& scale) {
  Planner planner = make(spec, scale);
  const auto guard = spec.number("guard");
  const bool merge = spec.word("boundary") == "merge";
  const auto set = [&](auto& p) {
    if (guard) p.guard.min_cos = *guard;
    using P = std::decay_t<decltype(p)>;
    if constexpr (!std::is_same_v<P, Circumcenter> && !std::is_same_v<P, MemorylessQuadric>)
      if (merge) p.boundary = Boundary::merge;
  };
  std::visit([&](auto& p) { for_each_planner(p, set); }, planner);
  return planner;
}

std::string threshold_key(const Spec& spec) {
  if (spec.name == "vt" || spec.name == "mq") return "";
  if (spec.name == "fad") return "angle";
  if (spec.name == "ss" || spec.name == "fass") return "radius";
  return spec.name == "quadric" ? "max-err" : "distance";
}

bool has_threshold(const Spec& spec) {
  return spec.has(threshold_key(spec)) || (spec.name == "fad" && spec.has("included"));
}

bool has_default_threshold(const Spec& spec) {
  return spec.name == "fad" || spec.name == "vt";
}

void set_target(Planner& planner, std::size_t faces, std::size_t vertices) {
  if (auto* mq = std::get_if<MemorylessQuadric>(&planner)) {
    mq->target_faces = faces;
    mq->target_vertices = vertices;
  }
}

Planner with_threshold(const Planner& planner, double threshold) {
  Planner changed = planner;
  if (auto* fad = std::get_if<FaceAngle>(&changed)) fad->max_normal_angle = threshold;
  if (auto* ivdd = std::get_if<VertexDistance>(&changed)) ivdd->max_distance = threshold;
  if (auto* ss = std::get_if<SphereScan>(&changed)) ss->radius = threshold;
  if (auto* vtd = std::get_if<Vtd>(&changed)) vtd->max_distance = threshold;
  if (auto* fass = std::get_if<Fass>(&changed)) fass->sphere_scan.radius = threshold;
  return changed;
}

Spec with_threshold(Spec spec, double threshold) {
  spec.parameters.emplace_back(threshold_key(spec), shortest(threshold));
  return spec;
}

Spec with_max_distance(Spec spec, double distance, const Scale& scale) {
  const std::string key = "max-distance";
  if (const auto own = spec.length(key, scale)) distance = std::min(distance, *own);
  auto& all = spec.parameters;
  all.erase(std::remove_if(all.begin(), all.end(), [&](const auto& p) { return p.first == key; }), all.end());
  all.emplace_back(key, shortest(distance));
  return spec;
}

ThresholdRange threshold_range(const Planner& planner, const Scale& scale) {
  if (std::holds_alternative<FaceAngle>(planner)) return {1, 180};
  return {scale.mean_edge / 8, 2 * scale.diagonal};
}

}  // namespace whittle::recipe
