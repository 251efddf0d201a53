#include "files/subset.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "files/settle.hh"

namespace whittle::files {
namespace {

/// Leaves the entries that are marked; an entry is `width` values long.
template <typename T>
void keep_entries(std::vector<T>& entries, const std::vector<bool>& keep, std::size_t width = 1) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    for (std::size_t k = 0; k < width; ++k) entries[kept * width + k] = entries[i * width + k];
    ++kept;
  }
  entries.resize(kept * width);
}

std::size_t count_unmarked(const std::vector<bool>& keep) {
  return static_cast<std::size_t>(std::count(keep.begin(), keep.end(), false));
}

}  // namespace

std::size_t keep_faces(MeshFile& file, const std::vector<bool>& keep) {
  const std::size_t going = count_unmarked(keep);
  if (going == 0) return 0;
  keep_entries(file.mesh.triangles, keep);
  if (!file.parts.of_face.empty()) keep_entries(file.parts.of_face, keep);
  for (attributes::Attribute& attribute : file.attributes) {
    if (attribute.per_vertex()) continue;
    keep_entries(attribute.corners, keep);
    // Without faces it would not show any more that the values are not those of the vertices.
    if (attribute.corners.empty()) settle(attribute, file.mesh);
  }
  return going;
}

std::size_t keep_vertices(MeshFile& file, const std::vector<bool>& keep) {
  const std::size_t going = count_unmarked(keep);
  if (going == 0) return 0;
  std::vector<std::uint32_t> number;
  number.reserve(keep.size());
  std::uint32_t next = 0;
  for (const bool stays : keep) number.push_back(stays ? next++ : MeshFile::left_out);

  keep_entries(file.mesh.points, keep);
  for (attributes::Attribute& attribute : file.attributes)
    if (attribute.per_vertex()) keep_entries(attribute.values, keep, attribute.components);
  for (IndexedMesh::Triangle& triangle : file.mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = number[corner];
  if (file.vertex_of.empty()) {
    file.vertex_of = std::move(number);
  } else {
    for (std::uint32_t& vertex : file.vertex_of)
      if (vertex != MeshFile::left_out) vertex = number[vertex];
  }
  return going;
}

void copy_vertices(MeshFile& file, const std::vector<std::uint32_t>& originals) {
  if (file.vertex_of.empty()) {
    file.vertex_of.resize(file.mesh.points.size());
    std::iota(file.vertex_of.begin(), file.vertex_of.end(), 0U);
  }
  file.mesh.points.reserve(file.mesh.points.size() + originals.size());
  for (const std::uint32_t original : originals) file.mesh.points.push_back(file.mesh.points[original]);
  for (attributes::Attribute& attribute : file.attributes) {
    if (!attribute.per_vertex()) continue;
    attribute.values.reserve(attribute.values.size() + attribute.components * originals.size());
    for (const std::uint32_t original : originals)
      for (std::size_t k = 0; k < attribute.components; ++k)
        attribute.values.push_back(attribute.values[attribute.components * original + k]);
  }
}

FacesAlone faces_alone(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                       const std::vector<std::uint32_t>& faces) {
  FacesAlone out;
  const auto numbers = [&](auto value_of) {
    std::vector<std::uint32_t> used;
    for (const std::uint32_t face : faces)
      for (std::size_t k = 0; k < 3; ++k) used.push_back(value_of(face, k));
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
  };
  const auto number_in = [](const std::vector<std::uint32_t>& used, std::uint32_t value) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), value) - used.begin());
  };
  out.vertices = numbers([&](std::uint32_t face, std::size_t k) { return mesh.triangles[face][k]; });
  for (const std::uint32_t vertex : out.vertices) out.mesh.points.push_back(mesh.points[vertex]);
  for (const std::uint32_t face : faces) {
    IndexedMesh::Triangle triangle = mesh.triangles[face];
    for (std::uint32_t& corner : triangle) corner = number_in(out.vertices, corner);
    out.mesh.triangles.push_back(triangle);
  }
  for (const attributes::Attribute& attribute : attributes) {
    attributes::Attribute alone;
    alone.kind = attribute.kind;
    alone.name = attribute.name;
    alone.components = attribute.components;
    alone.bytes = attribute.bytes;
    alone.downwards = attribute.downwards;
    alone.names = attribute.names;
    const std::vector<std::uint32_t> used =
        attribute.per_vertex()
            ? out.vertices
            : numbers([&](std::uint32_t face, std::size_t k) { return attribute.corners[face][k]; });
    for (const std::uint32_t value : used)
      alone.values.insert(alone.values.end(), attribute.value(value),
                          attribute.value(value) + attribute.components);
    for (const std::uint32_t face : faces) {
      if (attribute.per_vertex()) break;
      IndexedMesh::Triangle corners = attribute.corners[face];
      for (std::uint32_t& corner : corners) corner = number_in(used, corner);
      alone.corners.push_back(corners);
    }
    out.attributes.push_back(std::move(alone));
  }
  return out;
}

void drop_faces_without_vertices(MeshFile& file) {
  std::vector<bool> keep;
  keep.reserve(file.mesh.triangles.size());
  for (const IndexedMesh::Triangle& triangle : file.mesh.triangles)
    keep.push_back(*std::max_element(triangle.begin(), triangle.end()) < file.mesh.points.size());
  file.report.broken_faces += keep_faces(file, keep);
}

void drop_degenerate_faces(MeshFile& file) {
  std::vector<bool> keep;
  keep.reserve(file.mesh.triangles.size());
  for (const auto& [a, b, c] : file.mesh.triangles) keep.push_back(a != b && b != c && c != a);
  file.report.dropped_degenerate += keep_faces(file, keep);
}

}  // namespace whittle::files
