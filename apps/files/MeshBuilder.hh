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

namespace whittle::files {

/// A corner of a face whose vertex is not there; only Repair::fix lets it come so far.
constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// A corner or a vertex without a value of an attribute that others have.
constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

/// Which values of an attribute the corners have, where a file names them apart from the vertices.
struct CornerValues {
  std::vector<std::uint32_t> face;               ///< of each corner of the face at hand; empty: it has none
  std::vector<IndexedMesh::Triangle> triangles;  ///< of the triangles so far, short where the last have none

  void add_triangle(std::size_t index, std::size_t last_corner);
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

  /// Splits the face into a fan and leaves out triangles that name a vertex twice; counts both.
  /// \param values  whose `face` is empty or has as many entries as the face has corners
  /// \throw Fault  fewer than three corners, unless that is to be fixed
  void add_face(const std::vector<std::uint32_t>& corners, std::initializer_list<CornerValues*> values = {});

  /// Takes the attribute over, if a corner has a value of it.
  void add_attribute(attributes::Attribute attribute, CornerValues& corners);

  /// Notes what is not read, once.
  void ignore(const std::string& what);

  /// A component of a normal, a colour or a texture coordinate; a value that is not finite becomes 0.
  float component(double value);

 private:
  MeshFile& file_;
  bool fixes_;
};

/// \param index  as it stands in the file, for the message
[[noreturn]] void throw_index_out_of_range(const std::string& things, std::int64_t index, std::size_t count);

/// To be called before memory is reserved for `count` things that take at least `least_bytes` each.
/// \param remaining  bytes of the file that are left to read
/// \throw Fault  the file cannot hold so many
void check_declared(std::uint64_t count, const std::string& things, std::size_t least_bytes,
                    std::size_t remaining);

}  // namespace whittle::files
