#include "files/MeshBuilder.hh"

#include <algorithm>
#include <cmath>

#include "files/Fault.hh"

namespace whittle::files {

void CornerValues::add_triangle(std::size_t index, std::size_t last_corner) {
  if (face.empty()) return;
  triangles.resize(index, {no_value, no_value, no_value});
  triangles.push_back({face[0], face[last_corner - 1], face[last_corner]});
}

void MeshBuilder::add_point(double x, double y, double z) {
  if (!fixes_ && !(std::isfinite(x) && std::isfinite(y) && std::isfinite(z)))
    throw Fault("a coordinate is not finite");
  if (file_.mesh.points.size() == std::numeric_limits<std::uint32_t>::max())
    throw Fault("more vertices than 32-bit indices can name");
  file_.mesh.points.emplace_back(x, y, z);
}

std::uint32_t MeshBuilder::index(std::int64_t index, std::size_t vertices) const {
  if (index >= 0 && static_cast<std::uint64_t>(index) < vertices) return static_cast<std::uint32_t>(index);
  if (fixes_) return no_vertex;
  throw_index_out_of_range("vertex", index, vertices);
}

void MeshBuilder::add_face(const std::vector<std::uint32_t>& corners,
                           std::initializer_list<CornerValues*> values) {
  if (corners.size() < 3) {
    if (!fixes_) throw Fault("a face has fewer than three vertices");
    ++file_.report.broken_faces;
    return;
  }
  if (corners.size() > 3) ++file_.report.polygons;
  const std::uint32_t a = corners[0];
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::uint32_t b = corners[i - 1];
    const std::uint32_t c = corners[i];
    if (a == no_vertex || b == no_vertex || c == no_vertex) {
      ++file_.report.broken_faces;
    } else if (a == b || b == c || c == a) {
      ++file_.report.dropped_degenerate;
    } else {
      for (CornerValues* value : values) value->add_triangle(file_.mesh.triangles.size(), i);
      file_.mesh.triangles.push_back({a, b, c});
    }
  }
}

void MeshBuilder::add_attribute(attributes::Attribute attribute, CornerValues& corners) {
  if (corners.triangles.empty()) return;
  corners.triangles.resize(file_.mesh.triangles.size(), {no_value, no_value, no_value});
  attribute.corners = std::move(corners.triangles);
  file_.attributes.push_back(std::move(attribute));
}

void MeshBuilder::ignore(const std::string& what) {
  // An absurd file may have no end of names.
  constexpr std::size_t most = 100;
  std::vector<std::string>& ignored = file_.report.ignored;
  const std::string& note = ignored.size() < most ? what : "more";
  if (std::find(ignored.begin(), ignored.end(), note) == ignored.end()) ignored.push_back(note);
}

float MeshBuilder::component(double value) {
  const float narrow = static_cast<float>(value);
  if (std::isfinite(narrow)) return narrow;
  ++file_.report.zeroed_values;
  return 0;
}

void throw_index_out_of_range(const std::string& things, std::int64_t index, std::size_t count) {
  throw Fault(things + " index " + std::to_string(index) + " is out of range: there are " +
              std::to_string(count) + (things == "vertex" ? " vertices" : " of them"));
}

void check_declared(std::uint64_t count, const std::string& things, std::size_t least_bytes,
                    std::size_t remaining) {
  // One more, because the last line of a text file may lack its line end.
  if (count > remaining / least_bytes + 1)
    throw Fault("the file is cut off: " + std::to_string(count) + " " + things + " do not fit in the " +
                std::to_string(remaining) + " bytes left");
}

}  // namespace whittle::files
