/// \file
/// Reading and writing meshes: OBJ, PLY (ASCII and binary), OFF and STL (ASCII and binary).
///
/// The readers are our own because OpenMesh's crash or hang on damaged files. They read the whole file into
/// memory first, trust no count in it, and never allocate more than a small multiple of the file's size.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "whittle/IndexedMesh.hh"

namespace whittle::files {

/// A file that cannot be read or written. `what()` is one line that names the file and, in text formats, the
/// line: `bunny.obj:17: a face has fewer than three vertices`.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was in the file that the mesh does not hold as it stood there. Nothing is lost silently: `notes()`.
struct ReadReport {
  std::string format;                  ///< for people: "OBJ", "PLY, binary little endian"
  std::size_t polygons = 0;            ///< faces with more than three corners, split into fans
  std::size_t dropped_degenerate = 0;  ///< triangles that name a vertex twice, left out
  std::size_t merged_vertices = 0;     ///< STL only: corners joined because they are bitwise equal
  std::vector<std::string> ignored;    ///< attributes not read: "vertex normals", "texture coordinates"

  /// One short line for each thing above that happened; empty where the mesh is the file as it stands.
  std::vector<std::string> notes() const;
};

struct MeshFile {
  IndexedMesh mesh;
  bool single_precision = false;  ///< the file holds 32-bit floats, so writing more digits adds nothing
  ReadReport report;
};

/// Reads a mesh; the format is told by the content where that is certain (PLY, OFF), else by the extension.
/// \throw FileError  missing, unreadable, unknown format, damaged, cut off, an index out of range, a
///                   coordinate that is not finite.
MeshFile read_mesh(const std::filesystem::path& path);

struct WriteOptions {
  bool ascii = false;             ///< PLY and STL are binary unless this is set; OBJ and OFF are always text
  bool single_precision = false;  ///< write 32-bit floats (text: the shortest that reads back the same float)
};

/// Writes a mesh whole or not at all: to a temporary file beside the target, flushed, then renamed.
/// \throw FileError  unknown extension, folder missing or not writable, disk full.
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options = {});

/// Throws what write_mesh would throw for a target that cannot be written, before any work is done.
void check_writable(const std::filesystem::path& path);

/// The same for write_file, which asks nothing of the extension. Both leave nothing behind.
/// \throw FileError
void check_creatable(const std::filesystem::path& path);

/// Writes any text or bytes with the same whole-or-nothing guarantee (JSON, Markdown, PNG).
/// An existing target keeps its permission bits, a symbolic link is followed, and a device or a pipe
/// (/dev/stdout) is written to as it is, without the guarantee.
/// \throw FileError
void write_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace whittle::files
