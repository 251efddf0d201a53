#include "files/split.hh"

#include <algorithm>

#include "files/IndexTable.hh"
#include "files/settle.hh"

namespace whittle::files {

Split split(const IndexedMesh& mesh, const std::vector<const attributes::Attribute*>& attributes) {
  std::vector<const attributes::Attribute*> at_corners;
  for (const attributes::Attribute* attribute : attributes)
    if (!attribute->per_vertex()) at_corners.push_back(attribute);

  // First in the order of the corners: which kinds of corners there are.
  const auto equal = [&](std::uint32_t a, std::uint32_t b) {
    if (mesh.triangles[a / 3][a % 3] != mesh.triangles[b / 3][b % 3]) return false;
    for (const attributes::Attribute* attribute : at_corners)
      if (attribute->corners[a / 3][a % 3] != attribute->corners[b / 3][b % 3]) return false;
    return true;
  };
  IndexTable table;
  std::vector<std::uint32_t> kind_of(3 * mesh.triangles.size());
  std::vector<std::uint32_t> first_corner;  // of each kind
  for (std::uint32_t corner = 0; corner < kind_of.size(); ++corner) {
    Hash hash;
    hash.add(std::uint64_t{mesh.triangles[corner / 3][corner % 3]});
    for (const attributes::Attribute* attribute : at_corners)
      hash.add(std::uint64_t{attribute->corners[corner / 3][corner % 3]});
    const auto fresh = static_cast<std::uint32_t>(first_corner.size());
    kind_of[corner] =
        table.find_or_add(hash, fresh, [&](std::uint32_t kind) { return equal(first_corner[kind], corner); });
    if (kind_of[corner] == fresh) first_corner.push_back(corner);
  }

  // Then in the order of the vertices; one that no face uses is there, too.
  std::vector<std::uint32_t> begin(mesh.points.size() + 1, 0);
  for (const std::uint32_t corner : first_corner) ++begin[mesh.triangles[corner / 3][corner % 3] + 1];
  Split result;
  for (std::uint32_t vertex = 0; vertex < mesh.points.size(); ++vertex) {
    const std::uint32_t kinds = begin[vertex + 1] > 0 ? begin[vertex + 1] : 1;
    result.vertex.insert(result.vertex.end(), kinds, vertex);
    begin[vertex + 1] = begin[vertex] + kinds;
  }
  result.corner.assign(result.vertex.size(), Split::none);
  std::vector<std::uint32_t> number(first_corner.size());
  for (std::uint32_t kind = 0; kind < first_corner.size(); ++kind) {
    const std::uint32_t corner = first_corner[kind];
    number[kind] = begin[mesh.triangles[corner / 3][corner % 3]]++;
    result.corner[number[kind]] = corner;
  }
  result.triangles.resize(mesh.triangles.size());
  for (std::uint32_t corner = 0; corner < kind_of.size(); ++corner)
    result.triangles[corner / 3][corner % 3] = number[kind_of[corner]];
  return result;
}

std::vector<float> values_at(const Split& vertices, const attributes::Attribute& attribute) {
  std::vector<float> values;
  values.reserve(attribute.components * vertices.vertex.size());
  for (std::size_t i = 0; i < vertices.vertex.size(); ++i) {
    const std::uint32_t value = vertices.value(attribute, i);
    for (std::size_t k = 0; k < attribute.components; ++k)
      values.push_back(value == Split::none ? default_component(attribute.kind) : attribute.value(value)[k]);
  }
  return values;
}

std::vector<std::uint32_t> first_of_each(const Split& vertices, const IndexedMesh& mesh) {
  std::vector<std::uint32_t> first;
  if (vertices.vertex.size() == mesh.points.size()) return first;
  for (std::uint32_t i = 0; i < vertices.vertex.size(); ++i)
    if (vertices.vertex[i] == first.size()) first.push_back(i);
  return first;
}

SplitMesh split_mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                     const std::vector<const attributes::Attribute*>& at_vertices) {
  const Split vertices = split(mesh, at_vertices);
  SplitMesh out;
  for (const std::uint32_t vertex : vertices.vertex) out.mesh.points.push_back(mesh.points[vertex]);
  out.mesh.triangles = vertices.triangles;
  out.attributes = attributes;
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const bool moves = std::find(at_vertices.begin(), at_vertices.end(), &attributes[i]) != at_vertices.end();
    if (!moves && !attributes[i].per_vertex()) continue;
    out.attributes[i].values = values_at(vertices, attributes[i]);
    out.attributes[i].corners = {};
  }
  out.first = first_of_each(vertices, mesh);
  return out;
}

}  // namespace whittle::files
