#include "speed/Score.hh"

#include "measure/MeshFacts.hh"
#include "peers/peers.hh"
#include "peers/precision.hh"
#include "whittle/surface/errors.hh"

namespace whittle::speed {

Score Scorer::score(const Arrays& result) {
  const std::uint64_t sum = checksum(result);
  const auto known = known_.find(sum);
  if (known != known_.end()) return known->second;

  Score score;
  const IndexedMesh mesh = peers::in_double(result);
  const auto facts = measure::facts(mesh);
  score.vertices = facts.vertices;
  score.faces = facts.faces;
  score.nonmanifold_edges = facts.nonmanifold_edges;
  score.nonmanifold_vertices = facts.nonmanifold_vertices;
  score.boundary_loops = facts.boundary_loops;
  score.components = facts.components;
  score.euler_characteristic = facts.euler_characteristic;
  score.checksum = sum;
#ifdef WHITTLE_WITH_CGAL
  if (intersections_) score.self_intersections = peers::cgal_self_intersections(result);
#endif
  try {
    measure::DistanceOptions options;
    options.samples = samples_;
    if (samples_ > 0) score.distance = measure::distance(peers::in_double(subject_.arrays), mesh, options);
  } catch (const InvalidMesh&) {
    // Nothing with an area is left: there is no distance to it.
  }
  return known_[sum] = score;
}

}  // namespace whittle::speed
