#include "measure/Excess.hh"

#include <algorithm>
#include <cmath>
#include <thread>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/blocks.hh"
#include "whittle/surface/errors.hh"

namespace whittle::measure {
namespace {

struct Found {
  std::vector<FarVertex> vertices;
  double max_squared = 0;
};

/// Each vertex once, with its largest distance.
std::vector<FarVertex> unique(std::vector<FarVertex> all) {
  std::sort(all.begin(), all.end(), [](const FarVertex& a, const FarVertex& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.distance > b.distance;
  });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const FarVertex& a, const FarVertex& b) { return a.vertex == b.vertex; }),
            all.end());
  return all;
}

Found far_vertices(const Surface& from, const ClosestFace& to, double bound, std::size_t samples,
                   const Crew& crew) {
  const auto distance = [&](Found& found, const Eigen::Vector3d& point) {
    const double squared = to.closest(point).squared_distance;
    found.max_squared = std::max(found.max_squared, squared);
    return std::sqrt(squared);
  };
  auto blocks = in_blocks<Found>(samples, crew, [&](std::size_t begin, std::size_t end) {
    Found found;
    for (std::size_t i = begin; i < end; ++i) {
      const double d = distance(found, from.sample(i, samples));
      if (d > bound)
        for (const std::uint32_t v : from.triangle(from.sampled_face(i, samples)))
          found.vertices.push_back({v, d});
    }
    return found;
  });
  const auto& vertices = from.vertices();
  const auto at_vertices = in_blocks<Found>(vertices.size(), crew, [&](std::size_t begin, std::size_t end) {
    Found found;
    for (std::size_t i = begin; i < end; ++i) {
      const double d = distance(found, from.point(vertices[i]));
      if (d > bound) found.vertices.push_back({vertices[i], d});
    }
    return found;
  });
  blocks.insert(blocks.end(), at_vertices.begin(), at_vertices.end());

  Found all;
  for (const Found& block : blocks) {
    all.vertices.insert(all.vertices.end(), block.vertices.begin(), block.vertices.end());
    all.max_squared = std::max(all.max_squared, block.max_squared);
  }
  all.vertices = unique(std::move(all.vertices));
  return all;
}

}  // namespace

Excess excess(const IndexedMesh& original, const IndexedMesh& simplified, double bound,
              const DistanceOptions& options, const Monitor& monitor) {
  if (options.samples == 0) throw InvalidParameter("the number of samples must be positive");
  if (!(bound >= 0)) throw InvalidParameter("the bound of a distance must not be negative");
  const unsigned threads =
      options.threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : options.threads;

  const Surface original_surface(original), simplified_surface(simplified);
  Watch watch(monitor, static_cast<double>(2 * options.samples + original_surface.vertices().size() +
                                           simplified_surface.vertices().size()));
  const auto go_on = [&watch] { return watch.done(0); };
  const ClosestFace on_original(original_surface, threads, go_on);
  const ClosestFace on_simplified(simplified_surface, threads, go_on);
  const Crew crew{threads, watch};
  Found forward = far_vertices(original_surface, on_simplified, bound, options.samples, crew);
  Found backward = far_vertices(simplified_surface, on_original, bound, options.samples, crew);
  return {std::move(forward.vertices), std::move(backward.vertices),
          std::sqrt(std::max(forward.max_squared, backward.max_squared))};
}

}  // namespace whittle::measure
