/// \file
/// Charts on test meshes: which chart each face is in, and the wedges that this makes.
#pragma once

#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "meshes.hh"

namespace meshes {

using Wedges = std::vector<std::array<std::uint32_t, 3>>;

/// One wedge for each vertex and chart: no slits.
inline Wedges wedges_of(const IndexedMesh& mesh, const std::vector<std::uint32_t>& chart) {
  Wedges out;
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    out.push_back({n * chart[f] + t[0], n * chart[f] + t[1], n * chart[f] + t[2]});
  }
  return out;
}

/// The chart of each face by its centre.
template <typename Chart>
std::vector<std::uint32_t> charts_by_centre(const IndexedMesh& mesh, Chart chart) {
  std::vector<std::uint32_t> out;
  for (const auto& t : mesh.triangles)
    out.push_back(chart(Point((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3)));
  return out;
}

/// Two charts: of the faces with their centres up to `x` and beyond.
inline std::vector<std::uint32_t> halves(const IndexedMesh& mesh, double x) {
  return charts_by_centre(mesh, [x](const Point& p) { return p.x() > x ? 1u : 0u; });
}

/// Charts of up to `size` faces that grow from faces drawn at random, in the same way for the same seed.
inline std::vector<std::uint32_t> grown_charts(const IndexedMesh& mesh, std::size_t size, unsigned seed) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> by_edge;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3];
      by_edge[std::minmax(a, b)].push_back(f);
    }
  std::vector<std::vector<std::uint32_t>> neighbours(mesh.triangles.size());
  for (const auto& [edge, faces] : by_edge)
    for (const std::uint32_t f : faces)
      for (const std::uint32_t g : faces)
        if (f != g) neighbours[f].push_back(g);
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> chart(mesh.triangles.size(), kNone), order(chart.size());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  std::uint32_t n_charts = 0;
  for (const std::uint32_t first : order) {
    if (chart[first] != kNone) continue;
    std::vector<std::uint32_t> faces = {first};
    chart[first] = n_charts;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const std::uint32_t g : neighbours[faces[i]])
        if (chart[g] == kNone && faces.size() < size) {
          chart[g] = n_charts;
          faces.push_back(g);
        }
    ++n_charts;
  }
  return chart;
}

}  // namespace meshes
