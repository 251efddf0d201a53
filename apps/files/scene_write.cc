/// \file
/// glTF 2.0: writing a scene back with other triangles.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "files/Fault.hh"
#include "files/GltfOutput.hh"
#include "files/IndexTable.hh"
#include "files/Scene.hh"
#include "files/formats.hh"
#include "files/gzip.hh"
#include "files/scene_images.hh"
#include "files/scene_references.hh"
#include "files/scene_remains.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using attributes::Attribute;
using attributes::Kind;

/// The vertices of a piece: one for each vertex of the mesh and the values that its corners have there.
struct PieceVertices {
  std::vector<std::uint32_t> corners;  ///< one corner of each, 3 f + k
  std::vector<std::uint32_t> indices;  ///< three for each face
};

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

/// The first `count` components of each value.
std::vector<float> narrowed(const std::vector<float>& values, std::size_t components, std::size_t count) {
  std::vector<float> out;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % components < count) out.push_back(values[i]);
  return out;
}

/// A view whose data stay.
struct KeptView {
  std::size_t number;
  std::size_t buffer, begin;  ///< of the input
  std::string_view bytes;
};

class SceneWriter {
 public:
  SceneWriter(const MeshFile& in, const SceneResult& result, WriteReport& report)
      : in_(in), scene_(*in.scene), result_(result), report_(report), document_(scene_.document) {}

  void run() {
    drop_lost_looks(document_, scene_, !in_.parts.materials.empty(), result_.attributes);
    prepare_data();
    find_exact_points();
    write_pieces();
    drop_empty_meshes(output_->json());
    drop_packing_extensions(output_->json(), scene_.pieces.size());
    output_->json()["asset"]["generator"] = "whittle";
  }

  GltfOutput& output() { return *output_; }

 private:
  /// Puts the data that stay one behind the other.
  void prepare_data() {
    const SceneReferences kept = references_besides(document_, scene_.pieces);
    std::string buffer;
    std::vector<KeptView> views;
    for (std::size_t i = 0; i < kept.views.size(); ++i) {
      if (!kept.views[i]) continue;
      const Json& view = document_["bufferViews"][i];
      const std::string_view bytes = bytes_of_view(view);
      views.push_back(
          {i, view.value("buffer", std::size_t{0}), view.value("byteOffset", std::size_t{0}), bytes});
    }
    std::sort(views.begin(), views.end(), [](const KeptView& a, const KeptView& b) {
      return std::tie(a.buffer, a.begin, a.number) < std::tie(b.buffer, b.begin, b.number);
    });
    // Views that overlap stay so: what they share is there once.
    std::size_t from = 0, end = 0;  // which buffer has been copied, up to where
    for (const KeptView& one : views) {
      if (one.buffer != from || one.begin >= end || buffer.empty()) {
        buffer.resize((buffer.size() + 7) / 8 * 8, '\0');
        from = one.buffer;
        end = one.begin;
      }
      const std::size_t shared = end - one.begin;
      Json& view = document_["bufferViews"][one.number];
      view["buffer"] = 0;
      view["byteOffset"] = buffer.size() - shared;
      view["byteLength"] = one.bytes.size();
      if (shared >= one.bytes.size()) continue;
      buffer += one.bytes.substr(shared);
      end = one.begin + one.bytes.size();
    }
    output_.emplace(std::move(document_), std::move(buffer));
    output_->set_free(unmarked(kept.accessors), unmarked(kept.views));
  }

  std::string_view bytes_of_view(const Json& view) const {
    const std::size_t number = view.value("buffer", std::size_t{0});
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    const std::size_t length = view.value("byteLength", std::size_t{0});
    if (number >= scene_.buffers.size() || offset > scene_.buffers[number].size() ||
        length > scene_.buffers[number].size() - offset)
      throw Fault("not written: a view of the input reaches beyond its buffer");
    return std::string_view(scene_.buffers[number]).substr(offset, length);
  }

  static std::vector<std::size_t> unmarked(const std::vector<bool>& marks) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < marks.size(); ++i)
      if (!marks[i]) out.push_back(i);
    return out;
  }

  /// Vertices that have not moved have the file's coordinates, to the last bit.
  void find_exact_points() {
    constexpr std::uint32_t none = MeshFile::left_out;
    std::vector<std::uint32_t> in_file(in_.mesh.points.size(), none);
    for (std::uint32_t i = 0; i < scene_.file_points.size(); ++i) {
      const std::uint32_t v = in_.vertex_of.empty() ? i : in_.vertex_of[i];
      if (v != none && in_file[v] == none) in_file[v] = i;
    }
    exact_.resize(result_.mesh.points.size(), none);
    for (std::size_t v = 0; v < result_.vertex_map.size(); ++v) {
      const std::uint32_t w = result_.vertex_map[v];
      if (w < exact_.size() && result_.mesh.points[w] == in_.mesh.points[v]) exact_[w] = in_file[v];
    }
  }

  IndexedMesh::Point point(std::uint32_t w, const Scene::Placement& placement) const {
    if (exact_[w] != MeshFile::left_out) return scene_.file_points[exact_[w]];
    return (result_.mesh.points[w] - placement.offset) / placement.scale;
  }

  void write_pieces() {
    std::vector<std::vector<std::uint32_t>> faces(scene_.pieces.size());
    for (std::uint32_t f = 0; f < result_.parts.size(); ++f) faces[result_.parts[f]].push_back(f);
    report_.first_vertex.assign(result_.mesh.points.size(), 0);
    std::vector<bool> seen(result_.mesh.points.size(), false);
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      const PieceVertices vertices = write_piece(scene_.pieces[i], faces[i]);
      for (std::uint32_t k = 0; k < vertices.corners.size(); ++k) {
        const std::uint32_t corner = vertices.corners[k];
        const std::uint32_t w = result_.mesh.triangles[corner / 3][corner % 3];
        if (!seen[w]) report_.first_vertex[w] = begin + k;
        seen[w] = true;
      }
      begin += static_cast<std::uint32_t>(vertices.corners.size());
    }
    report_.doubled_vertices = begin - std::min<std::size_t>(begin, result_.mesh.points.size());
  }

  PieceVertices write_piece(const Scene::Piece& piece, const std::vector<std::uint32_t>& faces) {
    std::vector<const Attribute*> attributes;
    for (const Scene::Channel& channel : piece.channels)
      if (const Attribute* attribute = find(channel.name)) attributes.push_back(attribute);
    std::vector<const Attribute*> at_corners;
    for (const Attribute* attribute : attributes)
      if (!attribute->per_vertex()) at_corners.push_back(attribute);
    PieceVertices vertices = vertices_of(result_.mesh, faces, at_corners);
    Json part = output_->json()["meshes"][piece.mesh]["primitives"][piece.primitive];
    part["attributes"] = Json::object();
    part.erase("indices");
    part.erase("mode");
    for (Json& target : part.contains("targets") ? part["targets"] : empty_) target = Json::object();
    if (!faces.empty()) {
      part["attributes"]["POSITION"] = add_positions(piece, vertices);
      for (const Scene::Channel& channel : piece.channels)
        if (const Attribute* attribute = find(channel.name)) add_channel(part, channel, *attribute, vertices);
      part["indices"] = output_->add_indices(vertices.indices, vertices.corners.size());
    }
    output_->json()["meshes"][piece.mesh]["primitives"][piece.primitive] = std::move(part);
    return vertices;
  }

  const Attribute* find(const std::string& name) const {
    const auto found = std::find_if(result_.attributes.begin(), result_.attributes.end(),
                                    [&](const Attribute& attribute) { return attribute.name == name; });
    return found == result_.attributes.end() ? nullptr : &*found;
  }

  std::size_t add_positions(const Scene::Piece& piece, const PieceVertices& vertices) {
    std::vector<float> values;
    for (const std::uint32_t corner : vertices.corners)
      for (const double x :
           point(result_.mesh.triangles[corner / 3][corner % 3], scene_.placements[piece.mesh])) {
        values.push_back(static_cast<float>(x));
        if (!std::isfinite(values.back()))
          throw Fault("not written: a coordinate is too large for a 32-bit float");
      }
    return output_->add_floats(values, 3, true);
  }

  void add_channel(Json& part, const Scene::Channel& channel, const Attribute& attribute,
                   const PieceVertices& vertices) {
    std::vector<float> values = values_of(result_.mesh, vertices, attribute);
    for (float& value : values)
      if (!std::isfinite(value)) value = 0;
    if (attribute.kind == Kind::skin) return add_skin(part, attribute, values);
    if (attribute.kind == Kind::colour && channel.components < attribute.components)
      values = narrowed(values, attribute.components, channel.components);
    const std::size_t slash = channel.name.find('/');
    const bool is_position = slash != std::string::npos && channel.name.substr(slash) == "/POSITION";
    const std::size_t accessor = attribute.kind == Kind::normal ? output_->add_normals(std::move(values))
                                 : attribute.kind == Kind::colour && channel.bytes
                                     ? output_->add_bytes(values, channel.components)
                                     : output_->add_floats(values, channel.components, is_position);
    if (attribute.kind == Kind::vector && slash != std::string::npos && channel.name[0] != '_')
      part["targets"][std::stoul(channel.name.substr(0, slash))][channel.name.substr(slash + 1)] = accessor;
    else
      part["attributes"][channel.name] = accessor;
  }

  void add_skin(Json& part, const Attribute& attribute, const std::vector<float>& values) {
    const std::size_t pairs = attribute.components / 2;
    for (std::size_t first = 0; first < pairs; first += 4) {
      std::vector<float> joints, weights;
      for (std::size_t i = 0; i < values.size(); i += 2) {
        if (i / 2 % pairs < first || i / 2 % pairs >= first + 4) continue;
        joints.push_back(values[i + 1] > 0 ? values[i] : 0);
        weights.push_back(values[i + 1]);
      }
      const std::string number = std::to_string(first / 4);
      part["attributes"]["JOINTS_" + number] = output_->add_joints(joints);
      part["attributes"]["WEIGHTS_" + number] = output_->add_floats(weights, 4);
    }
  }

  const MeshFile& in_;
  const Scene& scene_;
  const SceneResult& result_;
  WriteReport& report_;
  Json document_, empty_ = Json::array();
  std::optional<GltfOutput> output_;
  std::vector<std::uint32_t> exact_;  ///< for each vertex the one of the file that it still is
};

}  // namespace

Encoded encode_scene(const fs::path& path, const MeshFile& in, const SceneResult& result,
                     const WriteOptions& options) {
  return naming(path, [&] {
    const Format format = format_to_write(path, options);
    Encoded out;
    try {
      SceneWriter writer(in, result, out.report);
      writer.run();
      carry_images(*in.scene, path, format == Format::glb, writer.output(), out);
      encode_gltf(writer.output(), path, format, options, false, out);
    } catch (const Json::exception&) {
      throw Fault("not written: the JSON of the input is damaged; --flatten writes its triangles alone");
    }
    if (is_gzip_name(path)) out.bytes = gzipped(out.bytes);
    return out;
  });
}

}  // namespace whittle::files
