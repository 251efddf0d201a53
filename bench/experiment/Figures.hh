/// \file
/// The figures of one set, from the raw times of its repetitions.
#pragma once

#include <optional>
#include <vector>

#include "experiment/Experiment.hh"
#include "experiment/Statistics.hh"

namespace whittle::bench {

/// Each repetition's time is compared with the original's of the same repetition, so a machine that grows
/// slower or faster meanwhile does not count. Vectors have one entry for each repetition.
struct Figures {
  double triangles_removed_percent = 0;
  std::vector<double> improvement_percent, frame_time_fall_percent;
  Summary wall_total_ms, frame_mean_ms, frames_per_second, improvement, frame_time_fall;
  std::optional<Summary> gl_total_ms;  ///< none where the driver has no timer
};

/// \pre both sets were visited equally often, at least once.
Figures figures(const SetResult& set, const SetResult& original, const render::FrameRange& frames);

}  // namespace whittle::bench
