/// \file
/// The goals that the executors are held to, and whether they are reached.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "speed/json.hh"

namespace whittle::speed {

/// One ratio that a goal is about: of one module, or one target, or one size.
struct Ratio {
  std::string of;
  double value = 0;
  std::string remark;  ///< why it counts as missed although the value is good; else empty
};

/// A goal with all its ratios in one run on one model. It is reached if every one of them is.
struct Figure {
  enum class Bound { at_least, at_most };
  std::string what, against;
  std::string model, core;  ///< where it was measured
  Bound bound = Bound::at_most;
  double goal = 0;
  std::vector<Ratio> ratios;

  bool reached(const Ratio& ratio) const;
  bool reached() const;
};

/// Every goal that a run has the times for; ratios of medians of that run. Where a contender is missing, so
/// are its ratios, and a goal without ratios.
std::vector<Figure> figures(const Json& run);

/// An error of ours against a peer's, over all models of a suite where both leave as many faces, to two percent. Errors below
/// a millionth of the diagonal count as that.
struct MeanRatio {
  std::string ours, peer, share, error;
  double geometric_mean = 1, worst = 0;
  std::string worst_model;
  std::size_t models = 0;
};

/// The mean ratios of a suite, where at least two models have them.
std::vector<MeanRatio> mean_ratios(const Json& suite);

}  // namespace whittle::speed
