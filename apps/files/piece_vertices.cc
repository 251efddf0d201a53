#include "files/piece_vertices.hh"

#include <algorithm>

#include "files/IndexTable.hh"

namespace whittle::files {

using attributes::Attribute;

PieceVertices vertices_of(const IndexedMesh& mesh, const std::vector<std::uint32_t>& faces,
                          const std::vector<const Attribute*>& attributes) {
  PieceVertices out;
  IndexTable table;
  const auto equal = [&](std::uint32_t a, std::uint32_t b) {
    if (mesh.triangles[a / 3][a % 3] != mesh.triangles[b / 3][b % 3]) return false;
    return std::all_of(attributes.begin(), attributes.end(), [&](const Attribute* attribute) {
      return attribute->at(mesh, a / 3, a % 3) == attribute->at(mesh, b / 3, b % 3);
    });
  };
  for (const std::uint32_t face : faces)
    for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner) {
      Hash hash;
      hash.add(std::uint64_t{mesh.triangles[corner / 3][corner % 3]});
      for (const Attribute* attribute : attributes)
        hash.add(std::uint64_t{attribute->at(mesh, corner / 3, corner % 3)});
      const auto fresh = static_cast<std::uint32_t>(out.corners.size());
      const std::uint32_t index = table.find_or_add(
          hash, fresh, [&](std::uint32_t other) { return equal(out.corners[other], corner); });
      if (index == fresh) out.corners.push_back(corner);
      out.indices.push_back(index);
    }
  return out;
}

std::vector<float> values_of(const IndexedMesh& mesh, const PieceVertices& vertices,
                             const Attribute& attribute) {
  std::vector<float> values;
  values.reserve(attribute.components * vertices.corners.size());
  for (const std::uint32_t corner : vertices.corners) {
    const float* value = attribute.value(attribute.at(mesh, corner / 3, corner % 3));
    values.insert(values.end(), value, value + attribute.components);
  }
  return values;
}

std::vector<float> narrowed(const std::vector<float>& values, std::size_t components, std::size_t count) {
  std::vector<float> out;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % components < count) out.push_back(values[i]);
  return out;
}

}  // namespace whittle::files
