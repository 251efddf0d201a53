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
  /// \param distances  whether to measure distances and flips, which takes long for millions of faces.
  Scorer(const Subject& subject, bool distances) : subject_(subject), distances_(distances) {}

  Score score(const Arrays& result);

 private:
  const Subject& subject_;
  bool distances_;
  std::map<std::uint64_t, Score> known_;
};

}  // namespace whittle::speed
