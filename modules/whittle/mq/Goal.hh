/// \file
/// How far there is to go.
#pragma once

#include <algorithm>
#include <cstddef>

#include "whittle/plan/CollapsePlan.hh"

namespace whittle::mq {

/// What must still vanish.
struct Goal {
  std::size_t faces = 0, vertices = 0;  ///< the goal is reached when either is 0
  std::size_t all = 1;                  ///< what `remaining` was at the start

  std::size_t remaining() const { return std::min(faces, 2 * vertices); }  ///< in faces
  void count(const Collapse& collapse) {
    faces -= std::min<std::size_t>(faces, collapse.faces);
    vertices -= vertices > 0;
  }
};

}  // namespace whittle::mq
