/// \file
/// From a path to a mesh: the file into memory, then the reader of its format.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>

#include "files/Descriptor.hh"
#include "files/Fault.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Regular files and pipes only: a device such as /dev/zero has no end.
std::string read_bytes(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) throw Fault(error_text(errno));
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw Fault(error_text(errno));
  if (S_ISDIR(status.st_mode)) throw Fault(error_text(EISDIR));
  if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode)) throw Fault("neither a file nor a pipe");

  constexpr std::size_t pipe_chunk = 1 << 16;
  const std::size_t size = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  std::string bytes(size, '\0');
  std::size_t used = 0;
  for (;;) {
    if (S_ISFIFO(status.st_mode) && bytes.size() - used < pipe_chunk)
      bytes.resize(2 * bytes.size() + pipe_chunk);
    const ssize_t got = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Fault(error_text(errno));
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  bytes.resize(used);
  if (bytes.empty()) throw Fault("the file is empty");
  return bytes;
}

MeshFile read_format(const std::string& bytes, const std::string& extension, std::size_t& line) {
  if (is_ply(bytes)) return read_ply(bytes, line);
  if (is_off(bytes)) return read_off(bytes, line);
  switch (format_of_extension(extension)) {
    case Format::obj:
      return read_obj(bytes, line);
    case Format::off:
      return read_off(bytes, line);
    case Format::ply:
      return read_ply(bytes, line);
    case Format::stl:
      break;
  }
  return read_stl(bytes, line);
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& path) {
  std::size_t line = 0;
  try {
    return read_format(read_bytes(path), path.extension().string(), line);
  } catch (const Fault& fault) {
    throw FileError(path.string() + (line > 0 ? ":" + std::to_string(line) : "") + ": " + fault.what());
  } catch (const std::bad_alloc&) {
    throw FileError(path.string() + ": does not fit in memory");
  } catch (const std::length_error&) {  // a sparse file can claim any size
    throw FileError(path.string() + ": does not fit in memory");
  }
}

std::vector<std::string> ReadReport::notes() const {
  std::vector<std::string> notes;
  if (polygons > 0)
    notes.push_back(counted(polygons, "face", "faces") +
                    " with more than three corners split into triangles");
  if (dropped_degenerate > 0)
    notes.push_back(counted(dropped_degenerate, "triangle that names", "triangles that name") +
                    " a vertex twice left out");
  if (merged_vertices > 0)
    notes.push_back(counted(merged_vertices, "corner", "corners") + " joined with an equal one");
  std::string list;
  for (const std::string& attribute : ignored) list += (list.empty() ? "not read: " : ", ") + attribute;
  if (!list.empty()) notes.push_back(list);
  return notes;
}

}  // namespace whittle::files
