/// \file
/// OpenMesh's own format, OM: writing.
#include <cstdint>
#include <limits>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/manifold.hh"
#include "files/om_format.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using om::ChunkHeader;
using om::Entity;
using om::Type;

constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();  // -1 when read as signed

/// The half-edges of a manifold mesh: two for each edge, first the one towards the higher vertex.
struct Halfedges {
  std::vector<std::uint32_t> next, to, face;  ///< of each half-edge
  std::vector<std::uint32_t> of_corner;       ///< the one that leaves each corner of each face
  std::vector<std::uint32_t> of_vertex;  ///< one that leaves each vertex, of the boundary if there is one
};

Halfedges connect(const IndexedMesh& mesh, const std::vector<measure::Side>& sides) {
  Halfedges all;
  all.of_corner.resize(sides.size());
  all.of_vertex.assign(mesh.points.size(), no_index);
  for_each_edge(sides, [&](const measure::Side* begin, const measure::Side* end) {
    const auto first = static_cast<std::uint32_t>(all.to.size());
    all.to.insert(all.to.end(), {begin->high, begin->low});
    all.face.insert(all.face.end(), {no_index, no_index});
    for (const measure::Side* side = begin; side < end; ++side) {
      const std::uint32_t half = first + (rises(mesh.triangles, *side) ? 0 : 1);
      all.face[half] = side->corner / 3;
      all.of_corner[side->corner] = half;
    }
  });
  all.next.assign(all.to.size(), no_index);
  for (std::uint32_t corner = 0; corner < all.of_corner.size(); ++corner) {
    const std::uint32_t half = all.of_corner[corner];
    all.next[half] = all.of_corner[measure::next_corner(corner)];
    all.of_vertex[all.to[half ^ 1U]] = half;
  }
  for (std::uint32_t half = 0; half < all.to.size(); ++half)
    if (all.face[half] == no_index) all.of_vertex[all.to[half ^ 1U]] = half;
  for (std::uint32_t half = 0; half < all.to.size(); ++half)
    if (all.face[half] == no_index) all.next[half] = all.of_vertex[all.to[half]];
  return all;
}

class OmWriter {
 public:
  OmWriter(const IndexedMesh& mesh, bool halfedges, std::size_t edges) : mesh_(mesh) {
    bytes_ = "OMT";
    // Lists of vertices, of the time before half-edges, hold what is not manifold; OpenMesh reads them, too.
    bytes_ += static_cast<char>(halfedges ? om::version(2, 2) : om::version(1, 2));
    for (const std::size_t count : {mesh.points.size(), mesh.triangles.size(), edges})
      append_little(bytes_, static_cast<std::uint32_t>(count));
  }

  void write_points(bool single_precision) {
    if (mesh_.points.empty()) return;
    begin({false, Entity::vertex, Type::position, true, true, 3, single_precision ? 0U : 1U});
    for (const IndexedMesh::Point& point : mesh_.points) {
      for (const double value : point) {
        if (single_precision)
          append_little(bytes_, static_cast<float>(value));
        else
          append_little(bytes_, value);
      }
    }
  }

  void write_normals(const Attribute& normal) {
    begin({false, Entity::vertex, Type::normal, true, true, 3, 0});
    for (const float value : normal.values) append_little(bytes_, value);
  }

  void write_colours(const Attribute& colour) {
    begin({false, Entity::vertex, Type::colour, false, false, 3, 0});
    for (std::size_t i = 0; i < colour.n_values(); ++i)
      for (std::size_t k = 0; k < 3; ++k) append_little(bytes_, to_byte(colour.value(i)[k]));
  }

  void write_texture(const Attribute& texture) {
    begin({false, Entity::vertex, Type::texture, true, true, 2, 0});
    for (std::size_t i = 0; i < texture.n_values(); ++i) write_texture(texture, i);
  }

  void write_halfedges(const Halfedges& all, const Attribute* texture_at_corners) {
    if (!all.to.empty()) {
      begin({false, Entity::halfedge, Type::topology, true, true, 3, 2});
      for (std::size_t half = 0; half < all.to.size(); ++half)
        for (const std::uint32_t number : {all.next[half], all.to[half], all.face[half]})
          append_little(bytes_, number);
      if (texture_at_corners) write_texture_of_halfedges(all, *texture_at_corners);
    }
    if (!mesh_.points.empty()) {
      begin({false, Entity::vertex, Type::topology, true, true, 1, 2});
      for (const std::uint32_t half : all.of_vertex) append_little(bytes_, half);
    }
    begin({false, Entity::face, Type::topology, true, true, 1, 2});
    // The half-edge that leads to the first corner, so that the order of the corners lasts.
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face)
      append_little(bytes_, all.of_corner[3 * face + 2]);
  }

  void write_vertex_lists() {
    begin({false, Entity::face, Type::topology, false, false, 1, 2});
    for (const IndexedMesh::Triangle& triangle : mesh_.triangles)
      for (const std::uint32_t corner : triangle) append_little(bytes_, corner);
  }

  /// \pre 0 < the length of the name < 256
  void write_scalar(const Attribute& scalar) {
    begin({true, Entity::vertex, Type::custom, false, false, 1, 0});
    for (const std::string& text : {scalar.name, std::string("float")}) {
      bytes_ += static_cast<char>(text.size());
      bytes_ += text;
    }
    append_little(bytes_, static_cast<std::uint32_t>(sizeof(float) * scalar.values.size()));
    for (const float value : scalar.values) append_little(bytes_, value);
  }

  std::string take() {
    begin({false, Entity::end, Type::position, false, false, 1, 0});
    return std::move(bytes_);
  }

 private:
  void begin(const ChunkHeader& header) { append_little(bytes_, header.pack()); }

  void write_texture(const Attribute& texture, std::size_t value) {
    append_little(bytes_, texture.value(value)[0]);
    append_little(bytes_, v_of(texture, value, false));
  }

  /// A half-edge has the value of the corner that it leads to.
  void write_texture_of_halfedges(const Halfedges& all, const Attribute& texture) {
    begin({false, Entity::halfedge, Type::texture, true, true, 2, 0});
    std::vector<std::uint32_t> value(all.to.size(), no_index);
    for (std::uint32_t corner = 0; corner < all.of_corner.size(); ++corner) {
      const std::uint32_t end = measure::next_corner(corner);
      value[all.of_corner[corner]] = texture.corners[end / 3][end % 3];
    }
    for (const std::uint32_t index : value) {
      if (index != no_index) {
        write_texture(texture, index);
      } else {
        append_little(bytes_, 0.0F);
        append_little(bytes_, 0.0F);
      }
    }
  }

  const IndexedMesh& mesh_;
  std::string bytes_;
};

bool has_vertex_twice(const IndexedMesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles)
    if (a == b || b == c || c == a) return true;
  return false;
}

std::size_t count_edges(const std::vector<measure::Side>& sides) {
  std::size_t edges = 0;
  for_each_edge(sides, [&](const measure::Side*, const measure::Side*) { ++edges; });
  return edges;
}

/// OpenMesh has a byte for each of three components.
void note_reduced_colours(const Attribute& colour, WriteReport& report) {
  if (!colour.bytes) reduce(report, "colours rounded to 8 bits");
  for (std::size_t i = 0; colour.components == 4 && i < colour.n_values(); ++i)
    if (colour.value(i)[3] != 1.0F) leave_out(report, "opacity");
}

}  // namespace

std::string om_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                     const WriteOptions& options, WriteReport& report) {
  if (mesh.triangles.size() > std::numeric_limits<std::int32_t>::max() / 3)
    throw Fault("not written: OM cannot name so many half-edges");
  const std::vector<measure::Side> sides = measure::sides_by_edge(mesh.triangles, mesh.points.size());
  const NonManifold found = count_nonmanifold(mesh, sides);
  const bool manifold = found.edges + found.vertices == 0 && !has_vertex_twice(mesh);
  const Choice choice = choose(attributes,
                               {Place::vertices, Place::vertices, manifold ? Place::corners : Place::vertices,
                                manifold ? Place::vertices : Place::nowhere},
                               report);
  OmWriter writer(mesh, manifold, count_edges(sides));
  writer.write_points(options.single_precision);
  if (choice.normal && !mesh.points.empty()) writer.write_normals(*choice.normal);
  if (choice.colour && !mesh.points.empty()) {
    note_reduced_colours(*choice.colour, report);
    writer.write_colours(*choice.colour);
  }
  const bool at_corners = choice.texture && !choice.texture->per_vertex();
  if (choice.texture && !at_corners && !mesh.points.empty()) writer.write_texture(*choice.texture);
  if (manifold)
    writer.write_halfedges(connect(mesh, sides), at_corners ? choice.texture : nullptr);
  else
    writer.write_vertex_lists();
  for (const Attribute* scalar : choice.scalars) {
    // OpenMesh keeps names with a colon at the second place to itself.
    const std::string& name = scalar->name;
    const bool possible = !name.empty() && name.size() < 256 && (name.size() < 2 || name[1] != ':');
    if (possible)
      writer.write_scalar(*scalar);
    else
      leave_out(report, to_string(*scalar));
  }
  return writer.take();
}

}  // namespace whittle::files
