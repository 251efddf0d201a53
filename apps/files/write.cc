/// \file
/// From a mesh to a file: the extension picks the format.
#include <cmath>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

struct ExtensionOf {
  std::string_view extension;
  Format format;
};

constexpr ExtensionOf extensions[] = {
    {".obj", Format::obj}, {".off", Format::off}, {".ply", Format::ply}, {".stl", Format::stl}};

/// What no reader would take back is not written.
void check_mesh(const IndexedMesh& mesh, bool single_precision) {
  for (const IndexedMesh::Point& point : mesh.points) {
    for (const double value : point) {
      if (!std::isfinite(value)) throw Fault("not written: a coordinate is not finite");
      if (single_precision && !std::isfinite(static_cast<float>(value)))
        throw Fault("not written: a coordinate is too large for a 32-bit float");
    }
  }
  for (const IndexedMesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.points.size())
        throw Fault("not written: a triangle names a vertex that is not there");
}

std::string bytes_of(const IndexedMesh& mesh, const WriteOptions& options, Format format) {
  check_mesh(mesh, options.single_precision || format == Format::stl);
  switch (format) {
    case Format::obj:
      return obj_bytes(mesh, options);
    case Format::off:
      return off_bytes(mesh, options);
    case Format::ply:
      return ply_bytes(mesh, options);
    case Format::stl:
      break;
  }
  return stl_bytes(mesh, options);
}

}  // namespace

Format format_of_extension(const std::string& extension) {
  for (const ExtensionOf& known : extensions)
    if (same_word(known.extension, extension)) return known.format;
  throw Fault((extension.empty() ? "no extension" : "unknown format " + in_quotes(extension)) +
              "; known are .obj, .off, .ply and .stl");
}

void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options) {
  const std::string extension = path.extension().string();
  write_file(path, naming(path, [&] { return bytes_of(mesh, options, format_of_extension(extension)); }));
}

void check_writable(const std::filesystem::path& path) {
  naming(path, [&] { return format_of_extension(path.extension().string()); });
  check_creatable(path);
}

}  // namespace whittle::files
