#include "recipe/Catalogue.hh"

#include <cmath>

#include "recipe/Spec.hh"

namespace whittle::recipe {
namespace {

Key number(std::string name, double min, double max, std::string meaning) {
  return {std::move(name), KeyKind::number, min, max, {}, std::move(meaning)};
}
Key integer(std::string name, double min, double max, std::string meaning) {
  return {std::move(name), KeyKind::integer, min, max, {}, std::move(meaning)};
}
Key length(std::string name, std::string meaning) {
  return {std::move(name), KeyKind::length, 0, HUGE_VAL, {}, std::move(meaning)};
}
Key choice(std::string name, std::vector<std::string> choices, std::string meaning) {
  return {std::move(name), KeyKind::choice, 0, 0, std::move(choices), std::move(meaning)};
}

std::vector<ModuleInfo> make_catalogue() {
  const Key passes = integer("passes", 1, 1000,
                             "repeat so often or until nothing changes; 1, or as often as a target needs");
  const Key guard = number("guard", -1, 0.999, "least cosine of a face's turn; 0.2, -1 is off");
  const Key boundary = choice("boundary", {"keep", "merge"}, "merge: along the boundary; keep");
  const Key angle = number("angle", 0, 180, "largest angle between face normals, degrees; 30");
  const Key included = number("included", 0, 180, "the same as an included angle, degrees; 150");
  const Key pairs = choice("pairs", {"adjacent", "all"}, "which faces are compared; adjacent");
  const Key count = integer("count", 1, 1e6, "how many of the angles must qualify; all");
  const Key area = number("area", 0, HUGE_VAL, "largest area of the vertex's faces, square units; none");
  const Key lock = choice("lock", {"ring", "strict"}, "what a removal keeps in place; ring");
  const Key apex = choice("apex", {"delaunay", "lexicographic"}, "where the new fan starts; delaunay");
  const Key radius = length("radius", "neighbours nearer than this merge; required without a target");
  const Key scan_placement =
      choice("placement", {"paper", "quadric"}, "midpoint, centre, centroid, or quadric; paper");
  const Key triangle_placement = choice("placement", {"enclosing", "circumcenter", "quadric"},
                                        "where a triangle's point lies; enclosing");
  const Key order = choice("order", {"index", "error"}, "error: the cheapest merges first; index");
  return {
      {"vt", Role::planned, "triangles become points", {triangle_placement, order, guard, passes}},
      {"fad",
       Role::planned,
       "removes vertices whose faces lie nearly in a plane",
       {angle, included, pairs, count, area, lock, apex, boundary, guard, passes}},
      {"ivdd",
       Role::planned,
       "folds short edges and small triangles to a point",
       {length("distance", "edges shorter than this fold; required without a target"), triangle_placement,
        order, boundary, guard, passes}},
      {"ss",
       Role::planned,
       "merges what a moving sphere covers",
       {radius, scan_placement, order, boundary, guard, passes}},
      {"vtd",
       Role::planned,
       "small triangles become points, else an edge folds",
       {length("distance", "edges shorter than this count; required without a target"),
        choice("fold", {"shortest", "literal"}, "which edge; shortest"), triangle_placement, boundary, guard,
        passes}},
      {"fass",
       Role::planned,
       "fad, then ss on what is left",
       {radius, scan_placement, order, angle, included, pairs, count, area, lock, apex, boundary, guard,
        passes}},
      {"mq",
       Role::planned,
       "down to the target, as true to the shape as possible; needs a target or a bound",
       {length("normals", "how far a difference of 1 counts as; 0"), length("colours", "the same; 0"),
        length("texture", "the same of texture coordinates; 0"),
        number("feature", 0, 180, "sharper edges keep their line, degrees; 180"),
        length("max-distance", "how far a vertex of the input may come to lie from the faces; no bound"),
        guard, passes}},
      {"quadric",
       Role::priority,
       "error quadrics, least error first; the boundary and the faces' sides are kept",
       {number("max-err", 0, HUGE_VAL, "largest quadric error, square units; required without a target"),
        number("boundary-weight", 0, HUGE_VAL, "weight of the boundary's edges; 10, 0 leaves it free"),
        guard}},
      {"normal-flipping",
       Role::constraint,
       "OpenMesh's ModNormalFlippingT",
       {number("angle", 0, 180, "largest turn of a face normal, degrees; 90")}},
      {"normal-deviation",
       Role::constraint,
       "OpenMesh's ModNormalDeviationT",
       {number("angle", 0, 360, "largest normal cone, degrees; 180")}},
      {"aspect-ratio",
       Role::constraint,
       "OpenMesh's ModAspectRatioT",
       {number("ratio", 1, HUGE_VAL, "largest aspect ratio of a triangle; 5")}},
      {"edge-length",
       Role::constraint,
       "OpenMesh's ModEdgeLengthT",
       {length("length", "longest edge that may collapse; no bound")}},
      {"hausdorff",
       Role::constraint,
       "OpenMesh's ModHausdorffT",
       {length("tolerance", "largest one-sided distance; 0.5% of the diagonal")}},
      {"roundness",
       Role::constraint,
       "OpenMesh's ModRoundnessT",
       {number("min", 0, 1, "least roundness; 0.1")}},
      {"independent-sets", Role::constraint, "OpenMesh's ModIndependentSetsT: a collapse locks its ring", {}},
  };
}

}  // namespace

const std::vector<ModuleInfo>& catalogue() {
  static const std::vector<ModuleInfo> modules = make_catalogue();
  return modules;
}

const ModuleInfo& find_module(const std::string& name) {
  std::string known;
  for (const ModuleInfo& module : catalogue()) {
    if (module.name == name) return module;
    known += (known.empty() ? "" : ", ") + module.name;
  }
  throw RecipeError("unknown module '" + name + "'; there are " + known);
}

std::string catalogue_help() {
  std::string text;
  for (const ModuleInfo& module : catalogue()) {
    text += "  " + module.name + ": " + module.meaning +
            (module.role == Role::constraint ? " (constraint)" : "") + "\n";
    for (const Key& key : module.keys) {
      text += "      " + key.name + "=";
      if (key.kind == KeyKind::length) text += "LENGTH";
      if (key.kind == KeyKind::number) text += "NUMBER";
      if (key.kind == KeyKind::integer) text += "N";
      for (std::size_t i = 0; i < key.choices.size(); ++i) text += (i ? "|" : "") + key.choices[i];
      text += "  " + key.meaning + "\n";
    }
  }
  return text;
}

}  // namespace whittle::recipe
