#include "model/StandIn.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "whittle/bulk.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/surface/errors.hh"

namespace whittle::viewer {

std::shared_ptr<const StandIn> make_stand_in(const IndexedMesh& mesh, std::size_t triangles) {
  if (mesh.triangles.size() < 2 * triangles) return nullptr;
  MemorylessQuadric coarse;
  coarse.target_faces = triangles;
  try {
    auto made = bulk(coarse, mesh);
    if (made.mesh.triangles.size() > std::min(3 * triangles, mesh.triangles.size() / 2)) return nullptr;
    render::MeshArrays arrays(made.mesh);
    return std::make_shared<StandIn>(
        StandIn{std::move(made.mesh.triangles), std::move(made.vertex_map), std::move(arrays)});
  } catch (const InvalidMesh&) {  // what cannot be decimated can still be looked at
    return nullptr;
  }
}

std::vector<float> values_on(const StandIn& stand_in, const std::vector<float>& values) {
  if (values.empty()) return {};
  std::vector<float> sums(stand_in.arrays.positions.size(), 0);
  std::vector<float> counts(sums.size(), 0);
  for (std::size_t v = 0; v < values.size(); ++v) {
    sums[stand_in.vertex_map[v]] += values[v] * values[v];
    counts[stand_in.vertex_map[v]] += 1;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = std::sqrt(sums[v] / std::max(counts[v], 1.0f));
  return sums;
}

}  // namespace whittle::viewer
