#include "experiment/Figures.hh"

namespace whittle::bench {

Figures figures(const SetResult& set, const SetResult& original, const render::FrameRange& frames) {
  Figures result;
  result.triangles_removed_percent =
      100 * (1 - static_cast<double>(set.facts.faces) / static_cast<double>(original.facts.faces));

  const auto timed = static_cast<double>(frames.timed());
  std::vector<double> wall, gl, mean, rate;
  for (std::size_t i = 0; i < set.visits.size(); ++i) {
    const auto& time = set.visits[i].time;
    const double reference = original.visits[i].time.wall_ms;
    wall.push_back(time.wall_ms);
    mean.push_back(time.wall_ms / timed);
    rate.push_back(1000 * timed / time.wall_ms);
    if (time.gl_ms) gl.push_back(*time.gl_ms);
    result.improvement_percent.push_back(improvement_percent(reference, time.wall_ms));
    result.frame_time_fall_percent.push_back(frame_time_fall_percent(reference, time.wall_ms));
  }
  result.wall_total_ms = summarise(wall);
  result.frame_mean_ms = summarise(mean);
  result.frames_per_second = summarise(rate);
  result.improvement = summarise(result.improvement_percent);
  result.frame_time_fall = summarise(result.frame_time_fall_percent);
  if (!gl.empty()) result.gl_total_ms = summarise(gl);
  return result;
}

}  // namespace whittle::bench
