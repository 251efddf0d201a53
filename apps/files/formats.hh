/// \file
/// One reader and one writer for each format. All of them throw Fault.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "files/MeshFile.hh"

namespace whittle::files {

class GltfOutput;
struct PlyImages;

enum class Format { obj, off, ply, stl, om, glb, gltf, three_mf };

/// The format that an extension names, in any case of letters, with its dot.
/// \throw Fault  it names none
Format format_of_extension(const std::string& extension);

/// The format in which a file of this name is written.
/// \throw Fault  unknown
Format format_to_write(const std::filesystem::path& path, const WriteOptions& options);

/// The format that the content names without doubt.
/// \return false if it names none
bool format_of_content(std::string_view bytes, Format& format);

/// As format_of_content, but also takes what is only likely: for streams, which have no extension.
/// \throw Fault  it is like none
Format likely_format(std::string_view bytes);

/// Reads and repairs. What the file names besides itself is looked for beside `path`. Keeps `line` at the line it is on, for the error message; 0 where the file is not text.
MeshFile parse(std::string_view bytes, Format format, const ReadOptions& options, std::size_t& line,
               const std::filesystem::path& path = "-");

/// The readers; what is left to do behind them is repair().
/// \{
MeshFile read_obj(std::string_view bytes, const ReadOptions& options, std::size_t& line);
MeshFile read_off(std::string_view bytes, const ReadOptions& options, std::size_t& line);
/// \param path  of the file, in whose folder images may be
MeshFile read_ply(std::string_view bytes, const ReadOptions& options, std::size_t& line,
                  const std::filesystem::path& path);
MeshFile read_stl(std::string_view bytes, const ReadOptions& options, std::size_t& line);
MeshFile read_om(std::string_view bytes, const ReadOptions& options);
MeshFile read_three_mf(std::string_view bytes, const ReadOptions& options);
/// The binary container, and JSON. \param path  of the file, in whose folder there may be data
MeshFile read_glb(std::string_view bytes, const ReadOptions& options, const std::filesystem::path& path);
MeshFile read_gltf(std::string_view bytes, const ReadOptions& options, const std::filesystem::path& path);
/// \}

/// True if the content alone says so, whatever the file is called.
/// \{
bool is_off(std::string_view bytes);
bool is_ply(std::string_view bytes);
bool is_om(std::string_view bytes);
bool is_glb(std::string_view bytes);
/// \}

/// True if the content looks like it. Any text may be an OBJ file, and any bytes an STL file.
/// \{
bool may_be_obj(std::string_view bytes);
bool may_be_stl(std::string_view bytes);
/// \}

/// The bytes in a format, not packed; makes sure first that a reader will take them back.
/// \param path  of the file, for what belongs beside it
void encode_as(const std::filesystem::path& path, const IndexedMesh& mesh,
               const attributes::Attributes& attributes, const WriteOptions& options, Format format,
               const Parts& parts, Encoded& out);

/// The writers. They are given indices in range, values that fit the mesh and are finite but for scalars.
/// \{
std::string obj_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, const Parts& parts,
                      const std::vector<std::string>& libraries, WriteReport& report);
std::string off_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, WriteReport& report);
std::string ply_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, const PlyImages& images, WriteReport& report);
std::string stl_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, WriteReport& report);
std::string three_mf_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                           const WriteOptions& options, const Parts& parts, WriteReport& report);
std::string om_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                     const WriteOptions& options, WriteReport& report);

/// A level without its data.
struct LevelView {
  const IndexedMesh* mesh;
  const attributes::Attributes* attributes;
  const Parts* parts;
  double error;
};

/// A document with a level, or several that hang on the first.
GltfOutput gltf_of(const std::vector<LevelView>& levels, WriteReport& report);
/// \}

/// The document as the bytes of a GLB, or of a .gltf and its data beside it.
/// \param path  of the file
/// \param options  how it is packed
/// \param is_own   the document is of this program: its nodes may be changed
void encode_gltf(GltfOutput& document, const std::filesystem::path& path, Format format,
                 const WriteOptions& options, bool is_own, Encoded& out);

}  // namespace whittle::files
