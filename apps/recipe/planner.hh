/// \file
/// From a specification to a planner.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "recipe/Spec.hh"
#include "whittle/FaceAngle.hh"
#include "whittle/VertexDistance.hh"

namespace whittle::recipe {

using Planner = std::variant<FaceAngle, VertexDistance>;

/// The planner of a spec; its threshold is the default where the spec gives none.
/// \throw RecipeError  two keys that contradict each other.
Planner make_planner(const Spec& spec, const Scale& scale);

/// Whether the spec says how far to go. Without that, a target must.
bool has_threshold(const Spec& spec);

/// Whether the module has a sensible threshold of its own when neither spec nor target give one.
bool has_default_threshold(const Spec& spec);

/// The planner with its threshold replaced, in the unit of `threshold_unit`.
Planner with_threshold(const Planner& planner, double threshold);

/// The key that sets the threshold, as the spec would name it: "angle", "distance".
std::string threshold_key(const Planner& planner);

/// Where to look for a threshold that reaches a target: from `first`, doubling, up to `last`.
struct ThresholdRange {
  double first, last;
};
ThresholdRange threshold_range(const Planner& planner, const Scale& scale);

}  // namespace whittle::recipe
