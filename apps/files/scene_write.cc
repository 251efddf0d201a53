/// \file
/// glTF 2.0: writing a scene back with other triangles.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "files/Fault.hh"
#include "files/GltfOutput.hh"
#include "files/Scene.hh"
#include "files/formats.hh"
#include "files/gzip.hh"
#include "files/levels.hh"
#include "files/piece_vertices.hh"
#include "files/scene_images.hh"
#include "files/scene_references.hh"
#include "files/scene_remains.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using attributes::Attribute;
using attributes::Kind;

/// A view whose data stay.
struct KeptView {
  std::size_t number;
  std::size_t buffer, begin;  ///< of the input
  std::string_view bytes;
};

class SceneWriter {
 public:
  SceneWriter(const MeshFile& in, WriteReport& report)
      : in_(in), scene_(*in.scene), report_(report), document_(scene_.document) {}

  void run(const std::vector<SceneLevel>& levels) {
    drop_lost_looks(document_, scene_, !in_.parts.materials.empty(), levels[0].result.attributes);
    prepare_data();
    std::vector<MeshLevels> of_mesh(scene_.placements.size());
    for (std::uint32_t mesh = 0; mesh < of_mesh.size(); ++mesh) meshes_.push_back(mesh);
    find_file_vertices();
    write_result(levels[0].result);
    std::vector<std::size_t> before = faces_of_meshes(levels[0].result);
    for (std::size_t i = 1; i < levels.size(); ++i) add_level(levels[i], before, of_mesh);
    for (std::size_t mesh = 0; mesh < of_mesh.size(); ++mesh) add_coverage(mesh, of_mesh[mesh]);
    connect_levels(output_->json(), of_mesh);
    drop_empty_meshes(output_->json());
    drop_packing_extensions(output_->json(), n_parts() == scene_.pieces.size());
    output_->json()["asset"]["generator"] = "whittle";
  }

  GltfOutput& output() { return *output_; }

 private:
  static constexpr std::size_t kNotWritten = static_cast<std::size_t>(-1);

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

  /// Of the input, triangles or not.
  std::size_t n_parts() const {
    std::size_t parts = 0;
    if (scene_.document.contains("meshes"))
      for (const Json& mesh : scene_.document["meshes"]) parts += mesh["primitives"].size();
    return parts;
  }

  std::vector<std::size_t> faces_of_meshes(const SceneResult& result) const {
    std::vector<std::size_t> faces(meshes_.size(), 0);
    for (const std::uint32_t part : result.parts) ++faces[scene_.pieces[part].mesh];
    return faces;
  }

  /// Writes new meshes for those that have fewer faces than in the level before.
  void add_level(const SceneLevel& level, std::vector<std::size_t>& before,
                 std::vector<MeshLevels>& of_mesh) {
    const std::vector<std::size_t> faces = faces_of_meshes(level.result);
    Json& meshes = output_->json()["meshes"];
    for (std::size_t mesh = 0; mesh < faces.size(); ++mesh) {
      meshes_[mesh] = kNotWritten;
      if (faces[mesh] == before[mesh]) continue;
      if (!std::isfinite(level.errors[mesh])) throw Fault("not written: an error that is not finite");
      const Json same = meshes[mesh];  // parts that are no triangles, names, weights
      meshes_[mesh] = meshes.size();
      meshes.push_back(same);
      of_mesh[mesh].meshes.push_back(meshes_[mesh]);
      of_mesh[mesh].errors.push_back(level.errors[mesh] / scene_.placements[mesh].scale);
    }
    write_result(level.result);
    before = faces;
  }

  void add_coverage(std::size_t mesh, MeshLevels& levels) const {
    if (levels.meshes.empty()) return;
    Eigen::AlignedBox3d box;
    for (std::size_t v = 0; v < scene_.file_points.size(); ++v)
      if (scene_.mesh_of[v] == mesh && scene_.file_points[v].allFinite()) box.extend(scene_.file_points[v]);
    std::vector<double> errors = levels.errors;
    errors.insert(errors.begin(), 0);
    levels.coverage = screen_coverage(box.isEmpty() ? 0 : box.diagonal().norm(), errors);
  }

  /// For each vertex of the input one of the file's.
  void find_file_vertices() {
    in_file_.assign(in_.mesh.points.size(), MeshFile::left_out);
    for (std::uint32_t i = 0; i < scene_.file_points.size(); ++i) {
      const std::uint32_t v = in_.vertex_of.empty() ? i : in_.vertex_of[i];
      if (v != MeshFile::left_out && in_file_[v] == MeshFile::left_out) in_file_[v] = i;
    }
  }

  void write_result(const SceneResult& result) {
    const bool is_first = result_ == nullptr;
    result_ = &result;
    find_exact_points();
    const std::vector<std::uint32_t> first = write_pieces();
    if (is_first) report_.first_vertex = first;
  }

  /// Vertices that have not moved have the file's coordinates, to the last bit.
  void find_exact_points() {
    exact_.assign(result_->mesh.points.size(), MeshFile::left_out);
    for (std::size_t v = 0; v < result_->vertex_map.size(); ++v) {
      const std::uint32_t w = result_->vertex_map[v];
      if (w < exact_.size() && result_->mesh.points[w] == in_.mesh.points[v]) exact_[w] = in_file_[v];
    }
  }

  IndexedMesh::Point point(std::uint32_t w, const Scene::Placement& placement) const {
    if (exact_[w] != MeshFile::left_out) return scene_.file_points[exact_[w]];
    return (result_->mesh.points[w] - placement.offset) / placement.scale;
  }

  /// \return for each vertex of the result the first that stands for it
  std::vector<std::uint32_t> write_pieces() {
    std::vector<std::vector<std::uint32_t>> faces(scene_.pieces.size());
    for (std::uint32_t f = 0; f < result_->parts.size(); ++f) faces[result_->parts[f]].push_back(f);
    std::vector<std::uint32_t> first(result_->mesh.points.size(), 0);
    std::vector<bool> seen(result_->mesh.points.size(), false);
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (meshes_[scene_.pieces[i].mesh] == kNotWritten) continue;
      const PieceVertices vertices = write_piece(scene_.pieces[i], faces[i]);
      for (std::uint32_t k = 0; k < vertices.corners.size(); ++k) {
        const std::uint32_t corner = vertices.corners[k];
        const std::uint32_t w = result_->mesh.triangles[corner / 3][corner % 3];
        if (!seen[w]) first[w] = begin + k;
        seen[w] = true;
      }
      begin += static_cast<std::uint32_t>(vertices.corners.size());
    }
    report_.doubled_vertices += begin - std::min<std::size_t>(begin, result_->mesh.points.size());
    return first;
  }

  PieceVertices write_piece(const Scene::Piece& piece, const std::vector<std::uint32_t>& faces) {
    std::vector<const Attribute*> attributes;
    for (const Scene::Channel& channel : piece.channels)
      if (const Attribute* attribute = find(channel.name)) attributes.push_back(attribute);
    std::vector<const Attribute*> at_corners;
    for (const Attribute* attribute : attributes)
      if (!attribute->per_vertex()) at_corners.push_back(attribute);
    PieceVertices vertices = vertices_of(result_->mesh, faces, at_corners);
    Json part = output_->json()["meshes"][meshes_[piece.mesh]]["primitives"][piece.primitive];
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
    output_->json()["meshes"][meshes_[piece.mesh]]["primitives"][piece.primitive] = std::move(part);
    return vertices;
  }

  const Attribute* find(const std::string& name) const {
    const auto found = std::find_if(result_->attributes.begin(), result_->attributes.end(),
                                    [&](const Attribute& attribute) { return attribute.name == name; });
    return found == result_->attributes.end() ? nullptr : &*found;
  }

  std::size_t add_positions(const Scene::Piece& piece, const PieceVertices& vertices) {
    std::vector<float> values;
    for (const std::uint32_t corner : vertices.corners)
      for (const double x :
           point(result_->mesh.triangles[corner / 3][corner % 3], scene_.placements[piece.mesh])) {
        values.push_back(static_cast<float>(x));
        if (!std::isfinite(values.back()))
          throw Fault("not written: a coordinate is too large for a 32-bit float");
      }
    return output_->add_floats(values, 3, true);
  }

  void add_channel(Json& part, const Scene::Channel& channel, const Attribute& attribute,
                   const PieceVertices& vertices) {
    std::vector<float> values = values_of(result_->mesh, vertices, attribute);
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
  const SceneResult* result_ = nullptr;  ///< the level at hand
  WriteReport& report_;
  Json document_, empty_ = Json::array();
  std::optional<GltfOutput> output_;
  std::vector<std::size_t> meshes_;  ///< of each mesh of the document the one that is written, or none
  std::vector<std::uint32_t> in_file_;
  std::vector<std::uint32_t> exact_;  ///< for each vertex the one of the file that it still is
};

}  // namespace

Encoded encode_scene_levels(const fs::path& path, const MeshFile& in, const std::vector<SceneLevel>& levels,
                            const WriteOptions& options) {
  return naming(path, [&] {
    if (levels.empty()) throw Fault("not written: there is no level of detail");
    const Format format = format_to_write(path, options);
    Encoded out;
    try {
      SceneWriter writer(in, out.report);
      writer.run(levels);
      carry_images(*in.scene, path, format == Format::glb, writer.output(), out);
      encode_gltf(writer.output(), path, format, options, false, out);
    } catch (const Json::exception&) {
      throw Fault("not written: the JSON of the input is damaged; --flatten writes its triangles alone");
    }
    if (is_gzip_name(path)) out.bytes = gzipped(out.bytes);
    return out;
  });
}

Encoded encode_scene(const fs::path& path, const MeshFile& in, const SceneResult& result,
                     const WriteOptions& options) {
  return encode_scene_levels(path, in, {{result, {}}}, options);
}

bool has_levels(const MeshFile& file) {
  if (!file.scene || !file.scene->document.contains("nodes")) return false;
  const Json& nodes = file.scene->document["nodes"];
  return std::any_of(nodes.begin(), nodes.end(), [](const Json& node) {
    return node.contains(Json::json_pointer("/extensions/MSFT_lod"));
  });
}

}  // namespace whittle::files
