/// \file
/// The edges of a triangle that a distance threshold lets fold.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "whittle/surface/Surface.hh"

namespace whittle::detail {

/// Which edges of a triangle are shorter than a threshold and join two vertices that may merge.
struct ShortEdges {
  int count = 0;
  int shortest = -1;  ///< edge i goes from corner i to the next
  bool is_short[3] = {};

  /// The two ends of the shortest. \pre count > 0
  std::array<std::uint32_t, 2> ends(const std::array<std::uint32_t, 3>& t) const {
    return {t[static_cast<std::size_t>(shortest)], t[static_cast<std::size_t>((shortest + 1) % 3)]};
  }

  /// \param max_distance  times the lesser tolerance of the two ends.
  /// \param taken         vertices that merge no more in this pass.
  template <typename Real>
  ShortEdges(const SurfaceT<Real>& surface, std::uint32_t face, double max_distance, Boundary boundary,
             Seams seams, const std::vector<std::uint8_t>& taken) {
    const auto& t = surface.triangle(face);
    double least = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (taken[a] || taken[b] || !surface.may_merge(a, b, boundary, seams)) continue;
      const double squared_length = (surface.point(b) - surface.point(a)).squaredNorm();
      const double limit = max_distance * std::min(surface.tolerance(a), surface.tolerance(b));
      if (!(squared_length < limit * limit)) continue;
      is_short[i] = true;
      ++count;
      if (shortest >= 0 && squared_length >= least) continue;
      shortest = static_cast<int>(i);
      least = squared_length;
    }
  }
};

}  // namespace whittle::detail
