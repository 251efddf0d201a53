/// \file
/// OpenMesh's own format, OM: reading. OpenMesh's reader trusts every count and index in it.
#include <cmath>
#include <cstdint>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/OmChunks.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/settle.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;
using om::Chunk;
using om::Entity;
using om::Type;

Attribute attribute_of(Kind kind, std::size_t components) {
  Attribute attribute;
  attribute.kind = kind;
  attribute.components = components;
  return attribute;
}

/// The numbers of a property by the name of its type, as OpenMesh writes it.
struct PropertyType {
  std::string_view name;
  std::size_t bytes;
  double (*load)(const char*);
};

template <typename T>
double load_as(const char* from) {
  return static_cast<double>(load<T>(from, ByteOrder::little));
}

constexpr PropertyType property_types[] = {
    {"float", 4, load_as<float>},          {"double", 8, load_as<double>},
    {"int8_t", 1, load_as<std::int8_t>},   {"uint8_t", 1, load_as<std::uint8_t>},
    {"int16_t", 2, load_as<std::int16_t>}, {"uint16_t", 2, load_as<std::uint16_t>},
    {"int32_t", 4, load_as<std::int32_t>}, {"uint32_t", 4, load_as<std::uint32_t>},
};

class OmReader {
 public:
  OmReader(std::string_view bytes, const ReadOptions& options) : chunks_(bytes), builder_(file_, options) {
    deleted_ = chunks_.find(Entity::face, Type::status);
    texture_at_sides_ = chunks_.find(Entity::halfedge, Type::texture);
    // What is not two floats is noted with the rest.
    if (texture_at_sides_ && !is_texture(*texture_at_sides_)) texture_at_sides_ = nullptr;
  }

  MeshFile read() {
    file_.report.format = "OM";
    read_points();
    if (chunks_.faces() > 0) {
      const Chunk* faces = chunks_.find(Entity::face, Type::topology);
      if (faces == nullptr) throw Fault("the faces lack their vertices");
      if (chunks_.version() < om::version(2, 0))
        read_vertex_lists(*faces);
      else
        read_loops(*faces);
    }
    for (const Chunk& chunk : chunks_.all()) read_attribute(chunk);
    builder_.add_attribute(std::move(texture_), texture_of_);
    if (chunks_.bytes_behind() > 0) builder_.ignore("bytes after the last chunk");
    settle(file_);
    return std::move(file_);
  }

 private:
  static bool is_texture(const Chunk& chunk) { return chunk.header.is_float && chunk.header.dimensions == 2; }

  void read_points() {
    const Chunk* points = chunks_.find(Entity::vertex, Type::position);
    if (points == nullptr && chunks_.vertices() > 0) throw Fault("the vertices lack their places");
    if (points == nullptr) return;
    if (points->header.dimensions != 3) throw Fault("vertices of other than three coordinates");
    file_.single_precision = points->header.is_float && points->header.size == 0;
    file_.mesh.points.reserve(chunks_.vertices());
    for (std::size_t i = 0; i < 3 * chunks_.vertices(); i += 3)
      builder_.add_point(points->real(i), points->real(i + 1), points->real(i + 2));
  }

  /// A face that was deleted in OpenMesh stays in its file, marked.
  bool is_deleted(std::size_t face) {
    if (deleted_ == nullptr) return false;
    const auto status =
        load<std::uint32_t>(deleted_->data.data() + om::status_bytes * face, ByteOrder::little);
    if ((status & om::deleted_bit) == 0) return false;
    builder_.ignore("faces marked as deleted");
    return true;
  }

  void read_vertex_lists(const Chunk& faces) {
    const bool polygons = chunks_.mesh_type() == 'P';
    const std::size_t number_bytes = faces.header.number_bytes();
    Chunk list = faces;  // what is left of it
    list.header.is_signed = false;
    std::size_t corners = chunks_.mesh_type() == 'T' ? 3 : 4;
    for (std::size_t face = 0; face < chunks_.faces(); ++face) {
      if (polygons) {
        corners = load<std::uint16_t>(list.data.data(), ByteOrder::little);
        list.data.remove_prefix(2);
      }
      corners_.clear();
      for (std::size_t k = 0; k < corners; ++k)
        corners_.push_back(builder_.index(list.integer(k), chunks_.vertices()));
      list.data.remove_prefix(corners * number_bytes);
      if (!is_deleted(face)) builder_.add_face(corners_);
    }
  }

  /// A face names one of its half-edges, and each half-edge the next one and the vertex that it leads to.
  void read_loops(const Chunk& faces) {
    const Chunk* sides = chunks_.find(Entity::halfedge, Type::topology);
    if (sides == nullptr || sides->header.dimensions != 3) throw Fault("the half-edges are missing");
    if (faces.header.dimensions != 1) throw Fault("the faces do not name one half-edge each");
    std::vector<bool> seen(chunks_.halfedges(), false);
    file_.mesh.triangles.reserve(chunks_.faces());
    for (std::size_t face = 0; face < chunks_.faces(); ++face) {
      if (is_deleted(face)) continue;
      if (walk(*sides, faces.integer(face), seen))
        builder_.add_face(corners_, {&texture_of_});
      else if (builder_.fixes())
        ++file_.report.broken_faces;
      else
        throw Fault("the half-edges of face " + std::to_string(face) + " do not make a loop of its own");
    }
  }

  /// \return whether the way leads back to where it began, over half-edges that no other face has
  bool walk(const Chunk& sides, std::int64_t first, std::vector<bool>& seen) {
    corners_.clear();
    texture_of_.face.clear();
    std::int64_t side = first;
    do {
      if (side < 0 || static_cast<std::uint64_t>(side) >= seen.size()) return false;
      const auto at = static_cast<std::size_t>(side);
      if (seen[at]) return false;
      seen[at] = true;
      corners_.push_back(builder_.index(sides.integer(3 * at + 1), chunks_.vertices()));
      if (texture_at_sides_) read_texture(at);
      side = sides.integer(3 * at);
    } while (side != first);
    return true;
  }

  void read_texture(std::size_t side) {
    texture_of_.face.push_back(static_cast<std::uint32_t>(texture_.n_values()));
    for (std::size_t k = 0; k < 2; ++k)
      texture_.values.push_back(builder_.component(texture_at_sides_->real(2 * side + k)));
  }

  void read_attribute(const Chunk& chunk) {
    const bool of_vertex = chunk.header.entity == Entity::vertex;
    if (chunk.header.type == Type::custom) {
      if (!of_vertex || !read_property(chunk)) builder_.ignore("property " + in_quotes(chunk.name));
    } else if (chunk.header.type == Type::topology || chunk.header.type == Type::position ||
               &chunk == texture_at_sides_) {
      return;
    } else if (chunk.header.type == Type::status) {
      builder_.ignore("status flags");
    } else if (of_vertex && chunk.header.type == Type::normal && chunk.header.dimensions == 3) {
      read_values(chunk, attribute_of(Kind::normal, 3));
    } else if (of_vertex && chunk.header.type == Type::texture && is_texture(chunk) && !texture_at_sides_) {
      read_values(chunk, attribute_of(Kind::texture, 2));
    } else if (of_vertex && is_colour(chunk)) {
      Attribute colour = attribute_of(Kind::colour, chunk.header.dimensions);
      colour.bytes = !chunk.header.is_float;
      read_values(chunk, std::move(colour));
    } else {
      builder_.ignore(name_of(chunk));
    }
  }

  static bool is_colour(const Chunk& chunk) {
    const om::ChunkHeader& header = chunk.header;
    return header.type == Type::colour && (header.dimensions == 3 || header.dimensions == 4) &&
           (header.is_float || header.size == 0);
  }

  void read_values(const Chunk& chunk, Attribute attribute) {
    const std::size_t count = chunks_.vertices() * attribute.components;
    attribute.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      attribute.values.push_back(attribute.bytes ? from_byte(static_cast<std::uint8_t>(chunk.data[i]))
                                                 : builder_.component(chunk.real(i)));
    file_.attributes.push_back(std::move(attribute));
  }

  bool read_property(const Chunk& chunk) {
    for (const PropertyType& type : property_types) {
      if (type.name != chunk.type_name) continue;
      if (chunk.data.size() != type.bytes * chunks_.vertices()) return false;
      Attribute scalar = attribute_of(Kind::scalar, 1);
      scalar.name = chunk.name;
      bool rounded = false;
      for (std::size_t i = 0; i < chunks_.vertices(); ++i) {
        const double value = type.load(chunk.data.data() + type.bytes * i);
        scalar.values.push_back(static_cast<float>(value));
        rounded = rounded || (std::isfinite(value) && static_cast<double>(scalar.values.back()) != value);
      }
      if (rounded) file_.report.rounded.push_back(to_string(scalar));
      file_.attributes.push_back(std::move(scalar));
      return true;
    }
    return false;
  }

  static std::string name_of(const Chunk& chunk) {
    const char* what = chunk.header.type == Type::normal    ? "normals"
                       : chunk.header.type == Type::texture ? "texture coordinates"
                                                            : "colours";
    switch (chunk.header.entity) {
      case Entity::vertex:
        return std::string("vertex ") + what;
      case Entity::face:
        return std::string("face ") + what;
      case Entity::mesh:
        return std::string("mesh ") + what;
      default:
        return std::string("edge ") + what;
    }
  }

  om::Chunks chunks_;
  MeshFile file_;
  MeshBuilder builder_;
  const Chunk* deleted_ = nullptr;
  const Chunk* texture_at_sides_ = nullptr;
  Attribute texture_ = attribute_of(Kind::texture, 2);
  CornerValues texture_of_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

bool is_om(std::string_view bytes) {
  return bytes.size() >= om::header_bytes && bytes.substr(0, 2) == "OM" &&
         std::string_view("TQP").find(bytes[2]) != std::string_view::npos;
}

MeshFile read_om(std::string_view bytes, const ReadOptions& options) {
  return OmReader(bytes, options).read();
}

}  // namespace whittle::files
