#include "speed/textured/TexturedModel.hh"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "files/MeshFile.hh"
#include "speed/textured/atlas.hh"
#include "speed/textured/surfaces.hh"

namespace whittle::speed {
namespace {

using attributes::Attribute;
using attributes::Kind;
using Eigen::Vector2d;
using Eigen::Vector3d;

double terrain_height(double x, double y) {
  return 0.05 * std::sin(9 * x) * std::cos(7 * y) + 0.01 * std::sin(41 * x + 3) * std::sin(37 * y);
}
double soft_height(double x, double y) {
  return 0.05 * std::sin(5 * x) * std::cos(4 * y);
}
double dunes_height(double x, double y) {
  return 0.04 * std::sin(6 * x + 2 * y) + 0.006 * std::sin(30 * x - 11 * y);
}

Vector2d warped(double u, double v) {
  return {u + 0.03 * std::sin(24 * v + 1), v + 0.03 * std::sin(26 * u)};
}
Vector2d swirled(double u, double v) {
  const double x = u - 0.5, y = v - 0.5, turn = 0.8 * std::exp(-8 * (x * x + y * y));
  return {0.5 + std::cos(turn) * x - std::sin(turn) * y, 0.5 + std::sin(turn) * x + std::cos(turn) * y};
}
/// Two halves that mirror each other, without a doubled vertex between them.
Vector2d mirrored(double u, double v) {
  return {1 - std::abs(2 * u - 1), v};
}

Vector3d waves(double u, double v) {
  return Vector3d(0.5, 0.5, 0.5) + 0.5 * Vector3d(std::sin(20 * u), std::cos(15 * v), std::sin(12 * (u + v)));
}
Vector3d disc(double u, double v) {
  return std::hypot(u - 0.45, v - 0.55) < 0.2 ? Vector3d(0.9, 0.1, 0.1) : Vector3d(0.7, 0.7, 0.7);
}
Vector3d checkers(double u, double v) {
  const bool dark = (std::lround(std::floor(8 * u)) + std::lround(std::floor(8 * v))) % 2 != 0;
  return dark ? Vector3d(0.1, 0.1, 0.1) : Vector3d(0.9, 0.9, 0.9);
}
Vector3d rings(double u, double v) {
  const bool dark = std::lround(std::floor(14 * std::hypot(u - 0.3, v - 0.4))) % 2 != 0;
  return dark ? Vector3d(0.1, 0.2, 0.6) : Vector3d(0.9, 0.8, 0.3);
}

/// A model that is made only where it is asked for.
struct Recipe {
  std::string name;
  Half half;
  std::function<Painted()> make;
};

std::vector<Recipe> made_in_code() {
  const auto sphere = [](std::size_t faces_per_chart) {
    return [=] {
      Painted out = sphere_in_six_charts(40);
      if (faces_per_chart > 0) out.paint = grown_atlas(out.mesh, faces_per_chart);
      return out;
    };
  };
  const auto plate = [](double (*z)(double, double)) { return relief(98, 98, 1, 1, z); };
  const auto textured = [=](double (*z)(double, double), Vector2d (*texture)(double, double)) {
    return [=] { return with_texture(plate(z), texture); };
  };
  const auto coloured = [=](double (*z)(double, double), Vector3d (*colour)(double, double)) {
    return [=] { return with_colours(plate(z), colour); };
  };
  return {{"sphere-6", Half::tuning, sphere(0)},
          {"sphere-122", Half::held_out, sphere(400)},
          {"sphere-371", Half::tuning, sphere(100)},
          {"sphere-1196", Half::held_out, sphere(30)},
          {"sphere-3210", Half::tuning, sphere(10)},
          {"terrain-217", Half::held_out,
           [] {
             Painted out = relief(120, 80, 1.5, 1, terrain_height);
             out.paint = grown_atlas(out.mesh, 100);
             return out;
           }},
          {"hills-warped", Half::tuning, textured(terrain_height, warped)},
          {"soft-hills-warped", Half::tuning, textured(soft_height, warped)},
          {"dunes-swirled", Half::held_out, textured(dunes_height, swirled)},
          {"soft-hills-mirrored", Half::tuning, textured(soft_height, mirrored)},
          {"hills-mirrored", Half::held_out, textured(terrain_height, mirrored)},
          {"hills-checkers", Half::tuning, coloured(terrain_height, checkers)},
          {"soft-hills-disc", Half::tuning, coloured(soft_height, disc)},
          {"soft-hills-waves", Half::tuning, coloured(soft_height, waves)},
          {"dunes-rings", Half::held_out, coloured(dunes_height, rings)},
          {"dunes-disc", Half::held_out, coloured(dunes_height, disc)},
          {"hills-waves", Half::held_out, coloured(terrain_height, waves)}};
}

std::vector<Recipe> over_the_cache(const std::filesystem::path& cache) {
  const std::array<std::pair<const char*, Half>, 4> files = {{{"bunny.obj", Half::tuning},
                                                              {"armadillo.off", Half::held_out},
                                                              {"fandisk.off", Half::held_out},
                                                              {"dragon.ply", Half::held_out}}};
  std::vector<Recipe> out;
  for (const auto& [file, half] : files) {
    const std::filesystem::path path = cache / file;
    if (!std::filesystem::exists(path)) continue;
    const std::string stem = path.stem().string();
    out.push_back({stem + "-grown", half, [path] {
                     Painted made{files::read_mesh(path).mesh, {}};
                     made.paint = grown_atlas(made.mesh, 100);
                     return made;
                   }});
    out.push_back({stem + "-unwrapped", Half::held_out, [path] {
                     Painted made{files::read_mesh(path).mesh, {}};
                     made.paint = unwrapped_atlas(made.mesh, 60);
                     return made;
                   }});
    out.push_back({stem + "-cubed", Half::held_out, [path] {
                     Painted made{files::read_mesh(path).mesh, {}};
                     made.paint = cubic_atlas(made.mesh);
                     return made;
                   }});
  }
  return out;
}

TexturedModel read_model(const std::filesystem::path& path) {
  files::MeshFile file = files::read_mesh(path);
  const auto is_seen = [](const Attribute& a) { return a.kind == Kind::texture || a.kind == Kind::colour; };
  if (std::none_of(file.attributes.begin(), file.attributes.end(), is_seen))
    throw std::runtime_error(path.string() + ": there are neither texture coordinates nor colours");
  TexturedModel model{path.stem().string(), Half::given, std::move(file.mesh), {}};
  for (Attribute& attribute : file.attributes)
    if (is_seen(attribute)) model.attributes.push_back(std::move(attribute));
  return model;
}

}  // namespace

std::string to_string(Half half) {
  switch (half) {
    case Half::tuning:
      return "tuning";
    case Half::held_out:
      return "held out";
    default:
      return "given";
  }
}

std::vector<TexturedModel> textured_models(const std::filesystem::path& cache,
                                           const std::vector<std::filesystem::path>& files,
                                           const std::optional<std::regex>& only) {
  const auto is_wanted = [&](const std::string& name) { return !only || std::regex_search(name, *only); };
  std::vector<TexturedModel> given;  // first, as they may be wrong
  for (const auto& path : files)
    if (is_wanted(path.stem().string())) given.push_back(read_model(path));
  std::vector<Recipe> recipes = made_in_code();
  for (Recipe& recipe : over_the_cache(cache)) recipes.push_back(std::move(recipe));
  std::vector<TexturedModel> models;
  for (const Recipe& recipe : recipes) {
    if (!is_wanted(recipe.name)) continue;
    Painted made = recipe.make();
    models.push_back({recipe.name, recipe.half, std::move(made.mesh), {std::move(made.paint)}});
  }
  for (TexturedModel& model : given) models.push_back(std::move(model));
  return models;
}

}  // namespace whittle::speed
