/// \file
/// From a path to a mesh: the file into memory, then the reader of its format.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>

#include "files/Descriptor.hh"
#include "files/Fault.hh"
#include "files/formats.hh"
#include "files/gzip.hh"
#include "files/join.hh"
#include "files/mtl.hh"
#include "files/places.hh"
#include "files/repair.hh"
#include "whittle/surface/threads.hh"

namespace whittle::files {
namespace {

/// The next bytes, none at the end.
std::size_t read_some(int file, char* to, std::size_t room) {
  for (;;) {
    const ssize_t got = ::read(file, to, room);
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) throw Fault(error_text(errno));
  }
}

/// What is packed from here on.
/// \param begin  the bytes that have been read already
std::string unpacked(int file, const std::string& begin) {
  Gunzip gunzip;
  gunzip.add(begin);
  std::string chunk(1 << 18, '\0');
  while (const std::size_t got = read_some(file, chunk.data(), chunk.size()))
    gunzip.add(std::string_view(chunk).substr(0, got));
  return gunzip.take();
}

/// All that comes from a descriptor. A device such as /dev/zero has no end, so only what has one is read.
/// \param gunzip  set to whether it was packed by gzip; null: not to be looked for
std::string read_all(int file, bool* gunzip) {
  struct stat status {};
  if (::fstat(file, &status) != 0) throw Fault(error_text(errno));
  if (S_ISDIR(status.st_mode)) throw Fault(error_text(EISDIR));
  const bool regular = S_ISREG(status.st_mode);
  if (!regular && !S_ISFIFO(status.st_mode) && !S_ISSOCK(status.st_mode))
    throw Fault("neither a file nor a pipe");

  constexpr std::size_t chunk = 1 << 16;
  std::string bytes;
  std::size_t used = 0;
  if (gunzip != nullptr) {
    bytes.resize(chunk);
    while (used < 3) {
      const std::size_t got = read_some(file, bytes.data() + used, chunk - used);
      if (got == 0) break;
      used += got;
    }
    *gunzip = is_gzip(std::string_view(bytes).substr(0, used));
    if (*gunzip) return unpacked(file, bytes.substr(0, used));
  }
  if (regular) bytes.resize(std::max(used, static_cast<std::size_t>(status.st_size)));
  for (;;) {
    if (!regular && bytes.size() - used < chunk) bytes.resize(2 * bytes.size() + chunk);
    const std::size_t got = read_some(file, bytes.data() + used, bytes.size() - used);
    if (got == 0) break;
    used += got;
  }
  bytes.resize(used);
  return bytes;
}

std::string read_path(const std::filesystem::path& path, bool* gunzip = nullptr) {
  if (path == "-") return read_all(STDIN_FILENO, gunzip);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) throw Fault(error_text(errno));
  return read_all(file.get(), gunzip);
}

MeshFile read_format(std::string_view bytes, Format format, const ReadOptions& options, std::size_t& line,
                     const std::filesystem::path& path) {
  switch (format) {
    case Format::obj:
      return read_obj(bytes, options, line);
    case Format::off:
      return read_off(bytes, options, line);
    case Format::ply:
      return read_ply(bytes, options, line);
    case Format::stl:
      return read_stl(bytes, options, line);
    case Format::om:
      return read_om(bytes, options);
    case Format::glb:
      return read_glb(bytes, options, path);
    case Format::three_mf:
      return read_three_mf(bytes, options);
    case Format::gltf:
      break;
  }
  return read_gltf(bytes, options, path);
}

MeshFile read_named(const std::filesystem::path& path, const ReadOptions& options, std::size_t& line) {
  bool was_packed = false;
  const std::string bytes = read_path(path, &was_packed);
  if (bytes.empty()) throw Fault("the file is empty");
  Format format{};
  if (path == "-")
    format = likely_format(bytes);
  else if (!format_of_content(bytes, format))
    format = format_of_extension(extension_of_format(path));
  MeshFile file = parse(bytes, format, options, line, path);
  if (was_packed) file.report.format += ", gzip";
  return file;
}

/// The sides of the faces and the places of the vertices, on two threads.
void look_ahead(const IndexedMesh& mesh, Sides& sides, std::vector<std::uint32_t>& place) {
  detail::Crew crew(detail::thread_count(0) > 1 && mesh.triangles.size() > 1000 ? 2 : 1);
  crew.each(2, [&](std::size_t i) {
    if (i == 0)
      sides = measure::sides_by_edge(mesh.triangles, mesh.points.size());
    else
      place = equal_places(mesh.points);
  });
}

/// Runs an action and turns what it throws into a FileError that names the file and, if it is text, the line.
template <typename Action>
auto naming_input(const std::filesystem::path& path, const std::size_t& line, Action action) {
  const std::string name = path == "-" ? "standard input" : path.string();
  try {
    return action();
  } catch (const Fault& fault) {
    throw FileError(name + (line > 0 ? ":" + std::to_string(line) : "") + ": " + fault.what());
  } catch (const std::bad_alloc&) {
    throw FileError(name + ": does not fit in memory");
  } catch (const std::length_error&) {  // a sparse file can claim any size
    throw FileError(name + ": does not fit in memory");
  }
}

}  // namespace

MeshFile parse(std::string_view bytes, Format format, const ReadOptions& options, std::size_t& line,
               const std::filesystem::path& path) {
  MeshFile file = read_format(bytes, format, options, line, path);
  line = 0;
  if (format == Format::obj) read_libraries(file, path);
  for (const Image& image : file.parts.images)
    if (!image.path.empty()) file.files_beside.insert(image.path);
  // STL has corners only; glTF doubles every vertex along seams; OM has half-edges, which say what hangs together.
  const bool is_stl = format == Format::stl, is_gltf = format == Format::glb || format == Format::gltf;
  const bool joins =
      options.weld != 0 || is_stl || is_gltf || (options.repair != Repair::none && format != Format::om);
  // Where no two vertices are at one place, which most files that name their vertices have not, both are done at once.
  const bool at_once = joins && options.weld == 0 && options.repair == Repair::report && !is_stl && !is_gltf;
  Sides sides;
  std::vector<std::uint32_t> place;
  if (at_once) look_ahead(file.mesh, sides, place);
  if (joins) join(file, {options.weld, options.repair == Repair::fix, is_stl}, std::move(place));
  if (file.report.merged_vertices > 0) sides.clear();
  if (is_stl) file.vertex_of.clear();
  if (is_gltf) file.texture_at_vertices = false;  // glTF has no other way, so it says nothing about PLY
  repair(file, options.repair, std::move(sides));
  return file;
}

MeshFile read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  std::size_t line = 0;
  return naming_input(path, line, [&] { return read_named(path, options, line); });
}

std::string read_file(const std::filesystem::path& path) {
  return naming_input(path, 0, [&] { return read_path(path); });
}

}  // namespace whittle::files
