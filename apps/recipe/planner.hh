/// \file
/// From a specification to a planner.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "recipe/Spec.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/Fass.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

namespace whittle::recipe {

using Planner =
    std::variant<FaceAngle, VertexDistance, Circumcenter, SphereScan, Vtd, Fass, MemorylessQuadric>;

/// The planner of a spec; its threshold is the default where the spec gives none.
/// \throw RecipeError  two keys that contradict each other.
Planner make_planner(const Spec& spec, const Scale& scale);

/// Whether the spec says how far to go. Without that, a target must, or the default does.
bool has_threshold(const Spec& spec);

/// The key that sets how far a module goes, as a spec would name it: "angle", "distance", "radius",
/// "max-err". Empty for `vt` and `mq`, which have no threshold.
std::string threshold_key(const Spec& spec);

/// Whether the module goes a sensible way when neither spec nor target say how far.
bool has_default_threshold(const Spec& spec);

/// Tells the planner how far to go, if it is one that wants to know: `mq`.
void set_target(Planner& planner, std::size_t faces, std::size_t vertices);

/// The planner with its threshold replaced. Of `fass`, the radius.
Planner with_threshold(const Planner& planner, double threshold);

/// The specification with its threshold added, in the shortest digits that name the number.
Spec with_threshold(Spec spec, double threshold);

/// That of `mq` with a bound in model units; its own stays if that is tighter.
Spec with_max_distance(Spec spec, double distance, const Scale& scale);

/// Where to look for a threshold that reaches a target: from `first`, doubling, up to `last`.
struct ThresholdRange {
  double first, last;
};
ThresholdRange threshold_range(const Planner& planner, const Scale& scale);

}  // namespace whittle::recipe
