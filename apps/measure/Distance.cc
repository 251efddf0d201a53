#include "measure/Distance.hh"

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/blocks.hh"
#include "whittle/surface/errors.hh"

namespace whittle::measure {

namespace {

/// What a face costs in a search tree, compared with a search for a closest point.
constexpr double kTreeWork = 0.25;

struct Sums {
  double distance = 0, squared = 0, max_squared = 0;
};

Deviation deviation(const Surface& from, const ClosestFace& to, std::size_t samples, const Crew& crew) {
  const auto sampled = in_blocks<Sums>(samples, crew, [&](std::size_t begin, std::size_t end) {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i) {
      const double squared = to.closest(from.sample(i, samples)).squared_distance;
      sums.distance += std::sqrt(squared);
      sums.squared += squared;
      sums.max_squared = std::max(sums.max_squared, squared);
    }
    return sums;
  });
  const auto& vertices = from.vertices();
  const auto at_vertices = in_blocks<double>(vertices.size(), crew, [&](std::size_t begin, std::size_t end) {
    double max_squared = 0;
    for (std::size_t i = begin; i < end; ++i) {
      max_squared = std::max(max_squared, to.closest(from.point(vertices[i])).squared_distance);
    }
    return max_squared;
  });

  Sums total;
  for (const Sums& sums : sampled) {
    total.distance += sums.distance;
    total.squared += sums.squared;
    total.max_squared = std::max(total.max_squared, sums.max_squared);
  }
  for (const double max_squared : at_vertices) total.max_squared = std::max(total.max_squared, max_squared);

  const auto count = static_cast<double>(samples);
  return {std::sqrt(total.squared / count), total.distance / count, std::sqrt(total.max_squared), samples};
}

/// Where several original faces are equally near, as across a sharp edge, a face is flipped only if it is
/// turned against all of them: which of them comes first is chance.
std::size_t count_flipped(const Surface& simplified, const Surface& original,
                          const ClosestFace& closest_original, double diagonal, const Crew& crew) {
  const auto counts =
      in_blocks<std::size_t>(simplified.size(), crew, [&](std::size_t begin, std::size_t end) {
        std::size_t flipped = 0;
        for (std::size_t i = begin; i < end; ++i) {
          const Corners face = simplified.face(i);
          const Eigen::Vector3d normal = face.normal(), centroid = (face.a + face.b + face.c) / 3;
          const auto turned = [&](std::size_t other) {
            return normal.dot(original.face(other).normal()) < 0;
          };

          const auto nearest = closest_original.closest(centroid);
          if (!turned(nearest.face)) continue;
          const double tie = std::sqrt(nearest.squared_distance) * (1 + 1e-9) + 1e-12 * diagonal;
          const auto equally_near = closest_original.distinct_within(centroid, tie);
          if (std::all_of(equally_near.begin(), equally_near.end(), turned)) ++flipped;
        }
        return flipped;
      });
  std::size_t total = 0;
  for (const std::size_t count : counts) total += count;
  return total;
}

double box_diagonal(const IndexedMesh& mesh) {
  Eigen::Vector3d low = mesh.points.front(), high = low;
  for (const auto& point : mesh.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}

}  // namespace

Distance distance(const IndexedMesh& original, const IndexedMesh& simplified, const DistanceOptions& options,
                  const Monitor& monitor) {
  if (options.samples == 0) throw InvalidParameter("the number of samples must be positive");
  const unsigned threads =
      options.threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : options.threads;

  const Surface original_surface(original), simplified_surface(simplified);
  const double on_trees =
      kTreeWork * static_cast<double>(original_surface.size() + simplified_surface.size());
  Watch watch(monitor, on_trees + static_cast<double>(
                                      2 * options.samples + original_surface.vertices().size() +
                                      simplified_surface.vertices().size() + simplified_surface.size()));
  const auto go_on = [&watch] { return watch.done(0); };
  const ClosestFace on_original(original_surface, threads, go_on);
  const ClosestFace on_simplified(simplified_surface, threads, go_on);
  watch.done(on_trees);
  const Crew crew{threads, watch};

  Distance result;
  result.diagonal = box_diagonal(original);
  result.forward = deviation(original_surface, on_simplified, options.samples, crew);
  result.backward = deviation(simplified_surface, on_original, options.samples, crew);
  const Deviation &forward = result.forward, &backward = result.backward;
  result.two_sided.rms = std::sqrt((forward.rms * forward.rms + backward.rms * backward.rms) / 2);
  result.two_sided.mean = (forward.mean + backward.mean) / 2;
  result.two_sided.max = std::max(forward.max, backward.max);
  result.two_sided.samples = forward.samples + backward.samples;
  result.flipped_faces =
      count_flipped(simplified_surface, original_surface, on_original, result.diagonal, crew);
  return result;
}

}  // namespace whittle::measure
