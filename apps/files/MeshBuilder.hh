/// \file
/// Filling a mesh with what a reader found; the rules that all formats share stand here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "files/MeshFile.hh"
#include "files/PolygonCutter.hh"

namespace whittle::files {

/// A corner of a face whose vertex is not there; only Repair::fix lets it come so far.
constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// A corner or a vertex without a value of an attribute that others have.
constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

/// Which values of an attribute the corners have, where a file names them apart from the vertices.
struct CornerValues {
  std::vector<std::uint32_t> face;               ///< of each corner of the face at hand; empty: it has none
  std::vector<IndexedMesh::Triangle> triangles;  ///< of the triangles so far, short where the last have none
  std::vector<std::uint32_t> late;               ///< of the polygons that wait for MeshBuilder::cut_late()

  /// \param index     the triangle's
  /// \param of        its corners' values, by their place among `values`
  /// \param values    of the polygon's corners; none: the polygon has none
  void set_triangle(std::size_t index, const IndexedMesh::Triangle& of, const std::uint32_t* values);
};

class MeshBuilder {
 public:
  MeshBuilder(MeshFile& file, const ReadOptions& options)
      : file_(file), fixes_(options.repair == Repair::fix) {}

  bool fixes() const { return fixes_; }
  IndexedMesh& mesh() { return file_.mesh; }
  ReadReport& report() { return file_.report; }

  /// \throw Fault  not finite, unless that is to be fixed: repair() looks for such points then
  void add_point(double x, double y, double z);

  /// A vertex index that counts from 0, checked; `no_vertex` if it is wrong and that is to be fixed.
  /// \throw Fault  not below `vertices`
  std::uint32_t index(std::int64_t index, std::size_t vertices) const;

  /// Cuts the face into triangles and leaves out those that name a vertex twice; counts both.
  /// \param values  whose `face` is empty or has as many entries as the face has corners
  /// \throw Fault  fewer than three corners, unless that is to be fixed
  void add_face(const std::vector<std::uint32_t>& corners, std::initializer_list<CornerValues*> values = {});

  /// Cuts the polygons that were added before their vertices; to be called when all of those are there, for files that
  /// may have them in such an order. Behind it, drop_degenerate_faces() has to leave out what names a vertex twice.
  /// \param values  as for add_face
  void cut_late(std::initializer_list<CornerValues*> values = {});

  /// Takes the attribute over, if a corner has a value of it.
  void add_attribute(attributes::Attribute attribute, CornerValues& corners);

  /// Notes what is not read, once.
  void ignore(const std::string& what);

  /// The same of what is no part of the shape.
  void ignore_besides(const std::string& what);

  /// A component of a normal, a colour or a texture coordinate; a value that is not finite becomes 0.
  float component(double value);

 private:
  struct LatePolygon {
    std::size_t triangle;  ///< the first of those that it will be
    std::size_t corner;    ///< the first of its corners in `late_corners_`
    std::size_t corners;
  };
  void add_triangle(const std::uint32_t* corners, const IndexedMesh::Triangle& of,
                    std::initializer_list<CornerValues*> values);
  const std::vector<IndexedMesh::Triangle>& cut(const std::uint32_t* corners, std::size_t n);
  void count_shape(PolygonCutter::Shape shape);

  MeshFile& file_;
  bool fixes_;
  PolygonCutter cutter_;
  // Of the polygon at hand: the corners that are not the one before once more, their places, and its triangles.
  std::vector<std::uint32_t> kept_;
  std::vector<IndexedMesh::Point> places_;
  std::vector<IndexedMesh::Triangle> cut_;
  std::vector<LatePolygon> late_;
  std::vector<std::uint32_t> late_corners_;
};

/// \param index  as it stands in the file, for the message
[[noreturn]] void throw_index_out_of_range(const std::string& things, std::int64_t index, std::size_t count);

/// To be called before memory is reserved for `count` things that take at least `least_bytes` each.
/// \param remaining  bytes of the file that are left to read
/// \throw Fault  the file cannot hold so many
void check_declared(std::uint64_t count, const std::string& things, std::size_t least_bytes,
                    std::size_t remaining);

}  // namespace whittle::files
