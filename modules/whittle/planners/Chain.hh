/// \file
/// Several planners as one.
#pragma once

#include <tuple>

#include "whittle/plan/Stages.hh"

namespace whittle {

/// A planner that runs others one after the other, each planned afresh on what those before it leave. All
/// collapses of a planner come before those of the next.
template <typename... Planners>
struct Chain {
  std::tuple<Planners...> planners;

  /// \throw InvalidParameter  as the planners.
  void validate() const {
    std::apply([](const auto&... planner) { (planner.validate(), ...); }, planners);
  }

  /// Whether one of them does.
  bool moves_seams() const {
    return std::apply([](const auto&... planner) { return (detail::moves_seams(planner) || ...); }, planners);
  }

  /// Every planner with its threshold multiplied by `factor`, in [0, 1].
  Chain scaled(double factor) const {
    return {
        std::apply([&](const auto&... planner) { return std::tuple<Planners...>(planner.scaled(factor)...); },
                   planners)};
  }

  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const {
    validate();
    StagesT<Real> stages(surface);
    std::apply([&](const auto&... planner) { (stages.add(planner), ...); }, planners);
    return stages.take();
  }
};

}  // namespace whittle
