#include "files/GltfWriter.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/companions.hh"
#include "files/gltf_extensions.hh"
#include "files/image_type.hh"
#include "files/rounding.hh"
#include "files/subset.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using Json = GltfOutput::Json;

constexpr int kPoints = 0, kTriangles = 4;
constexpr const char* kTextureTransform = "KHR_texture_transform";

bool is_plain_text(const std::string& name) {
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isprint(c); });
}

Json gltf_material(const Material& material, std::optional<std::size_t> texture) {
  Json base = {{"metallicFactor", 0}};  // what other formats know of colours is not of metal
  if (material.colour != Material().colour) base["baseColorFactor"] = material.colour;
  if (texture) base["baseColorTexture"] = {{"index", *texture}};
  if (texture && material.is_texture_moved()) {
    const auto [u, v] = material.texture_scale;  // v counts downwards in glTF
    base["baseColorTexture"]["extensions"][kTextureTransform] = {
        {"scale", {u, v}}, {"offset", {material.texture_offset[0], 1 - v - material.texture_offset[1]}}};
  }
  Json out = {{"pbrMetallicRoughness", std::move(base)}};
  if (!material.name.empty()) out["name"] = material.name;
  if (material.alpha != Material::Alpha::opaque)
    out["alphaMode"] = material.alpha == Material::Alpha::blend ? "BLEND" : "MASK";
  if (material.cutoff != Material().cutoff) out["alphaCutoff"] = material.cutoff;
  return out;
}

}  // namespace

GltfWriter::GltfWriter(WriteReport& report)
    : report_(report),
      output_({{"asset", {{"version", "2.0"}, {"generator", "whittle"}}}, {"scene", 0}}, "") {
  output_.json()["scenes"].push_back({{"nodes", Json::array({0})}});
}

std::size_t GltfWriter::add(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                            const Parts& parts) {
  Json& document = output_.json();
  if (!document.contains("nodes")) {
    origin_ = origin_for_floats(mesh);
    add_materials(parts);
  }
  note_rounding(mesh, report_, origin_);
  Json node = {{"name", "mesh"}};
  if (!origin_.isZero()) node["translation"] = {origin_[0], origin_[1], origin_[2]};
  if (!mesh.points.empty()) {  // a mesh must have a part, and a part must have vertices
    Json added = this->mesh(mesh, attributes, parts);
    document["meshes"].push_back(std::move(added));
    node["mesh"] = document["meshes"].size() - 1;
  }
  document["nodes"].push_back(std::move(node));
  return document["nodes"].size() - 1;
}

void GltfWriter::add_materials(const Parts& parts) {
  std::vector<std::optional<std::size_t>> texture_of;
  Json& document = output_.json();
  for (const Image& image : parts.images) {
    const std::optional<std::size_t> source = add_image(image);
    if (source) document["textures"].push_back({{"source", *source}});
    texture_of.push_back(source ? std::optional(document["textures"].size() - 1) : std::nullopt);
  }
  bool is_moved = false;
  for (const Material& material : parts.materials) {
    const std::optional<std::size_t> texture = material.image ? texture_of[*material.image] : std::nullopt;
    document["materials"].push_back(gltf_material(material, texture));
    is_moved = is_moved || (texture && material.is_texture_moved());
  }
  if (is_moved) use_gltf_extension(document, kTextureTransform);
}

/// \return none: it cannot be read, or glTF has no images of its kind
std::optional<std::size_t> GltfWriter::add_image(const Image& image) {
  const std::optional<std::string> bytes =
      image.path.empty() ? std::optional(image.bytes) : bytes_of(image.path, CompanionCopier::kMost);
  const bool is_there = bytes && !bytes->empty();
  const ImageType* type = is_there ? image_type(*bytes) : nullptr;
  if (type == nullptr || !type->is_plain) {
    leave_out(report_,
              "image " + in_quotes(image.name) + (is_there ? ", which is neither PNG nor JPEG" : ""));
    return std::nullopt;
  }
  Json out = {{"mimeType", type->mime}, {"bufferView", output_.add_view(*bytes)}};
  const std::string name = std::filesystem::path(image.name).stem().string();
  if (!name.empty()) out["name"] = name;
  Json& images = output_.json()["images"];
  images.push_back(std::move(out));
  return images.size() - 1;
}

Json GltfWriter::mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces;  // by material
  for (std::uint32_t face = 0; face < parts.of_face.size(); ++face)
    faces[parts.list[parts.of_face[face]].material].push_back(face);
  Json list = Json::array();
  std::vector<std::uint32_t> first, part_first;
  std::size_t begin = 0, count = 0;
  if (faces.size() <= 1) {
    list.push_back(
        primitive(mesh, attributes, faces.empty() ? Part::none : faces.begin()->first, first, begin));
    faces.clear();
  } else {
    first.assign(mesh.points.size(), 0);
  }
  std::vector<bool> seen(mesh.points.size(), false);
  for (const auto& [material, some] : faces) {
    const FacesAlone alone = faces_alone(mesh, attributes, some);
    list.push_back(primitive(alone.mesh, alone.attributes, material, part_first, count));
    for (std::uint32_t i = 0; i < alone.vertices.size(); ++i) {
      if (!seen[alone.vertices[i]])
        first[alone.vertices[i]] =
            static_cast<std::uint32_t>(begin) + (part_first.empty() ? i : part_first[i]);
      seen[alone.vertices[i]] = true;
    }
    begin += count;
  }
  report_.doubled_vertices += begin - std::min(begin, mesh.points.size());
  if (!output_.json().contains("meshes")) report_.first_vertex = std::move(first);
  return {{"primitives", std::move(list)}};
}

/// \param first  set to the first vertex that stands for each of the mesh; empty: they are the same
/// \param count  set to the number of vertices
Json GltfWriter::primitive(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                           std::uint32_t material, std::vector<std::uint32_t>& first, std::size_t& count) {
  const Choice choice =
      choose(attributes, {Place::corners, Place::corners, Place::corners, Place::corners}, report_);
  std::vector<const Attribute*> all = choice.scalars;
  for (const Attribute* attribute : {choice.normal, choice.colour, choice.texture})
    if (attribute != nullptr) all.push_back(attribute);
  const Split vertices = split(mesh, all);
  count = vertices.vertex.size();

  Json data = {{"POSITION", add_positions(mesh, vertices)}};
  if (choice.normal) data["NORMAL"] = output_.add_normals(values_at(vertices, *choice.normal));
  if (choice.texture) data["TEXCOORD_0"] = add_texture(*choice.texture, vertices);
  if (choice.colour) data["COLOR_0"] = add_colours(*choice.colour, vertices);
  add_scalars(choice.scalars, vertices, data);
  Json out = {{"mode", mesh.triangles.empty() ? kPoints : kTriangles}, {"attributes", std::move(data)}};
  if (material != Part::none) out["material"] = material;
  if (!mesh.triangles.empty()) {
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * vertices.triangles.size());
    for (const IndexedMesh::Triangle& triangle : vertices.triangles)
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    out["indices"] = output_.add_indices(indices, count);
  }
  first = first_of_each(vertices, mesh);
  return out;
}

std::size_t GltfWriter::add_positions(const IndexedMesh& mesh, const Split& vertices) {
  std::vector<float> values;
  values.reserve(3 * vertices.vertex.size());
  for (const std::uint32_t vertex : vertices.vertex)
    for (int k = 0; k < 3; ++k) values.push_back(static_cast<float>(mesh.points[vertex][k] - origin_[k]));
  return output_.add_floats(values, 3, true);
}

std::size_t GltfWriter::add_texture(const Attribute& texture, const Split& vertices) {
  std::vector<float> values = values_at(vertices, texture);
  if (!texture.downwards)
    for (std::size_t i = 1; i < values.size(); i += 2) values[i] = 1.0F - values[i];
  return output_.add_floats(values, 2);
}

/// Bytes stay bytes.
std::size_t GltfWriter::add_colours(const Attribute& colour, const Split& vertices) {
  const std::vector<float> values = values_at(vertices, colour);
  return colour.bytes ? output_.add_bytes(values, colour.components)
                      : output_.add_floats(values, colour.components);
}

void GltfWriter::add_scalars(const std::vector<const Attribute*>& scalars, const Split& vertices, Json& to) {
  for (const Attribute* scalar : scalars) {
    const std::string name = "_" + scalar->name;
    if (!is_plain_text(scalar->name) || to.contains(name)) {
      leave_out(report_, to_string(*scalar));
      continue;
    }
    std::vector<float> values = values_at(vertices, *scalar);
    for (float& value : values) {
      if (std::isfinite(value)) continue;
      value = 0;
      reduce(report_, to_string(*scalar) + ": values that are not finite written as 0");
    }
    to[name] = output_.add_floats(values, 1);
  }
}

}  // namespace whittle::files
