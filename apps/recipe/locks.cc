#include "recipe/locks.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <tuple>

#include "recipe/Spec.hh"
#include "whittle/surface/Surface.hh"

namespace whittle::recipe {
namespace {

/// A half-edge by its ends in order, so that those of one edge lie side by side when sorted.
using Side = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // smaller end, larger end, face

std::vector<Side> sides(const IndexedMesh& mesh) {
  std::vector<Side> out;
  out.reserve(3 * mesh.triangles.size());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    for (int k = 0; k < 3; ++k)
      out.emplace_back(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), f);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Calls `visit(a, b, faces)` for each edge with the faces at it.
template <typename Visit>
void for_each_edge(const IndexedMesh& mesh, Visit visit) {
  const std::vector<Side> all = sides(mesh);
  std::vector<std::uint32_t> faces;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [a, b, f] = all[i];
    faces.push_back(f);
    if (i + 1 < all.size() && std::get<0>(all[i + 1]) == a && std::get<1>(all[i + 1]) == b) continue;
    visit(a, b, faces);
    faces.clear();
  }
}

Eigen::Vector3d unit_normal(const IndexedMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.triangles[f];
  const Eigen::Vector3d a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).normalized();
}

void select(const std::string& file, std::size_t n_vertices, std::vector<std::uint8_t>& flags) {
  std::ifstream in(file);
  if (!in) throw RecipeError(file + ": cannot be read");
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) {
      std::size_t v = 0;
      const char* end = word.data() + word.size();
      const auto [rest, error] = std::from_chars(word.data(), end, v);
      if (error != std::errc() || rest != end || v >= n_vertices)
        throw RecipeError(file + ":" + std::to_string(number) + ": '" + word.substr(0, 40) +
                          "' is not the number of a vertex, 0 to " +
                          std::to_string(n_vertices == 0 ? 0 : n_vertices - 1));
      flags[v] |= kLocked;
    }
  }
  if (in.bad()) throw RecipeError(file + ": cannot be read");
}

}  // namespace

void Lock::apply(const IndexedMesh& mesh, std::vector<std::uint8_t>& flags) const {
  flags.resize(mesh.points.size(), 0);
  if (what == What::selection) return select(file, mesh.points.size(), flags);
  const double least_cos = std::cos(degrees * (3.14159265358979323846 / 180));
  for_each_edge(mesh, [&](std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& faces) {
    if (what == What::boundary && faces.size() == 1) {
      flags[a] |= kLocked;
      flags[b] |= kLocked;
    }
    if (what == What::feature && faces.size() == 2 &&
        unit_normal(mesh, faces[0]).dot(unit_normal(mesh, faces[1])) < least_cos) {
      flags[a] |= kFeature;
      flags[b] |= kFeature;
    }
  });
}

Lock parse_lock(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (text == "boundary") return {Lock::What::boundary, 0, ""};
  if (name == "selection" && !value.empty()) return {Lock::What::selection, 0, value};
  if (name == "feature") {
    double degrees = 0;
    const char* end = value.data() + value.size();
    const auto [rest, error] = std::from_chars(value.data(), end, degrees);
    if (error == std::errc() && rest == end && degrees >= 0 && degrees <= 180)
      return {Lock::What::feature, degrees, ""};
    throw RecipeError("lock '" + text + "': the angle must be from 0 to 180 degrees");
  }
  throw RecipeError("unknown lock '" + text + "'; there are boundary, feature:DEGREES and selection:FILE");
}

}  // namespace whittle::recipe
