#include "files/settle.hh"

#include <cstring>
#include <utility>

#include "files/IndexTable.hh"
#include "files/MeshBuilder.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;

/// For each value the first that is equal to it, bit for bit.
std::vector<std::uint32_t> first_equal(const Attribute& attribute) {
  IndexTable table;
  std::vector<std::uint32_t> first(attribute.n_values());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const float* value = attribute.value(i);
    Hash hash;
    for (std::size_t k = 0; k < attribute.components; ++k) hash.add(value[k]);
    first[i] = table.find_or_add(hash, static_cast<std::uint32_t>(i), [&](std::uint32_t other) {
      return std::memcmp(attribute.value(other), value, attribute.components * sizeof(float)) == 0;
    });
  }
  return first;
}

/// The attribute's values in the order of the indices.
std::vector<float> gathered(const Attribute& attribute, const std::vector<std::uint32_t>& indices) {
  std::vector<float> values;
  values.reserve(indices.size() * attribute.components);
  for (const std::uint32_t index : indices)
    values.insert(values.end(), attribute.value(index), attribute.value(index) + attribute.components);
  return values;
}

/// Leaves out the values that no corner uses.
void keep_used_values(Attribute& attribute) {
  std::vector<std::uint32_t> number(attribute.n_values(), no_value);
  std::vector<std::uint32_t> used;
  for (IndexedMesh::Triangle& corners : attribute.corners) {
    for (std::uint32_t& corner : corners) {
      if (number[corner] == no_value) {
        number[corner] = static_cast<std::uint32_t>(used.size());
        used.push_back(corner);
      }
      corner = number[corner];
    }
  }
  attribute.values = gathered(attribute, used);
}

}  // namespace

float default_component(attributes::Kind kind) {
  return kind == attributes::Kind::colour ? 1.0F : 0.0F;
}

std::size_t settle(Attribute& attribute, const IndexedMesh& mesh,
                   const std::vector<std::uint32_t>& of_vertex) {
  const auto fallback = static_cast<std::uint32_t>(attribute.n_values());
  attribute.values.insert(attribute.values.end(), attribute.components, default_component(attribute.kind));
  const std::vector<std::uint32_t> first = first_equal(attribute);

  std::size_t missing = 0;
  bool agree = true;
  std::vector<std::uint32_t> at_vertex(mesh.points.size(), no_value);
  for (std::size_t face = 0; face < attribute.corners.size(); ++face) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& value = attribute.corners[face][k];
      if (value == no_value) {
        ++missing;
        value = fallback;
      }
      value = first[value];
      std::uint32_t& common = at_vertex[mesh.triangles[face][k]];
      if (common == no_value) common = value;
      agree = agree && common == value;
    }
  }
  if (!agree) {
    keep_used_values(attribute);
    return missing;
  }
  for (std::size_t vertex = 0; vertex < at_vertex.size(); ++vertex)
    if (at_vertex[vertex] == no_value) at_vertex[vertex] = of_vertex.empty() ? fallback : of_vertex[vertex];
  attribute.values = gathered(attribute, at_vertex);
  attribute.corners = {};
  return missing;
}

void settle(MeshFile& file) {
  for (Attribute& attribute : file.attributes)
    if (!attribute.per_vertex()) file.report.missing_values += settle(attribute, file.mesh);
}

}  // namespace whittle::files
