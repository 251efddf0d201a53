#include "results/Figures.hh"

#include <algorithm>
#include <cmath>

namespace whittle::bench {
namespace {

const Visit* visit_beside(const SetResult& original, const Visit& visit) {
  for (const Visit& other : original.visits)
    if (other.repetition == visit.repetition && other.start == visit.start) return &other;
  return nullptr;
}

}  // namespace

Certainty certainty(const Summary& improvement, std::size_t repetitions) {
  if (repetitions < 2) return Certainty::one_repetition;
  return improvement.max - improvement.min > std::abs(improvement.median) ? Certainty::spread_exceeds_effect
                                                                          : Certainty::clear;
}

std::optional<Figures> figures(const SetResult& set, const ExperimentResult& experiment) {
  const SetResult& original = experiment.sets.front();
  const auto timed = static_cast<double>(experiment.timing.frames_timed());
  Figures result;
  std::vector<double> wall, gl, mean, rate, gained, fall;
  for (const Visit& visit : set.visits) {
    const Visit* const reference = visit_beside(original, visit);
    if (reference == nullptr) continue;
    wall.push_back(visit.wall_ms);
    mean.push_back(visit.wall_ms / timed);
    rate.push_back(1000 * timed / visit.wall_ms);
    gained.push_back(rate.back() - 1000 * timed / reference->wall_ms);
    if (visit.gl_ms) gl.push_back(*visit.gl_ms);
    result.improvement_percent.push_back(improvement_percent(reference->wall_ms, visit.wall_ms));
    fall.push_back(frame_time_fall_percent(reference->wall_ms, visit.wall_ms));
  }
  if (wall.empty()) return std::nullopt;
  result.triangles_removed_percent =
      original.triangles == 0
          ? 0
          : 100 * (1 - static_cast<double>(set.triangles) / static_cast<double>(original.triangles));
  result.wall_total_ms = summarise(wall);
  result.frame_mean_ms = summarise(mean);
  result.frames_per_second = summarise(rate);
  result.frames_per_second_gained = summarise(gained);
  result.improvement = summarise(result.improvement_percent);
  result.frame_time_fall = summarise(fall);
  if (!gl.empty()) result.gl_total_ms = summarise(gl);
  result.repetitions = wall.size();
  result.certainty = certainty(result.improvement, wall.size());
  return result;
}

}  // namespace whittle::bench
