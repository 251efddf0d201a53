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
#include "files/join.hh"
#include "files/mtl.hh"
#include "files/repair.hh"

namespace whittle::files {
namespace {

/// All that comes from a descriptor. A device such as /dev/zero has no end, so only what has one is read.
std::string read_all(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0) throw Fault(error_text(errno));
  if (S_ISDIR(status.st_mode)) throw Fault(error_text(EISDIR));
  const bool regular = S_ISREG(status.st_mode);
  if (!regular && !S_ISFIFO(status.st_mode) && !S_ISSOCK(status.st_mode))
    throw Fault("neither a file nor a pipe");

  constexpr std::size_t chunk = 1 << 16;
  std::string bytes(regular ? static_cast<std::size_t>(status.st_size) : 0, '\0');
  std::size_t used = 0;
  for (;;) {
    if (!regular && bytes.size() - used < chunk) bytes.resize(2 * bytes.size() + chunk);
    const ssize_t got = ::read(file, bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Fault(error_text(errno));
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  bytes.resize(used);
  return bytes;
}

std::string read_path(const std::filesystem::path& path) {
  if (path == "-") return read_all(STDIN_FILENO);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) throw Fault(error_text(errno));
  return read_all(file.get());
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
    case Format::gltf:
      break;
  }
  return read_gltf(bytes, options, path);
}

MeshFile read_named(const std::filesystem::path& path, const ReadOptions& options, std::size_t& line) {
  const std::string bytes = read_path(path);
  if (bytes.empty()) throw Fault("the file is empty");
  if (path == "-") return parse(bytes, likely_format(bytes), options, line, path);
  Format format{};
  if (!format_of_content(bytes, format)) format = format_of_extension(path.extension().string());
  return parse(bytes, format, options, line, path);
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
  // STL has corners only; glTF doubles every vertex along seams; OM has half-edges, which say what hangs together.
  const bool is_stl = format == Format::stl, is_gltf = format == Format::glb || format == Format::gltf;
  const bool joins =
      options.weld != 0 || is_stl || is_gltf || (options.repair != Repair::none && format != Format::om);
  if (joins) join(file, {options.weld, options.repair == Repair::fix, is_stl});
  if (is_stl) file.vertex_of.clear();
  if (is_gltf) file.texture_at_vertices = false;  // glTF has no other way, so it says nothing about PLY
  repair(file, options.repair);
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
