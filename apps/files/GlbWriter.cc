#include "files/GlbWriter.hh"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "files/Fault.hh"
#include "files/beside.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/rounding.hh"
#include "files/subset.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

int to_int(std::size_t number) {
  return static_cast<int>(number);
}

bool is_plain_text(const std::string& name) {
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isprint(c); });
}

}  // namespace

void normalize(std::vector<float>& normals) {
  constexpr float tolerance = 1e-3F;
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    const float length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (length == 0 || std::abs(length - 1) < tolerance) continue;
    for (std::size_t k = 0; k < 3; ++k) normals[i + k] /= length;
  }
}

int GlbWriter::add(const IndexedMesh& mesh, const attributes::Attributes& attributes, const Parts& parts) {
  if (model_.nodes.empty()) origin_ = origin_for_floats(mesh);
  note_rounding(mesh, report_, origin_);
  if (!has_materials_) add_materials(parts);
  tinygltf::Node node;
  if (!origin_.isZero()) node.translation.assign(origin_.begin(), origin_.end());
  node.name = "mesh";  // a node that says nothing at all is not written as one
  // A mesh must have a part, and a part must have vertices.
  if (!mesh.points.empty()) node.mesh = add_mesh(mesh, attributes, parts);
  model_.nodes.push_back(std::move(node));
  return to_int(model_.nodes.size() - 1);
}

void GlbWriter::add_materials(const Parts& parts) {
  has_materials_ = true;
  std::vector<int> texture_of;
  for (const Image& image : parts.images) {
    const int source = add_image(image);
    texture_of.push_back(source < 0 ? -1 : to_int(model_.textures.size()));
    if (source < 0) continue;
    tinygltf::Texture texture;
    texture.source = source;
    model_.textures.push_back(std::move(texture));
  }
  for (const Material& material : parts.materials) {
    tinygltf::Material out;
    out.name = material.name;
    out.pbrMetallicRoughness.baseColorFactor.assign(material.colour.begin(), material.colour.end());
    out.pbrMetallicRoughness.metallicFactor = 0;  // what other formats know of colours is not of metal
    if (material.image) out.pbrMetallicRoughness.baseColorTexture.index = texture_of[*material.image];
    if (material.alpha != Material::Alpha::opaque)
      out.alphaMode = material.alpha == Material::Alpha::blend ? "BLEND" : "MASK";
    out.alphaCutoff = material.cutoff;
    model_.materials.push_back(std::move(out));
  }
}

/// \return -1: it cannot be read, or glTF has no images of its kind
int GlbWriter::add_image(const Image& image) {
  constexpr std::size_t most = std::size_t{1} << 31;
  const std::optional<std::string> bytes =
      image.path.empty() ? std::optional(image.bytes) : bytes_of(image.path, most);
  const std::string head = bytes ? bytes->substr(0, 4) : std::string();
  const bool is_png = head == "\x89PNG", is_jpeg = head.substr(0, 3) == "\xff\xd8\xff";
  if (!is_png && !is_jpeg) {
    leave_out(report_, "image " + in_quotes(image.name) + (bytes ? ", which is neither PNG nor JPEG" : ""));
    return -1;
  }
  tinygltf::Image out;
  out.name = std::filesystem::path(image.name).stem().string();
  out.mimeType = is_png ? "image/png" : "image/jpeg";
  out.bufferView = begin_view(0, 0);
  model_.buffers[0].data.insert(model_.buffers[0].data.end(), bytes->begin(), bytes->end());
  end_view(out.bufferView);
  model_.images.push_back(std::move(out));
  return to_int(model_.images.size() - 1);
}

int GlbWriter::add_mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                        const Parts& parts) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> faces;  // by material
  for (std::uint32_t face = 0; face < parts.of_face.size(); ++face)
    faces[parts.list[parts.of_face[face]].material].push_back(face);
  const auto set_material = [](tinygltf::Mesh& to, std::uint32_t material) {
    if (material != Part::none) to.primitives.back().material = static_cast<int>(material);
  };
  tinygltf::Mesh result;
  std::vector<std::uint32_t> first(mesh.points.size(), 0);
  if (faces.size() <= 1) {
    first = add_part(mesh, attributes, result);
    if (!faces.empty()) set_material(result, faces.begin()->first);
  }
  std::vector<bool> seen(mesh.points.size(), false);
  std::uint32_t begin = 0;
  for (const auto& [material, list] : faces) {
    if (faces.size() <= 1) break;
    const FacesAlone alone = faces_alone(mesh, attributes, list);
    const std::vector<std::uint32_t> part_first = add_part(alone.mesh, alone.attributes, result);
    set_material(result, material);
    for (std::uint32_t i = 0; i < alone.vertices.size(); ++i) {
      if (!seen[alone.vertices[i]])
        first[alone.vertices[i]] = begin + (part_first.empty() ? i : part_first[i]);
      seen[alone.vertices[i]] = true;
    }
    begin += static_cast<std::uint32_t>(
        model_.accessors[static_cast<std::size_t>(result.primitives.back().attributes["POSITION"])].count);
  }
  report_.doubled_vertices -= std::min(report_.doubled_vertices, mesh.points.size());
  if (model_.meshes.empty()) report_.first_vertex = std::move(first);
  model_.meshes.push_back(std::move(result));
  return to_int(model_.meshes.size() - 1);
}

/// \return for each vertex of the mesh the first that stands for it; empty: they are the same
std::vector<std::uint32_t> GlbWriter::add_part(const IndexedMesh& mesh,
                                               const attributes::Attributes& attributes, tinygltf::Mesh& to) {
  const Choice choice =
      choose(attributes, {Place::corners, Place::corners, Place::corners, Place::corners}, report_);
  std::vector<const Attribute*> all = choice.scalars;
  for (const Attribute* attribute : {choice.normal, choice.colour, choice.texture})
    if (attribute != nullptr) all.push_back(attribute);
  const Split vertices = split(mesh, all);
  report_.doubled_vertices += vertices.vertex.size();

  tinygltf::Primitive part;
  part.mode = mesh.triangles.empty() ? TINYGLTF_MODE_POINTS : TINYGLTF_MODE_TRIANGLES;
  part.attributes["POSITION"] = add_positions(mesh, vertices);
  if (choice.normal) {
    Numbers normals = values_at(vertices, *choice.normal);
    normalize(normals);
    part.attributes["NORMAL"] = add_floats(normals, TINYGLTF_TYPE_VEC3);
  }
  if (choice.texture) {
    Numbers texture = values_at(vertices, *choice.texture);
    if (!choice.texture->downwards)
      for (std::size_t i = 1; i < texture.size(); i += 2) texture[i] = 1.0F - texture[i];
    part.attributes["TEXCOORD_0"] = add_floats(texture, TINYGLTF_TYPE_VEC2);
  }
  if (choice.colour) part.attributes["COLOR_0"] = add_colours(*choice.colour, vertices);
  for (const Attribute* scalar : choice.scalars) {
    const std::string name = "_" + scalar->name;
    if (!is_plain_text(scalar->name) || part.attributes.count(name) > 0) {
      leave_out(report_, to_string(*scalar));
      continue;
    }
    Numbers values = values_at(vertices, *scalar);
    for (float& value : values) {
      if (std::isfinite(value)) continue;
      value = 0;
      reduce(report_, to_string(*scalar) + ": values that are not finite written as 0");
    }
    part.attributes[name] = add_floats(values, TINYGLTF_TYPE_SCALAR);
  }
  if (!mesh.triangles.empty()) part.indices = add_indices(vertices);

  to.primitives.push_back(std::move(part));
  return first_of_each(vertices, mesh);
}

/// Of the view that was made last.
int GlbWriter::add_accessor(int component_type, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = to_int(model_.bufferViews.size() - 1);
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  model_.accessors.push_back(std::move(accessor));
  return to_int(model_.accessors.size() - 1);
}

/// \param stride  0: values follow each other without a gap
int GlbWriter::begin_view(int target, std::size_t stride) {
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = model_.buffers[0].data.size();
  view.byteStride = stride;
  view.target = target;
  model_.bufferViews.push_back(std::move(view));
  return to_int(model_.bufferViews.size() - 1);
}

/// The next view begins at a multiple of four again.
void GlbWriter::end_view(int view) {
  std::vector<unsigned char>& data = model_.buffers[0].data;
  tinygltf::BufferView& ended = model_.bufferViews[static_cast<std::size_t>(view)];
  ended.byteLength = data.size() - ended.byteOffset;
  while (data.size() % 4 != 0) data.push_back(0);
}

void GlbWriter::append(float value) {
  std::string bytes;
  append_little(bytes, value);
  model_.buffers[0].data.insert(model_.buffers[0].data.end(), bytes.begin(), bytes.end());
}

int GlbWriter::add_floats(const Numbers& values, int type) {
  const int view = begin_view(TINYGLTF_TARGET_ARRAY_BUFFER, 0);
  for (const float value : values) append(value);
  end_view(view);
  return add_accessor(TINYGLTF_COMPONENT_TYPE_FLOAT, type,
                      values.size() / static_cast<std::size_t>(tinygltf::GetNumComponentsInType(
                                          static_cast<std::uint32_t>(type))));
}

int GlbWriter::add_positions(const IndexedMesh& mesh, const Split& vertices) {
  Numbers values;
  values.reserve(3 * vertices.vertex.size());
  for (const std::uint32_t vertex : vertices.vertex)
    for (int k = 0; k < 3; ++k) values.push_back(static_cast<float>(mesh.points[vertex][k] - origin_[k]));
  const int index = add_floats(values, TINYGLTF_TYPE_VEC3);

  tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
  for (std::size_t k = 0; k < 3; ++k) {
    float least = values[k], most = values[k];
    for (std::size_t i = k; i < values.size(); i += 3) {
      least = std::min(least, values[i]);
      most = std::max(most, values[i]);
    }
    accessor.minValues.push_back(double{least});
    accessor.maxValues.push_back(double{most});
  }
  return index;
}

/// Bytes stay bytes. Three of them need a gap, since every value must begin at a multiple of four.
int GlbWriter::add_colours(const Attribute& colour, const Split& vertices) {
  const int type = colour.components == 4 ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
  const Numbers values = values_at(vertices, colour);
  if (!colour.bytes) return add_floats(values, type);
  const int view = begin_view(TINYGLTF_TARGET_ARRAY_BUFFER, 4);
  std::vector<unsigned char>& data = model_.buffers[0].data;
  for (std::size_t i = 0; i < values.size(); i += colour.components) {
    for (std::size_t k = 0; k < colour.components; ++k) data.push_back(to_byte(values[i + k]));
    if (colour.components == 3) data.push_back(0);
  }
  end_view(view);
  const int accessor = add_accessor(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, type, vertices.vertex.size());
  model_.accessors.back().normalized = true;
  return accessor;
}

int GlbWriter::add_indices(const Split& vertices) {
  const bool fits_short = vertices.vertex.size() <= std::numeric_limits<std::uint16_t>::max();
  const int view = begin_view(TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
  std::string bytes;
  for (const IndexedMesh::Triangle& triangle : vertices.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (fits_short)
        append_little(bytes, static_cast<std::uint16_t>(corner));
      else
        append_little(bytes, corner);
    }
  }
  model_.buffers[0].data.insert(model_.buffers[0].data.end(), bytes.begin(), bytes.end());
  end_view(view);
  return add_accessor(
      fits_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
      TINYGLTF_TYPE_SCALAR, 3 * vertices.triangles.size());
}

std::string GlbWriter::bytes() {
  constexpr std::size_t room_for_json = 1 << 20;
  if (model_.buffers[0].data.size() > std::numeric_limits<std::uint32_t>::max() - room_for_json)
    throw Fault("not written: GLB cannot hold more than 4 GiB");
  if (model_.buffers[0].data.empty()) model_.buffers.clear();
  std::ostringstream out;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, false, true))
    throw Fault("not written: tinygltf cannot write it");
  return out.str();
}

}  // namespace whittle::files
