#include "recipe/keys.hh"
#include "whittle/plan/TargetCount.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/Fass.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

namespace whittle::recipe {
namespace {

// Keys that several modules have, each with what reads it.

Key passes_key() {
  return main_key(integer_key("passes", 1000, "repeat so often or until nothing changes",
                              "1, or as often as a target needs", {1, 20, 1}));
}

template <typename P>
void read_guard(const Spec& spec, P& planner) {
  planner.guard.min_cos = spec.number("guard").value_or(planner.guard.min_cos);
}

Key boundary_key() {
  return choice_key("boundary", {"keep", "merge"}, "merge: along the boundary");
}
template <typename P>
void read_boundary(const Spec& spec, P& planner) {
  if (spec.word("boundary") == "merge") planner.boundary = Boundary::merge;
}

Key seams_key() {
  return choice_key("seams", {"keep", "merge"}, "merge: along seams of texture");
}
template <typename P>
void read_seams(const Spec& spec, P& planner) {
  if (spec.word("seams") == "merge") planner.seams = Seams::merge;
}

Key order_key() {
  return choice_key("order", {"index", "error"}, "error: the cheapest merges first");
}
template <typename P>
void read_order(const Spec& spec, P& planner) {
  if (spec.word("order") == "error") planner.order = ScanOrder::error;
}

Key triangle_placement_key() {
  return choice_key("placement", {"enclosing", "circumcenter", "quadric"}, "where a triangle's point lies");
}
template <typename P>
void read_triangle_placement(const Spec& spec, P& planner) {
  if (spec.word("placement") == "circumcenter") planner.placement = TrianglePlacement::circumcenter;
  if (spec.word("placement") == "quadric") planner.placement = TrianglePlacement::quadric;
}

std::vector<Key> common_keys() {
  return {boundary_key(), seams_key(), guard_key(FlipGuard().min_cos), passes_key()};
}

std::vector<Key> joined(const std::vector<std::vector<Key>>& groups) {
  std::vector<Key> keys;
  for (const auto& group : groups) keys.insert(keys.end(), group.begin(), group.end());
  return keys;
}

constexpr char kRequired[] = "required without a target";

// Each module: its entry, and the planner that a spec stands for.

Planner make_circumcenter(const Spec& spec, const Scale&, const TargetCount&) {
  Circumcenter planner;
  read_triangle_placement(spec, planner);
  read_order(spec, planner);
  read_guard(spec, planner);
  return Planner(planner);
}

Module vt() {
  Module module;
  module.name = "vt";
  module.meaning = "triangles become points";
  module.keys = {triangle_placement_key(), order_key(), guard_key(FlipGuard().min_cos), passes_key()};
  module.ends_by_itself = true;
  module.make_planner = make_circumcenter;
  return module;
}

std::vector<Key> face_angle_keys() {
  const double angle = FaceAngle().max_normal_angle;
  Key area = number_key("area", 0, HUGE_VAL, "largest area of the vertex's faces, square units",
                        {0.1, 100, 4, true, true});
  area.fallback = "none";
  area.measure = Measure::square_units;
  Key included = degrees_key("included", "the same as an included angle", 180 - angle);
  included.instead_of = "angle";
  return {main_key(degrees_key("angle", "largest angle between face normals", angle), Histogram::face_angle),
          std::move(included),
          choice_key("pairs", {"adjacent", "all"}, "which faces are compared"),
          integer_key("count", 1e6, "how many of the angles must qualify", "all", {1, 12, 1}),
          std::move(area),
          choice_key("lock", {"ring", "strict"}, "what a removal keeps in place"),
          choice_key("apex", {"delaunay", "lexicographic"}, "where the new fan starts")};
}

FaceAngle face_angle(const Spec& spec) {
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
  read_boundary(spec, planner);
  read_seams(spec, planner);
  read_guard(spec, planner);
  return planner;
}

Module fad() {
  Module module;
  module.name = "fad";
  module.meaning = "removes vertices whose faces lie nearly in a plane";
  module.keys = joined({face_angle_keys(), common_keys()});
  module.threshold = "angle";
  module.ends_by_itself = true;
  module.make_planner = [](const Spec& spec, const Scale&, const TargetCount&) {
    return Planner(face_angle(spec));
  };
  return module;
}

Planner make_vertex_distance(const Spec& spec, const Scale& scale, const TargetCount&) {
  VertexDistance planner;
  planner.max_distance = spec.length("distance", scale);
  read_triangle_placement(spec, planner);
  read_order(spec, planner);
  read_boundary(spec, planner);
  read_seams(spec, planner);
  read_guard(spec, planner);
  return Planner(planner);
}

Module ivdd() {
  Module module;
  module.name = "ivdd";
  module.meaning = "folds short edges and small triangles to a point";
  module.keys = joined(
      {{main_key(length_key("distance", "edges shorter than this fold", kRequired), Histogram::edge_length),
        triangle_placement_key(), order_key()},
       common_keys()});
  module.threshold = "distance";
  module.make_planner = make_vertex_distance;
  return module;
}

std::vector<Key> sphere_scan_keys() {
  return {
      main_key(length_key("radius", "neighbours nearer than this merge", kRequired), Histogram::edge_length),
      choice_key("placement", {"paper", "quadric"}, "midpoint, centre, centroid, or quadric"), order_key()};
}

SphereScan sphere_scan(const Spec& spec, const Scale& scale) {
  SphereScan planner;
  planner.radius = spec.length("radius", scale);
  if (spec.word("placement") == "quadric") planner.placement = SphereScan::Placement::quadric;
  read_order(spec, planner);
  read_boundary(spec, planner);
  read_seams(spec, planner);
  read_guard(spec, planner);
  return planner;
}

Module ss() {
  Module module;
  module.name = "ss";
  module.meaning = "merges what a moving sphere covers";
  module.keys = joined({sphere_scan_keys(), common_keys()});
  module.threshold = "radius";
  module.make_planner = [](const Spec& spec, const Scale& scale, const TargetCount&) {
    return Planner(sphere_scan(spec, scale));
  };
  return module;
}

Planner make_vtd(const Spec& spec, const Scale& scale, const TargetCount&) {
  Vtd planner;
  planner.max_distance = spec.length("distance", scale);
  if (spec.word("fold") == "literal") planner.fold = Vtd::Fold::literal;
  read_triangle_placement(spec, planner);
  read_boundary(spec, planner);
  read_seams(spec, planner);
  read_guard(spec, planner);
  return Planner(planner);
}

Module vtd() {
  Module module;
  module.name = "vtd";
  module.meaning = "small triangles become points, else an edge folds";
  module.keys = joined(
      {{main_key(length_key("distance", "edges shorter than this count", kRequired), Histogram::edge_length),
        choice_key("fold", {"shortest", "literal"}, "which edge"), triangle_placement_key()},
       common_keys()});
  module.threshold = "distance";
  module.make_planner = make_vtd;
  return module;
}

Module fass() {
  Module module;
  module.name = "fass";
  module.meaning = "fad, then ss on what is left";
  module.keys = joined({sphere_scan_keys(), face_angle_keys(), common_keys()});
  module.threshold = "radius";
  module.make_planner = [](const Spec& spec, const Scale& scale, const TargetCount&) {
    return Planner(Fass{face_angle(spec), sphere_scan(spec, scale)});
  };
  return module;
}

Planner make_memoryless_quadric(const Spec& spec, const Scale& scale, const TargetCount& target) {
  if (spec.has("max-distance") && spec.has("passes"))
    throw RecipeError("module '" + spec.name +
                      "': a pass would measure max-distance from what the last one has left; it takes one");
  MemorylessQuadric planner;
  planner.target_faces = target.faces;
  planner.target_vertices = target.vertices;
  planner.feature_angle = spec.number("feature").value_or(planner.feature_angle);
  planner.max_distance = spec.length("max-distance", scale).value_or(planner.max_distance);
  planner.keep_charts = spec.word("charts") == "keep";
  read_guard(spec, planner);
  return Planner(planner);
}

Module mq() {
  Module module;
  module.name = "mq";
  module.meaning = "down to the target, as true to the shape as possible; needs a target or a bound";
  module.keys = {
      length_key("normals", "how far a difference of 1 counts as", "0"),
      length_key("colours", "the same", "0.003 of the area's root"),
      length_key("texture", "the same of texture coordinates", "0.1 of their mean stretch"),
      degrees_key("feature", "sharper edges keep their line", MemorylessQuadric().feature_angle),
      length_key("max-distance", "how far a vertex of the input may come to lie from the faces", "no bound"),
      charts_key(),
      guard_key(MemorylessQuadric().guard.min_cos),
      passes_key()};
  module.cheapest_first = true;
  module.refits = true;
  module.moves_seams = true;
  module.plans_to_target = true;
  module.bound = "max-distance";
  module.make_planner = make_memoryless_quadric;
  return module;
}

}  // namespace

std::vector<Module> planned_modules() {
  return {vt(), fad(), ivdd(), ss(), vtd(), fass(), mq()};
}

}  // namespace whittle::recipe
