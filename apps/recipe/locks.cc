#include "recipe/locks.hh"

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <sstream>

#include "files/MeshFile.hh"
#include "measure/sides.hh"
#include "recipe/Spec.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/constants.hh"

namespace whittle::recipe {
namespace {

Eigen::Vector3d unit_normal(const IndexedMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.triangles[f];
  const Eigen::Vector3d a = mesh.points[t[0]];
  return (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).normalized();
}

void select(const std::string& file, const std::vector<std::uint32_t>& vertex_of,
            std::vector<std::uint8_t>& flags) {
  const std::size_t n_vertices = vertex_of.empty() ? flags.size() : vertex_of.size();
  std::istringstream in(files::read_file(file));
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
      const std::size_t vertex = vertex_of.empty() ? v : vertex_of[v];
      if (vertex < flags.size()) flags[vertex] |= kLocked;
    }
  }
}

}  // namespace

void Lock::apply(const IndexedMesh& mesh, const std::vector<std::uint32_t>& vertex_of,
                 std::vector<std::uint8_t>& flags) const {
  flags.resize(mesh.points.size(), 0);
  if (what == What::selection) return select(file, vertex_of, flags);
  const double least_cos = std::cos(degrees * (detail::kPi / 180));
  const auto lock = [&](const measure::Side& side, std::uint8_t flag) {
    flags[side.low] |= flag;
    flags[side.high] |= flag;
  };
  const auto sides = measure::sides_by_edge(mesh.triangles, mesh.points.size());
  measure::for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    if (what == What::boundary && end - begin == 1) lock(*begin, kLocked);
    if (what == What::feature && end - begin == 2 &&
        unit_normal(mesh, begin[0].face()).dot(unit_normal(mesh, begin[1].face())) < least_cos)
      lock(*begin, kFeature);
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
