/// \file
/// The measurement: interleaved rounds, one score and one count of memory for each contender.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "speed/Contender.hh"
#include "speed/Score.hh"
#include "speed/lineup.hh"
#include "terminal/Progress.hh"

namespace whittle::speed {

/// Models of more faces are large: heavy contenders get at most kHeavyRounds rounds, and no count of memory.
inline constexpr std::size_t kLargeFaces = 500000;
inline constexpr std::size_t kHeavyRounds = 3;

struct Settings {
  Suite suite = Suite::figures;
  std::size_t rounds = 7;
  std::optional<std::regex> only;  ///< contenders in whose name it is found
  std::size_t samples = 200000;    ///< a side, for distances
};

/// Bytes on the heap.
struct Memory {
  std::int64_t loaded = 0;  ///< the model in the contender's own form, or the arrays it reads in place
  std::int64_t peak = 0;    ///< the most at once while decimating: model, working memory and output
};

/// All that was found out about one contender on one model. One value for each round.
struct Result {
  Entry entry;
  std::vector<double> seconds, load_seconds, unload_seconds;
  std::vector<std::pair<std::string, std::vector<double>>> phase_seconds;
  std::optional<Score> score;  ///< none where there is no mesh to score
  std::optional<Memory> memory;
};

struct ModelResults {
  const Subject* subject = nullptr;
  std::vector<Result> results;
  std::optional<Score> input = {};  ///< of the model itself, in the suite of truth
  /// `measure::smooth_limit`, the least RMS distance times faces, in percent of the diagonal.
  double smooth_limit = 0;
};

/// Every round visits every contender on every model, in an order of its own (shuffled, the same on every
/// run), so that a machine that grows slower or faster affects all alike and no contender always follows the
/// same other. The rounds are preceded by an untimed one, in which memory is counted and results are scored.
std::vector<ModelResults> run_rounds(const Settings& settings, const std::vector<Subject>& subjects,
                                     terminal::Progress& progress);

}  // namespace whittle::speed
