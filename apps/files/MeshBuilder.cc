#include "files/MeshBuilder.hh"

#include <algorithm>
#include <cmath>

#include "files/Fault.hh"

namespace whittle::files {

void CornerValues::set_triangle(std::size_t index, const IndexedMesh::Triangle& of,
                                const std::uint32_t* values) {
  if (values == nullptr) return;
  if (triangles.size() <= index) triangles.resize(index + 1, {no_value, no_value, no_value});
  triangles[index] = {values[of[0]], values[of[1]], values[of[2]]};
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
  if (corners.size() == 3) {
    add_triangle(corners.data(), {0, 1, 2}, values);
    return;
  }
  ++file_.report.polygons;
  const std::uint32_t last = *std::max_element(corners.begin(), corners.end());
  if (last == no_vertex || last < file_.mesh.points.size()) {
    for (const IndexedMesh::Triangle& of : cut(corners.data(), corners.size()))
      add_triangle(corners.data(), of, values);
    return;
  }
  late_.push_back({file_.mesh.triangles.size(), late_corners_.size(), corners.size()});
  for (CornerValues* value : values) {
    value->late.resize(late_corners_.size(), no_value);
    value->late.insert(value->late.end(), value->face.begin(), value->face.end());
  }
  late_corners_.insert(late_corners_.end(), corners.begin(), corners.end());
  file_.mesh.triangles.resize(file_.mesh.triangles.size() + corners.size() - 2);
}

void MeshBuilder::add_triangle(const std::uint32_t* corners, const IndexedMesh::Triangle& of,
                               std::initializer_list<CornerValues*> values) {
  const std::uint32_t a = corners[of[0]], b = corners[of[1]], c = corners[of[2]];
  if (a == no_vertex || b == no_vertex || c == no_vertex) {
    ++file_.report.broken_faces;
  } else if (a == b || b == c || c == a) {
    ++file_.report.dropped_degenerate;
  } else {
    for (CornerValues* value : values)
      value->set_triangle(file_.mesh.triangles.size(), of,
                          value->face.empty() ? nullptr : value->face.data());
    file_.mesh.triangles.push_back({a, b, c});
  }
}

/// A fan where a place is not known. Two corners that name one vertex, one behind the other, count once.
const std::vector<IndexedMesh::Triangle>& MeshBuilder::cut(const std::uint32_t* corners, std::size_t n) {
  places_.clear();
  kept_.clear();
  cut_.clear();
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t vertex = corners[i];
    if (vertex >= file_.mesh.points.size() || !file_.mesh.points[vertex].allFinite()) {
      for (std::uint32_t k = 2; k < n; ++k) cut_.push_back({0, k - 1, k});
      return cut_;
    }
    if ((i > 0 && vertex == corners[i - 1]) || (i + 1 == n && vertex == corners[0])) continue;
    kept_.push_back(i);
    places_.push_back(file_.mesh.points[vertex]);
  }
  if (places_.size() >= 3) {
    count_shape(cutter_.cut(places_));
    if (places_.size() == n) return cutter_.triangles();
    for (const auto& [a, b, c] : cutter_.triangles()) cut_.push_back({kept_[a], kept_[b], kept_[c]});
  }
  cut_.resize(n - 2, {0, 0, 0});  // each of these is counted as one that names a vertex twice
  return cut_;
}

void MeshBuilder::count_shape(PolygonCutter::Shape shape) {
  using Shape = PolygonCutter::Shape;
  file_.report.concave_polygons += shape == Shape::concave ? 1 : 0;
  file_.report.crossing_polygons += shape == Shape::crossing ? 1 : 0;
  file_.report.flat_polygons += shape == Shape::flat ? 1 : 0;
}

void MeshBuilder::cut_late(std::initializer_list<CornerValues*> values) {
  for (CornerValues* value : values) value->late.resize(late_corners_.size(), no_value);
  for (const LatePolygon& polygon : late_) {
    const std::uint32_t* corners = late_corners_.data() + polygon.corner;
    std::size_t triangle = polygon.triangle;
    for (const IndexedMesh::Triangle& of : cut(corners, polygon.corners)) {
      for (CornerValues* value : values)
        value->set_triangle(triangle, of, value->late.data() + polygon.corner);
      file_.mesh.triangles[triangle++] = {corners[of[0]], corners[of[1]], corners[of[2]]};
    }
  }
  late_.clear();
}

void MeshBuilder::add_attribute(attributes::Attribute attribute, CornerValues& corners) {
  if (corners.triangles.empty()) return;
  corners.triangles.resize(file_.mesh.triangles.size(), {no_value, no_value, no_value});
  attribute.corners = std::move(corners.triangles);
  file_.attributes.push_back(std::move(attribute));
}

namespace {

void add_once(std::vector<std::string>& ignored, const std::string& what) {
  constexpr std::size_t most = 100;  // an absurd file may have no end of names
  const std::string& note = ignored.size() < most ? what : "more";
  if (std::find(ignored.begin(), ignored.end(), note) == ignored.end()) ignored.push_back(note);
}

}  // namespace

void MeshBuilder::ignore(const std::string& what) {
  add_once(file_.report.ignored, what);
}

void MeshBuilder::ignore_besides(const std::string& what) {
  add_once(file_.report.ignored_besides, what);
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
