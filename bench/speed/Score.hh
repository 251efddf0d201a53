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
  std::size_t nonmanifold_vertices = 0, boundary_loops = 0, components = 0;
  long euler_characteristic = 0;
  std::optional<std::size_t> self_intersections;  ///< pairs of faces; none where it was not counted
  std::optional<measure::Distance> distance;      ///< none where it was not measured
  std::uint64_t checksum = 0;                     ///< of the result: equal meshes have equal ones
};

/// Scores results against one original. A mesh that was scored before, bit for bit, is not measured again.
class Scorer {
 public:
  /// \param samples  a side, for distances and flips; 0 leaves them out, since they take long for millions of
  /// faces.
  /// \param intersections  whether to count them, which takes CGAL
  Scorer(const Subject& subject, std::size_t samples, bool intersections)
      : subject_(subject), samples_(samples), intersections_(intersections) {}

  Score score(const Arrays& result);

 private:
  const Subject& subject_;
  std::size_t samples_;
  bool intersections_;
  std::map<std::uint64_t, Score> known_;
};

}  // namespace whittle::speed
