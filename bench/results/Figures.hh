/// \file
/// The figures of one set, from the raw times of its repetitions.
#pragma once

#include <optional>
#include <vector>

#include "results/Results.hh"
#include "results/Statistics.hh"

namespace whittle::bench {

/// Whether the improvement can be told from the spread.
enum class Certainty {
  clear,
  spread_exceeds_effect,  ///< largest minus smallest improvement is more than the median's distance from 0
  one_repetition          ///< nothing is known of the spread
};

/// Each visit is compared with the original's in the same repetition and the same start of the program, so a
/// machine that grows slower or faster meanwhile does not count. Medians and spreads are over these pairs.
struct Figures {
  double triangles_removed_percent = 0;
  std::vector<double> improvement_percent;  ///< one a pair, in the order of the visits
  Summary wall_total_ms, frame_mean_ms, frames_per_second, frames_per_second_gained;
  Summary improvement, frame_time_fall;
  std::optional<Summary> gl_total_ms;  ///< none where the driver has no timer
  Certainty certainty = Certainty::clear;
  std::size_t repetitions = 0;  ///< pairs that the figures rest on
};

/// None while no repetition has both the set's time and the original's.
std::optional<Figures> figures(const SetResult& set, const ExperimentResult& experiment);

/// Of one figure, relative to the set's original.
/// \pre values is not empty
Certainty certainty(const Summary& improvement, std::size_t repetitions);

}  // namespace whittle::bench
