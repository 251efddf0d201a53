/// \file
/// Reading and writing meshes with their attributes: OBJ, PLY, OFF, STL, OpenMesh's OM, 3MF and glTF 2.0.
/// What each format holds and every rule of reading and repair: docs/files.md.
///
/// OpenMesh's readers are not used: they crash or hang on damaged files. They read the whole file into
/// memory first, trust no count in it, and never allocate more than a small multiple of the file's size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "attributes/Attribute.hh"
#include "files/Parts.hh"
#include "whittle/surface/IndexedMesh.hh"

namespace whittle::files {

/// A file that cannot be read or written. `what()` is one line that names the file and, in text formats, the
/// line: `bunny.obj:17: a face has fewer than three vertices`.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What to do about a mesh that is not as it should be. In all modes polygons become fans and triangles that
/// name a vertex twice go.
enum class Repair {
  none,  ///< nothing else is looked at; an index out of range or a coordinate that is not finite is an error
  report,  ///< the same errors; duplicated faces and what is not manifold stay, and are counted
  fix      ///< no such errors: what is broken goes, duplicates go, and the rest is cut until it is manifold
};

/// "none", "report" or "fix".
std::string to_string(Repair repair);

struct ReadOptions {
  Repair repair = Repair::report;
  /// Vertices no farther from each other become one, in any format; a chain of them as a whole. Model units, not
  /// negative, at most 1 % of the bounding box's diagonal; 0: only at equal coordinates, and with Repair::none not even
  /// those (but in STL and glTF)
  double weld = 0;
  /// glTF: each mesh of the file once, with all that can be written back into the same scene; else all meshes that the
  /// scene shows, at their places, as one, with what other formats know of materials
  bool keep_scene = false;
};

/// What was in the file that the mesh does not hold as it stood there. Nothing is lost silently: `notes()`.
struct ReadReport {
  std::string format;                ///< for people: "OBJ", "PLY, binary little endian"
  Repair repair = Repair::report;    ///< as requested; decides what happened to what is counted below
  std::size_t polygons = 0;          ///< faces with more than three corners, cut into triangles
  std::size_t concave_polygons = 0;  ///< of them, cut by ear clipping
  std::size_t crossing_polygons =
      0;                          ///< of them, whose sides cross: no triangles cover them without overlaps
  std::size_t flat_polygons = 0;  ///< of them, without area
  std::size_t dropped_degenerate = 0;  ///< triangles that name a vertex twice, left out
  std::size_t merged_vertices = 0;     ///< joined with another at the same place; STL: corners
  std::size_t vertices_apart = 0;      ///< at the place of another, not joined: their faces only touch
  std::size_t edges_left_open =
      0;  ///< between such, as their faces have opposite orientations; fix: turned, joined
  std::size_t lone_faces = 0;      ///< that share no edge, where half of all are so; else 0
  std::size_t parts = 0;           ///< glTF: pieces of the scene, where more than one became this mesh
  std::size_t missing_values = 0;  ///< corners or vertices to which the file gives no value; they got one
  std::size_t zeroed_values = 0;   ///< normals, colours, texture coordinates not finite; read as 0
  std::size_t overlong_lines =
      0;  ///< PLY, ASCII: with more values than the header declares, which are not read
  std::string wrong_count =
      {};  ///< fix: a line on a count of faces that is not what is in the file; read to its end

  std::size_t broken_faces = 0;          ///< fix: use a vertex that is missing or not finite; left out
  std::size_t duplicate_faces = 0;       ///< on the same three vertices as an earlier one; fix: left out
  std::size_t nonmanifold_edges = 0;     ///< of three faces or more, or of two that disagree; fix: repaired
  std::size_t nonmanifold_vertices = 0;  ///< between fans of faces that share no edge; fix: repaired
  std::size_t turned_faces = 0;          ///< fix: turned round to agree with their neighbours
  std::size_t copied_vertices = 0;       ///< fix: made where the mesh was cut
  std::size_t dropped_vertices = 0;      ///< fix: not finite, or of no face; left out

  std::vector<std::string> ignored;          ///< what is not read: "lines", "face colours"
  std::vector<std::string> ignored_besides;  ///< the same, of what is no part of the shape: "animations"
  /// Files that it names, of materials or images, which are missing
  std::set<std::string> not_found;
  /// Such that are not looked at, each with the reason: "'/a/b.mtl', an absolute path"
  std::set<std::string> refused = {};
  std::vector<std::string> rounded;  ///< attributes with values that a 32-bit float does not hold

  /// One short line for each thing above that happened; empty where the mesh is the file as it stands.
  std::vector<std::string> notes() const;
  /// Those of them that matter where only the shape counts, as it is measured.
  std::vector<std::string> notes_on_shape() const;
  /// Those of them that tell of files which are named and were not read.
  std::vector<std::string> lost_files() const;
};

struct Scene;

struct MeshFile {
  IndexedMesh mesh;
  attributes::Attributes attributes;   ///< at corners only where the corners of a vertex differ
  Parts parts;                         ///< which faces belong together, and their materials
  std::shared_ptr<const Scene> scene;  ///< glTF: where the mesh comes from, if that is asked for
  /// Files that it names and that are there: libraries, images, data; nothing may be written over them
  std::set<std::filesystem::path> files_beside = {};
  double diagonal = 0;    ///< of all that the scene shows, model units; 0: the mesh is all that there is
  std::string unit = {};  ///< 3MF: in which its numbers count, "inch"; empty: not said
  bool single_precision = false;     ///< the file holds 32-bit floats, so writing more digits adds nothing
  bool texture_at_vertices = false;  ///< PLY, OFF: a vertex for each texture coordinate along seams
  /// For each vertex of the file (STL: of those that were joined) the mesh's; `left_out`: it is in no face and was left
  /// out by Repair::fix. Empty: they are the same
  std::vector<std::uint32_t> vertex_of;
  static constexpr std::uint32_t left_out = static_cast<std::uint32_t>(-1);
  ReadReport report;
};

/// The extensions of the formats that can be read, and written, with their dot.
/// \{
std::vector<std::string> readable_extensions();
std::vector<std::string> writable_extensions();
/// \}

/// What a name says of the format, in lower case and with its dot: ".ply" of "a.ply" and of "a.PLY.gz".
std::string extension_of_format(const std::filesystem::path& path);

/// The same with the ".gz" of a packed file.
std::string whole_extension(const std::filesystem::path& path);

/// Reads a mesh, also one packed by gzip; the format is told by the content where that is certain, else by the extension.
/// \param path  "-" is standard input, where only the content tells the format
/// \throw FileError  missing, unreadable, unknown format, damaged, cut off; see Repair for the rest
MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

struct WriteOptions {
  bool ascii = false;             ///< PLY and STL are binary unless this is set
  bool single_precision = false;  ///< write 32-bit floats (text: the shortest that reads back the same float)
  std::string format = {};        ///< "ply", "glb", …: instead of what the extension says
  /// PLY: a vertex for each texture coordinate along seams instead of a list at each face
  bool texture_at_vertices = false;
  /// In which the numbers count, as 3MF says it: "inch". No other format does. Empty: not known, which 3MF takes as the
  /// millimetre
  std::string unit = {};
  /// Libraries of materials and images that are files: copied beside the result, instead of referred to where they are
  bool copy_materials = false;
  /// glTF: bits of a coordinate where positions, normals and texture coordinates are rounded, KHR_mesh_quantization, 8 to 16;
  /// 0: 32-bit floats
  int quantize = 0;
  bool meshopt = false;  ///< glTF: packed by EXT_meshopt_compression
};

/// Takes away what the file will not hold, before it constrains anything: attributes of a kind that the format does not
/// know, and all but the first set of a kind.
/// \param keeps  whether an attribute stays all the same
/// \return what has gone, as WriteReport::left_out names it
/// \throw FileError  unknown format
std::vector<std::string> take_unwritable(attributes::Attributes& attributes,
                                         const std::filesystem::path& path, const WriteOptions& options,
                                         const std::function<bool(const attributes::Attribute&)>& keeps);

/// Whether a file of this name can say what its faces are made of.
/// \throw FileError  unknown format
bool holds_materials(const std::filesystem::path& path, const WriteOptions& options = {});

/// Whether a file of this name has its coordinates as text.
/// \throw FileError  unknown format
bool writes_text(const std::filesystem::path& path, const WriteOptions& options = {});

/// Whether all coordinates are numbers of so few digits that text of 32-bit floats says them: each is the shortest text
/// of a float, or that of nine digits, but for the last bits of a double.
bool are_texts_of_floats(const IndexedMesh& mesh);

/// What a file could not take.
struct WriteReport {
  std::vector<std::string> left_out;    ///< "colours", "property 'quality'"
  std::vector<std::string> reduced;     ///< lines: "colours rounded to 8 bits"
  std::vector<std::string> lost_files;  ///< lines on files that are named, but were not read
  /// What became of the materials, a line: "materials in two.mtl"; empty: there are none
  std::string materials;
  /// OBJ, PLY, OFF, GLB (of all levels): written again for values that differ at their corners
  std::size_t doubled_vertices = 0;
  /// For each vertex of the mesh the first of the file that stands for it; empty: they are the same
  std::vector<std::uint32_t> first_vertex;

  /// One short line for each thing above.
  std::vector<std::string> notes() const;
};

/// A file that belongs beside a mesh's file: a library of materials, an image, a buffer.
struct Companion {
  std::filesystem::path path;
  std::string bytes;
};

/// A mesh as the bytes of a file, what that file could not take, and what belongs beside it.
struct Encoded {
  std::string bytes;
  WriteReport report;
  std::vector<Companion> companions;
};

/// The bytes that write_mesh would write, for a run that writes several files (Outputs).
/// \throw FileError  unknown format, or a mesh that no reader would take back
Encoded encode_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                    const WriteOptions& options = {}, const attributes::Attributes& attributes = {},
                    const Parts& parts = {});

/// Writes a mesh whole or not at all: beside the target, flushed, then renamed. Packed by gzip where the name ends so.
/// \param path  "-" is standard output, for which options.format must be set; it is written as it is, without
///              the guarantee
/// What belongs beside it appears together with it; a file that is there already is not replaced, and must be the same.
/// \throw FileError  unknown format, folder missing or not writable, disk full.
WriteReport write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                       const WriteOptions& options = {}, const attributes::Attributes& attributes = {},
                       const Parts& parts = {});

/// What a decimation has made of the mesh of a scene.
struct SceneResult {
  const IndexedMesh& mesh;
  const attributes::Attributes& attributes;
  const std::vector<std::uint32_t>& parts;       ///< for each face the part that it is of
  const std::vector<std::uint32_t>& vertex_map;  ///< for each vertex of the input the one that it became
};

/// Whether a file is glTF by its name, so that a scene can be written back into it.
/// \throw FileError  unknown format
bool holds_scenes(const std::filesystem::path& path, const WriteOptions& options = {});

/// For each face the number of its mesh in the document. \pre the mesh was read from a scene
std::vector<std::uint32_t> meshes_of_faces(const MeshFile& file);

/// The scene that a mesh was read from, with the triangles of a result. All the rest of it stays: nodes, materials,
/// images, animations, extensions.
/// \param in  as it was read with ReadOptions::keep_scene
/// \throw FileError
Encoded encode_scene(const std::filesystem::path& path, const MeshFile& in, const SceneResult& result,
                     const WriteOptions& options = {});

/// One level of detail.
struct Level {
  IndexedMesh mesh;
  attributes::Attributes attributes = {};
  Parts parts = {};
  double error = 0;  ///< how far it lies from the first level, in model units
};

/// The bytes that write_glb_levels would write.
Encoded encode_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels,
                          const WriteOptions& options = {});

/// Writes levels of detail into one GLB with the extension MSFT_lod, the finest first. read_mesh reads the
/// first and notes the others.
/// \throw FileError  as write_mesh; also where there is no level
WriteReport write_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels);

/// Throws what write_mesh would throw for a target that cannot be written, before any work is done.
void check_writable(const std::filesystem::path& path, const WriteOptions& options = {});

/// The same for write_file, which accepts any extension. Both leave nothing behind.
/// \throw FileError
void check_creatable(const std::filesystem::path& path);

/// Writes any text or bytes with the same whole-or-nothing guarantee (JSON, Markdown, PNG).
/// An existing target keeps its permission bits and, where that is allowed, its owner; a symbolic link is
/// followed, and a device or a pipe ("-", /dev/stdout) is written to as it is, without the guarantee.
/// \throw FileError
void write_file(const std::filesystem::path& path, const std::string& bytes);

/// Puts a finished file where write_file would have put its bytes; it is gone from where it was.
/// \throw FileError
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// All bytes of a file or a pipe; devices, of which some have no end, are refused. "-" is standard input.
/// \throw FileError
std::string read_file(const std::filesystem::path& path);

}  // namespace whittle::files
