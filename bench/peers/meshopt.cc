#include <meshoptimizer.h>

#include <chrono>
#include <limits>

#include "peers/Peers.hh"

namespace whittle::bench {
namespace {

std::vector<float> coordinates(const IndexedMesh& mesh) {
  std::vector<float> values;
  values.reserve(3 * mesh.points.size());
  for (const auto& point : mesh.points)
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(point[axis]));
  return values;
}

std::vector<unsigned> indices(const IndexedMesh& mesh) {
  std::vector<unsigned> values;
  values.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) values.insert(values.end(), triangle.begin(), triangle.end());
  return values;
}

/// The triangles of `values`, with the points of `mesh` that they use, in their old order.
IndexedMesh compacted(const IndexedMesh& mesh, const std::vector<unsigned>& values) {
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.points.size(), kUnused);
  for (const unsigned index : values) place[index] = 0;
  IndexedMesh out;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == kUnused) continue;
    place[i] = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(mesh.points[i]);
  }
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    out.triangles.push_back({place[values[i]], place[values[i + 1]], place[values[i + 2]]});
  return out;
}

}  // namespace

PeerResult simplify_meshopt(const IndexedMesh& mesh, std::size_t triangles) {
  const auto points = coordinates(mesh);
  const auto before = indices(mesh);
  std::vector<unsigned> after(before.size());
  constexpr float kAnyError = 1;  // of the model's extent: only the target counts
  const auto start = std::chrono::steady_clock::now();
  after.resize(meshopt_simplify(after.data(), before.data(), before.size(), points.data(), mesh.points.size(),
                                3 * sizeof(float), 3 * triangles, kAnyError, 0, nullptr));
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {compacted(mesh, after), time.count()};
}

IndexedMesh vertex_cache_order(const IndexedMesh& mesh) {
  const auto before = indices(mesh);
  std::vector<unsigned> after(before.size());
  meshopt_optimizeVertexCache(after.data(), before.data(), before.size(), mesh.points.size());
  IndexedMesh out;
  out.points = mesh.points;
  for (std::size_t i = 0; i + 2 < after.size(); i += 3)
    out.triangles.push_back({after[i], after[i + 1], after[i + 2]});
  return out;
}

double cache_misses_per_triangle(const IndexedMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const auto order = indices(mesh);
  return static_cast<double>(
      meshopt_analyzeVertexCache(order.data(), order.size(), mesh.points.size(), 16, 0, 0).acmr);
}

}  // namespace whittle::bench
