#include "experiment/GeneratedMesh.hh"

#include <cmath>
#include <map>

namespace whittle::bench {
namespace {

constexpr std::array<IndexedMesh::Triangle, 20> kIcosahedron = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::vector<Eigen::Vector3d> icosahedron_corners() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
          {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
}

/// Cuts faces into rows of triangles and gives vertices on shared corners and edges one number.
class Subdivision {
 public:
  explicit Subdivision(int frequency) : frequency_(frequency), corners_(icosahedron_corners()) {
    for (const auto& face : kIcosahedron) cut(face);
  }

  IndexedMesh mesh;

 private:
  /// The vertex with these whole-numbered weights on the face's corners; the weights sum to the frequency.
  std::uint32_t vertex(const IndexedMesh::Triangle& face, const std::array<int, 3>& weights) {
    // Corners of weight zero are left out of the key, so neighbouring faces agree on it.
    std::map<std::uint32_t, int> key;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0) continue;
      key[face[i]] = weights[i];
      point += weights[i] * corners_[face[i]];
    }
    const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh.points.size()));
    if (fresh) mesh.points.push_back(point.normalized());
    return entry->second;
  }

  void cut(const IndexedMesh::Triangle& face) {
    const int f = frequency_;
    for (int i = 0; i < f; ++i) {
      for (int j = 0; i + j < f; ++j) {
        const int k = f - i - j;
        const auto a = vertex(face, {k, i, j}), b = vertex(face, {k - 1, i + 1, j}),
                   c = vertex(face, {k - 1, i, j + 1});
        mesh.triangles.push_back({a, b, c});
        if (i + j + 1 < f) mesh.triangles.push_back({b, vertex(face, {k - 2, i + 1, j + 1}), c});
      }
    }
  }

  int frequency_;
  std::vector<Eigen::Vector3d> corners_;
  std::map<std::map<std::uint32_t, int>, std::uint32_t> numbers_;
};

/// The distance from the centre in a direction: smooth bumps of a few sizes, nowhere steep enough to fold
/// over.
double radius(const Eigen::Vector3d& d) {
  return 1 + 0.12 * std::sin(3.0 * d.x() + 0.7) * std::sin(2.0 * d.y() + 1.9) +
         0.05 * std::sin(7.0 * d.y() + 5.0 * d.z()) + 0.025 * std::sin(13.0 * d.z() - 11.0 * d.x() + 0.4) +
         0.008 * std::sin(29.0 * d.x() + 23.0 * d.y() + 1.1);
}

}  // namespace

double mean_edge_length(const IndexedMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += (mesh.points[a] - mesh.points[b]).norm() + (mesh.points[b] - mesh.points[c]).norm() +
           (mesh.points[c] - mesh.points[a]).norm();
  return sum / static_cast<double>(3 * mesh.triangles.size());
}

IndexedMesh generated_mesh(int frequency, double mean_edge) {
  IndexedMesh mesh = std::move(Subdivision(frequency).mesh);
  for (auto& point : mesh.points) point *= radius(point);
  const double scale = mean_edge / mean_edge_length(mesh);
  for (auto& point : mesh.points) point *= scale;
  return mesh;
}

}  // namespace whittle::bench
