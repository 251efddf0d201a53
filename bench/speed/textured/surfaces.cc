#include "speed/textured/surfaces.hh"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace whittle::speed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

void add_place(attributes::Attribute& texture, double u, double v) {
  texture.values.push_back(static_cast<float>(u));
  texture.values.push_back(static_cast<float>(v));
}

attributes::Attribute no_places() {
  attributes::Attribute texture;
  texture.kind = attributes::Kind::texture;
  texture.components = 2;
  return texture;
}

}  // namespace

Painted sphere_in_six_charts(std::uint32_t n) {
  // The middle of each side, and the directions of its rows and columns.
  const std::array<std::array<Vector3d, 3>, 6> sides = {{{Vector3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                         {Vector3d{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                         {Vector3d{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                                         {Vector3d{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                         {Vector3d{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                                         {Vector3d{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}};
  Painted out{{}, no_places()};
  std::map<std::array<long, 3>, std::uint32_t> known;  // vertices by their places on the cube, in cells
  for (std::uint32_t side = 0; side < 6; ++side) {
    const auto& [middle, right, up] = sides[side];
    const auto base = static_cast<std::uint32_t>(out.paint.n_values());
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t j = 0; j <= n; ++j)
      for (std::uint32_t i = 0; i <= n; ++i) {
        const double a = 2.0 * i - n, b = 2.0 * j - n;
        const Vector3d on_cube = n * middle + a * right + b * up;
        const auto [found, is_new] = known.emplace(
            std::array{std::lround(on_cube.x()), std::lround(on_cube.y()), std::lround(on_cube.z())},
            static_cast<std::uint32_t>(out.mesh.points.size()));
        if (is_new) out.mesh.points.push_back(on_cube.normalized());
        vertices.push_back(found->second);
        constexpr double kRim = 0.02;
        add_place(out.paint, (side % 3 + kRim + (1 - 2 * kRim) * i / n) / 3,
                  (static_cast<double>(side / 3) + kRim + (1 - 2 * kRim) * j / n) / 2);
      }
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t at = j * (n + 1) + i;
        const std::array<std::uint32_t, 4> quad = {at, at + 1, at + n + 2, at + n + 1};
        for (const auto& [p, q, r] : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
          out.mesh.triangles.push_back({vertices[quad[p]], vertices[quad[q]], vertices[quad[r]]});
          out.paint.corners.push_back({base + quad[p], base + quad[q], base + quad[r]});
        }
      }
  }
  return out;
}

Painted relief(std::uint32_t columns, std::uint32_t rows, double width, double height,
               const std::function<double(double, double)>& z) {
  Painted out{{}, no_places()};
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
      out.mesh.points.emplace_back(width * u, height * v, z(width * u, height * v));
      add_place(out.paint, u, v);
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t at = j * (columns + 1) + i;
      out.mesh.triangles.push_back({at, at + 1, at + columns + 2});
      out.mesh.triangles.push_back({at, at + columns + 2, at + columns + 1});
    }
  return out;
}

Painted with_texture(Painted relief, const std::function<Vector2d(double, double)>& texture) {
  std::vector<float>& values = relief.paint.values;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const Vector2d place = texture(static_cast<double>(values[i]), static_cast<double>(values[i + 1]));
    values[i] = static_cast<float>(place.x());
    values[i + 1] = static_cast<float>(place.y());
  }
  return relief;
}

Painted with_colours(const Painted& relief, const std::function<Vector3d(double, double)>& colour) {
  Painted out{relief.mesh, {}};
  out.paint.kind = attributes::Kind::colour;
  out.paint.components = 3;
  for (std::uint32_t i = 0; i < relief.paint.n_values(); ++i) {
    const float* uv = relief.paint.value(i);
    const Vector3d rgb = colour(static_cast<double>(uv[0]), static_cast<double>(uv[1]));
    for (const double component : rgb) out.paint.values.push_back(static_cast<float>(component));
  }
  return out;
}

}  // namespace whittle::speed
