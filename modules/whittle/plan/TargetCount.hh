/// \file
/// How many faces or vertices may be left.
#pragma once

#include <cstddef>

namespace whittle {

/// A target as counts; 0: no such count. It is met when either count is.
struct TargetCount {
  std::size_t faces = 0, vertices = 0;

  bool any() const { return faces > 0 || vertices > 0; }
  /// Whether a mesh of so many faces and vertices has come to the target; false where there is none.
  bool is_met(std::size_t n_faces, std::size_t n_vertices) const {
    return (faces > 0 && n_faces <= faces) || (vertices > 0 && n_vertices <= vertices);
  }
};

}  // namespace whittle
