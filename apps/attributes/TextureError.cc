#include "attributes/TextureError.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include "attributes/transfer.hh"
#include "measure/ClosestFace.hh"
#include "measure/Surface.hh"
#include "measure/blocks.hh"
#include "measure/triangle.hh"
#include "whittle/surface/Lists.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/errors.hh"

namespace whittle::attributes {
namespace {

using Triangle = IndexedMesh::Triangle;

Eigen::Vector2d place(const Attribute& texture, std::uint32_t value) {
  const double v = static_cast<double>(texture.value(value)[1]);
  return {static_cast<double>(texture.value(value)[0]), texture.downwards ? 1 - v : v};
}

/// The corners' values of a face, at each corner of it.
std::array<Eigen::Vector2d, 3> places(const IndexedMesh& mesh, const Attribute& texture, std::size_t face) {
  std::array<Eigen::Vector2d, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = place(texture, texture.at(mesh, face, k));
  return out;
}

/// The texture's plane as a mesh, whose faces are those of `mesh`.
IndexedMesh unfolded(const IndexedMesh& mesh, const Attribute& texture) {
  IndexedMesh out;
  for (std::uint32_t i = 0; i < texture.n_values(); ++i) {
    const Eigen::Vector2d p = place(texture, i);
    out.points.emplace_back(p[0], p[1], 0);
  }
  out.triangles = texture.per_vertex() ? mesh.triangles : texture.corners;
  return out;
}

/// The value at the point of a face in which its corners have these shares.
Eigen::Vector2d blended(const std::array<double, 3>& shares, const std::array<Eigen::Vector2d, 3>& at) {
  return shares[0] * at[0] + shares[1] * at[1] + shares[2] * at[2];
}

Eigen::Vector3d centre(const measure::Corners& face) {
  return (face.a + face.b + face.c) / 3;
}

/// The chart of each face of the simplified mesh.
std::vector<std::uint32_t> charts_after(const IndexedMesh& original, const Attribute& before,
                                        const Charts& charts, const IndexedMesh& simplified,
                                        const Attribute& after, unsigned threads) {
  const IndexedMesh texture = unfolded(original, before), texture_after = unfolded(simplified, after);
  const measure::Surface surface(texture);
  const measure::ClosestFace closest(surface, threads);
  std::vector<std::uint32_t> out;
  for (std::size_t f = 0; f < simplified.triangles.size(); ++f) {
    const Eigen::Vector3d at = centre(measure::corners(texture_after, texture_after.triangles[f]));
    const auto nearest = closest.closest(at);
    constexpr double kTie = 1e-7;  // of the texture's size
    std::uint32_t face = surface.index(nearest.face);
    const Eigen::Vector3d in_space = centre(measure::corners(simplified, simplified.triangles[f]));
    double least = HUGE_VAL;
    for (const std::size_t i : closest.within(at, std::sqrt(nearest.squared_distance) + kTie)) {
      const auto corners = measure::corners(original, original.triangles[surface.index(i)]);
      const double distance = (measure::closest_point(in_space, corners) - in_space).squaredNorm();
      if (!(distance < least)) continue;
      least = distance;
      face = surface.index(i);
    }
    out.push_back(charts.of_face[face]);
  }
  return out;
}

/// Moves each chart into a cell of its own, far from the others, so that one search tree finds the nearest face of one
/// chart.
class Cells {
 public:
  Cells(const IndexedMesh& original, const IndexedMesh& simplified, std::size_t count)
      : per_side_(static_cast<std::uint32_t>(std::ceil(std::cbrt(static_cast<double>(count))))) {
    Eigen::AlignedBox3d box;
    for (const auto* mesh : {&original, &simplified})
      for (const auto& p : mesh->points) box.extend(p);
    size_ = 3 * box.diagonal().norm();
  }
  Eigen::Vector3d offset(std::uint32_t chart) const {
    const std::uint32_t row = chart / per_side_;
    const Eigen::Array3<std::uint32_t> place(chart % per_side_, row % per_side_, row / per_side_);
    return size_ * place.cast<double>().matrix();
  }

 private:
  std::uint32_t per_side_;
  double size_;
};

/// Of each face of the simplified mesh those of its chart that share a vertex with it but not the vertex's value: they are
/// on the other side of a slit, such as where a texture goes once around.
std::vector<std::vector<std::uint32_t>> across_slits(const IndexedMesh& mesh, const Attribute& texture,
                                                     const std::vector<std::uint32_t>& chart) {
  std::vector<std::vector<std::uint32_t>> out(mesh.triangles.size());
  if (texture.per_vertex()) return out;
  const detail::Lists corners = detail::Lists::of_corners(mesh.triangles, mesh.points.size());
  for (std::uint32_t f = 0; f < out.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, last] = corners.of(mesh.triangles[f][k]);
      const Eigen::Vector2d own = place(texture, texture.at(mesh, f, k));
      for (const std::uint32_t* c = first; c != last; ++c)
        if (chart[*c / 3] == chart[f] && place(texture, texture.at(mesh, *c / 3, *c % 3)) != own)
          out[f].push_back(*c / 3);
    }
    std::sort(out[f].begin(), out[f].end());
    out[f].erase(std::unique(out[f].begin(), out[f].end()), out[f].end());
  }
  return out;
}

struct Sums {
  double squared = 0, max_squared = 0;
  std::size_t samples = 0;
};

}  // namespace

TextureError texture_error(const IndexedMesh& original, const Attribute& before,
                           const IndexedMesh& simplified, const Attribute& after,
                           const TextureErrorOptions& options) {
  if (options.samples == 0) throw InvalidParameter("the number of samples must be positive");
  if (!(options.texels > 0) || !(options.texels_high >= 0))
    throw InvalidParameter("the number of texels must be positive");
  const unsigned threads =
      options.threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : options.threads;
  const std::vector<Triangle> wedges = before.per_vertex() ? original.triangles : seam_wedges({before});
  const Charts all = charts(original.triangles, wedges);
  const std::vector<std::uint32_t> chart_after =
      charts_after(original, before, all, simplified, after, threads);

  const Eigen::Vector2d texels(options.texels,
                               options.texels_high > 0 ? options.texels_high : options.texels);

  // The simplified mesh with its charts apart.
  const Cells cells(original, simplified, all.count);
  IndexedMesh apart;
  std::vector<bool> is_left(all.count, false);
  for (std::size_t f = 0; f < simplified.triangles.size(); ++f) {
    const auto n = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t v : simplified.triangles[f])
      apart.points.push_back(simplified.points[v] + cells.offset(chart_after[f]));
    apart.triangles.push_back({n, n + 1, n + 2});
    is_left[chart_after[f]] = true;
  }
  const measure::Surface from(original), to(apart);
  const measure::ClosestFace closest(to, threads);

  const auto across = across_slits(simplified, after, chart_after);

  // A slit runs elsewhere now, and where the nearest place is on its other side, the nearest one on this side is meant.
  const auto distance = [&](std::size_t i) {
    const Eigen::Vector3d p = from.sample(i, options.samples);
    const std::size_t face = from.sampled_face(i, options.samples);
    const std::uint32_t f = from.index(face), chart = all.of_face[f];
    if (!is_left[chart]) return -1.0;
    const Eigen::Vector3d in_cell = p + cells.offset(chart);
    const Eigen::Vector2d there = blended(measure::shares(from.face(face), p), places(original, before, f));
    const auto squared_at = [&](std::uint32_t g) {
      const measure::Corners corners = measure::corners(apart, apart.triangles[g]);
      const Eigen::Vector2d here = blended(measure::shares(corners, measure::closest_point(in_cell, corners)),
                                           places(simplified, after, g));
      return (here - there).cwiseProduct(texels).squaredNorm();
    };
    const std::uint32_t g = to.index(closest.closest(in_cell).face);
    double least = squared_at(g);
    for (const std::uint32_t other : across[g]) least = std::min(least, squared_at(other));
    return least;
  };
  const measure::Monitor nobody;
  measure::Watch watch(nobody, static_cast<double>(options.samples));
  const measure::Crew crew{threads, watch};
  const auto blocks =
      measure::in_blocks<Sums>(options.samples, crew, [&](std::size_t begin, std::size_t end) {
        Sums sums;
        for (std::size_t i = begin; i < end; ++i) {
          const double squared = distance(i);
          if (squared < 0) continue;
          ++sums.samples;
          sums.squared += squared;
          sums.max_squared = std::max(sums.max_squared, squared);
        }
        return sums;
      });
  TextureError error;
  error.charts = all.count;
  error.charts_left = static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), true));
  for (const Sums& sums : blocks) {
    error.samples += sums.samples;
    error.rms += sums.squared;
    error.max = std::max(error.max, sums.max_squared);
  }
  error.rms = error.samples > 0 ? std::sqrt(error.rms / static_cast<double>(error.samples)) : 0;
  error.max = std::sqrt(error.max);
  return error;
}

}  // namespace whittle::attributes
