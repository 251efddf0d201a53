/// \file
/// How far a collapse may turn a face.
#pragma once

#include "whittle/surface/errors.hh"

namespace whittle {

/// The flip guard. A cluster is refused if a surviving face would lie at more than about 78 degrees to its
/// *original* normal. Judged against the current normal instead, flips come back in chains of small turns.
struct FlipGuard {
  double min_cos = 0.2;  ///< least cosine between new and original normal, in [-1, 1); -1 turns the guard off

  /// \throw InvalidParameter
  void validate() const {
    if (!(min_cos >= -1 && min_cos < 1)) throw InvalidParameter("the flip guard's cosine must be in [-1, 1)");
  }
};

}  // namespace whittle
