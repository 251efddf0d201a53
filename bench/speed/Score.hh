/// \file
/// What a result is worth, beside the time it took.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "measure/Distance.hh"
#include "speed/Subject.hh"

namespace whittle::speed {

struct Score {
  std::size_t vertices = 0, faces = 0, nonmanifold_edges = 0;
  std::optional<measure::Distance> distance;  ///< none where it was not measured
  std::uint64_t checksum = 0;                 ///< of the result: equal meshes have equal ones
};

/// Scores results against one original. A mesh that was scored before, bit for bit, is not measured again.
class Scorer {
 public:
  /// \param samples  a side, for distances and flips; 0 leaves them out, since they take long for millions of
  /// faces.
  Scorer(const Subject& subject, std::size_t samples) : subject_(subject), samples_(samples) {}

  Score score(const Arrays& result);

 private:
  const Subject& subject_;
  std::size_t samples_;
  std::map<std::uint64_t, Score> known_;
};

}  // namespace whittle::speed
