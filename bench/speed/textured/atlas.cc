#include "speed/textured/atlas.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

#include "measure/triangle.hh"
#include "whittle/surface/constants.hh"

namespace whittle::speed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint32_t kNone = 0xffffffffu;

/// For each face those that share an edge with it, in the order in which the edges are first met.
std::vector<std::vector<std::uint32_t>> neighbours(const IndexedMesh& mesh) {
  std::unordered_map<std::uint64_t, std::size_t> known;
  std::vector<std::vector<std::uint32_t>> edges, out(mesh.triangles.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]);
      const auto [edge, is_new] = known.emplace((std::uint64_t{low} << 32) | high, edges.size());
      if (is_new) edges.emplace_back();
      edges[edge->second].push_back(f);
    }
  for (const auto& faces : edges) {
    if (faces.size() != 2) continue;
    out[faces[0]].push_back(faces[1]);
    out[faces[1]].push_back(faces[0]);
  }
  return out;
}

/// The Mersenne twister's state from one word as its authors seed it with a key, which is also Python's way: the charts
/// are those of any program that draws so.
struct SeedByKey {
  using result_type = std::uint32_t;
  std::uint32_t key = 1;

  template <typename Iterator>
  void generate(Iterator begin, Iterator end) const {
    const auto n = static_cast<std::uint32_t>(end - begin);
    begin[0] = 19650218u;
    for (std::uint32_t i = 1; i < n; ++i) begin[i] = 1812433253u * (begin[i - 1] ^ (begin[i - 1] >> 30)) + i;
    std::uint32_t i = 1;
    const auto wrap = [&] {
      if (++i < n) return;
      begin[0] = begin[n - 1];
      i = 1;
    };
    for (std::uint32_t k = 0; k < n; ++k) {
      begin[i] = (begin[i] ^ ((begin[i - 1] ^ (begin[i - 1] >> 30)) * 1664525u)) + key;
      wrap();
    }
    for (std::uint32_t k = 0; k + 1 < n; ++k) {
      begin[i] = (begin[i] ^ ((begin[i - 1] ^ (begin[i - 1] >> 30)) * 1566083941u)) - i;
      wrap();
    }
    begin[0] = 0x80000000u;
  }
};

/// The numbers below n in random order.
std::vector<std::uint32_t> shuffled(std::uint32_t n) {
  SeedByKey seed;
  std::mt19937 random(seed);
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  for (std::uint32_t i = n; i-- > 1;) {
    std::uint32_t bits = 0;
    while ((std::uint64_t{i + 1} >> bits) > 0) ++bits;
    std::uint32_t drawn = i + 1;
    while (drawn > i) drawn = static_cast<std::uint32_t>(random()) >> (32 - bits);
    std::swap(order[i], order[drawn]);
  }
  return order;
}

/// Grows charts from the faces in an order, each as far as `joins(first, next, faces so far)` says.
/// \return the faces of each, the first one first.
template <typename Joins>
std::vector<std::vector<std::uint32_t>> grown(const std::vector<std::vector<std::uint32_t>>& next_to,
                                              const std::vector<std::uint32_t>& order, Joins joins) {
  std::vector<bool> is_taken(next_to.size(), false);
  std::vector<std::vector<std::uint32_t>> charts;
  for (const std::uint32_t first : order) {
    if (is_taken[first]) continue;
    std::vector<std::uint32_t> faces = {first};
    is_taken[first] = true;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const std::uint32_t g : next_to[faces[i]])
        if (!is_taken[g] && joins(first, g, faces.size())) {
          is_taken[g] = true;
          faces.push_back(g);
        }
    charts.push_back(std::move(faces));
  }
  return charts;
}

/// The directions in space of a texture's axes.
struct Plane {
  Vector3d right, up;
};

Plane plane_of(const IndexedMesh& mesh, std::uint32_t face) {
  const measure::Corners at = measure::corners(mesh, mesh.triangles[face]);
  const Vector3d right = (at.b - at.a).normalized(), edge = at.c - at.a;
  return {right, (edge - right.dot(edge) * right).normalized()};
}

/// A chart on a plane.
class Flattened {
 public:
  Flattened(const IndexedMesh& mesh, const std::vector<std::uint32_t>& faces, const Plane& plane) {
    const Vector3d origin = mesh.points[mesh.triangles[faces.front()][0]];
    for (const std::uint32_t f : faces)
      for (const std::uint32_t v : mesh.triangles[f]) {
        const Vector3d from = mesh.points[v] - origin;
        const auto [place, is_new] = places.emplace(v, Vector2d(plane.right.dot(from), plane.up.dot(from)));
        if (is_new) box.extend(place->second);
      }
  }

  std::map<std::uint32_t, Vector2d> places;  ///< of its vertices
  Eigen::AlignedBox2d box;
};

/// Puts charts together.
class Atlas {
 public:
  explicit Atlas(const IndexedMesh& mesh) : mesh_(mesh) {
    texture_.kind = attributes::Kind::texture;
    texture_.components = 2;
    texture_.corners.resize(mesh.triangles.size());
  }

  /// \param at  where the lower left corner of the chart's box goes.
  void add(const std::vector<std::uint32_t>& faces, const Flattened& flat, const Vector2d& at, double scale) {
    std::map<std::uint32_t, std::uint32_t> value;
    for (const auto& [v, place] : flat.places) {
      value.emplace(v, static_cast<std::uint32_t>(texture_.n_values()));
      const Vector2d uv = at + scale * (place - flat.box.min());
      texture_.values.push_back(static_cast<float>(uv.x()));
      texture_.values.push_back(static_cast<float>(uv.y()));
    }
    for (const std::uint32_t f : faces)
      for (std::size_t k = 0; k < 3; ++k) texture_.corners[f][k] = value.at(mesh_.triangles[f][k]);
  }

  attributes::Attribute take() { return std::move(texture_); }

 private:
  const IndexedMesh& mesh_;
  attributes::Attribute texture_;
};

std::vector<Vector3d> face_normals(const IndexedMesh& mesh) {
  std::vector<Vector3d> normals;
  for (const auto& t : mesh.triangles) normals.push_back(measure::corners(mesh, t).normal().normalized());
  return normals;
}

constexpr std::size_t kFewest = 12;  // faces of a chart that is made to follow the shape

/// Gives the faces of charts with fewer than so many to the chart next to each, largest first, where there is one.
void join_small(std::vector<std::vector<std::uint32_t>>& charts,
                const std::vector<std::vector<std::uint32_t>>& next_to, std::size_t fewest) {
  std::vector<std::uint32_t> chart_of(next_to.size(), kNone);
  for (std::uint32_t c = 0; c < charts.size(); ++c)
    for (const std::uint32_t f : charts[c]) chart_of[f] = c;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    if (charts[c].size() >= fewest) continue;
    std::uint32_t largest = kNone;
    for (const std::uint32_t f : charts[c])
      for (const std::uint32_t g : next_to[f]) {
        const std::uint32_t other = chart_of[g];
        if (other != c && (largest == kNone || charts[other].size() > charts[largest].size()))
          largest = other;
      }
    if (largest == kNone) continue;
    for (const std::uint32_t f : charts[c]) chart_of[f] = largest;
    charts[largest].insert(charts[largest].end(), charts[c].begin(), charts[c].end());
    charts[c].clear();
  }
  charts.erase(std::remove_if(charts.begin(), charts.end(), [](const auto& faces) { return faces.empty(); }),
               charts.end());
}

/// Puts charts in rows, the highest first, in one scale.
attributes::Attribute packed(const IndexedMesh& mesh, const std::vector<std::vector<std::uint32_t>>& charts,
                             const std::vector<Flattened>& flat) {
  double area = 0;
  for (const Flattened& chart : flat) area += chart.box.volume();
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return flat[a].box.sizes().y() > flat[b].box.sizes().y();
  });
  // Rows as wide as a square of all boxes; what they come to in the end decides the scale.
  const double width = 1.1 * std::sqrt(area), gap = 0.003 * width;
  std::vector<Vector2d> at(charts.size());
  Vector2d pen(gap, gap), end = Vector2d::Zero();
  double row = 0;
  for (const std::size_t i : order) {
    const Vector2d size = flat[i].box.sizes();
    if (pen.x() > gap && pen.x() + size.x() > width) {
      pen = {gap, pen.y() + row + gap};
      row = 0;
    }
    at[i] = pen;
    end = end.cwiseMax(pen + size);
    row = std::max(row, size.y());
    pen.x() += size.x() + gap;
  }
  const double scale = 1 / (end.maxCoeff() + gap);
  Atlas atlas(mesh);
  for (std::size_t i = 0; i < charts.size(); ++i) atlas.add(charts[i], flat[i], scale * at[i], scale);
  return atlas.take();
}

}  // namespace

attributes::Attribute grown_atlas(const IndexedMesh& mesh, std::size_t faces_per_chart) {
  const auto charts =
      grown(neighbours(mesh), shuffled(static_cast<std::uint32_t>(mesh.triangles.size())),
            [&](std::uint32_t, std::uint32_t, std::size_t size) { return size < faces_per_chart; });
  const double side = std::ceil(std::sqrt(static_cast<double>(charts.size())));
  Atlas atlas(mesh);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    constexpr double kRim = 0.03;  // of a cell, on each side
    const Flattened flat(mesh, charts[i], plane_of(mesh, charts[i].front()));
    const double size = flat.box.sizes().maxCoeff(), row = std::floor(static_cast<double>(i) / side);
    const Vector2d cell(static_cast<double>(i) - side * row, row);
    atlas.add(charts[i], flat, (cell + Vector2d(kRim, kRim)) / side,
              (1 - 2 * kRim) / (side * (size > 0 ? size : 1)));
  }
  return atlas.take();
}

attributes::Attribute unwrapped_atlas(const IndexedMesh& mesh, double degrees) {
  const auto next_to = neighbours(mesh);
  const std::vector<Vector3d> normals = face_normals(mesh);
  const double least = std::cos(degrees * detail::kPi / 180);
  auto charts = grown(next_to, shuffled(static_cast<std::uint32_t>(mesh.triangles.size())),
                      [&](std::uint32_t first, std::uint32_t next, std::size_t) {
                        return normals[first].dot(normals[next]) > least;
                      });
  join_small(charts, next_to, kFewest);
  std::vector<Flattened> flat;
  flat.reserve(charts.size());
  for (const auto& faces : charts) flat.emplace_back(mesh, faces, plane_of(mesh, faces.front()));
  return packed(mesh, charts, flat);
}

attributes::Attribute cubic_atlas(const IndexedMesh& mesh) {
  struct Look {
    int axis;
    bool forwards;
  };
  std::vector<Look> looks;
  for (const Vector3d& normal : face_normals(mesh)) {
    Look look{0, false};
    normal.cwiseAbs().maxCoeff(&look.axis);
    look.forwards = normal[look.axis] > 0;
    looks.push_back(look);
  }
  const auto next_to = neighbours(mesh);
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  auto charts = grown(next_to, order, [&](std::uint32_t first, std::uint32_t next, std::size_t) {
    return looks[first].axis == looks[next].axis && looks[first].forwards == looks[next].forwards;
  });
  join_small(charts, next_to, kFewest);
  std::vector<Flattened> flat;
  flat.reserve(charts.size());
  for (const auto& faces : charts) {
    const Look& look = looks[faces.front()];
    const Vector3d right = Vector3d::Unit((look.axis + 1) % 3), up = Vector3d::Unit((look.axis + 2) % 3);
    flat.emplace_back(mesh, faces, look.forwards ? Plane{right, up} : Plane{up, right});
  }
  return packed(mesh, charts, flat);
}

}  // namespace whittle::speed
