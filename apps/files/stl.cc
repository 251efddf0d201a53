/// \file
/// STL, as text and binary. It names no vertices: corners that are bitwise equal become one.
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/TextWriter.hh"
#include "files/build.hh"
#include "files/bytes.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t preamble_bytes = header_bytes + 4;  // and the count
constexpr std::size_t triangle_bytes = 50;                // normal, three corners, attribute

using Corner = std::array<float, 3>;
using Point = IndexedMesh::Point;

/// Gives equal corners the same vertex, in the order in which they come. An open hash table of indices,
/// because a node for each vertex would take several times the file.
class CornerMerger {
 public:
  explicit CornerMerger(MeshFile& file) : file_(file), slots_(1024, free_slot) {}

  std::uint32_t vertex(const Corner& corner) {
    std::vector<Point>& points = file_.mesh.points;
    const Point point(corner[0], corner[1], corner[2]);
    std::uint32_t* slot = find(point);
    if (*slot != free_slot) {
      ++file_.report.merged_vertices;
      return *slot;
    }
    add_point(file_, point.x(), point.y(), point.z());
    const std::uint32_t added = *slot = static_cast<std::uint32_t>(points.size() - 1);
    if (points.size() > slots_.size() / 2) grow();
    return added;
  }

 private:
  static constexpr std::uint32_t free_slot = std::numeric_limits<std::uint32_t>::max();

  /// Comparing as numbers makes -0.0 equal to 0.0; the hash must agree, and x + 0.0 turns -0.0 into 0.0.
  static std::uint64_t hash(const Point& point) {
    std::uint64_t hash = 0;
    for (const double value : point) {
      const double positive_zero = value + 0.0;
      std::uint64_t bits;
      std::memcpy(&bits, &positive_zero, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    return hash;
  }

  /// The slot of this point, or the free one where it belongs.
  std::uint32_t* find(const Point& point) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(point) & mask;
    while (slots_[at] != free_slot && file_.mesh.points[slots_[at]] != point) at = (at + 1) & mask;
    return &slots_[at];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), free_slot);
    for (std::size_t i = 0; i < file_.mesh.points.size(); ++i)
      *find(file_.mesh.points[i]) = static_cast<std::uint32_t>(i);
  }

  MeshFile& file_;
  std::vector<std::uint32_t> slots_;
};

class TextStl {
 public:
  TextStl(std::string_view bytes, std::size_t& line, MeshFile& file)
      : in_(bytes, line, {}), file_(file), merger_(file) {}

  /// One solid or several.
  void read() {
    std::string_view word = in_.word_anywhere();
    while (!word.empty()) {
      check(word, "solid");
      skip_line();
      for (word = in_.word_anywhere(); !same_word(word, "endsolid"); word = in_.word_anywhere()) {
        check(word, "facet");
        read_facet();
      }
      skip_line();
      word = in_.word_anywhere();
    }
  }

 private:
  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) in_.word();  // follows from the corners; many files have NaN here
    expect("outer");
    expect("loop");
    corners_.clear();
    std::string_view word = in_.word_anywhere();
    for (; same_word(word, "vertex"); word = in_.word_anywhere()) {
      const float x = in_.real<float>();
      const float y = in_.real<float>();
      const float z = in_.real<float>();
      corners_.push_back(merger_.vertex({x, y, z}));
    }
    check(word, "endloop");
    expect("endfacet");
    add_face(file_, corners_);
  }

  /// The rest is the name of the solid.
  void skip_line() {
    while (!in_.word().empty()) continue;
  }

  void expect(std::string_view keyword) { check(in_.word_anywhere(), keyword); }

  static void check(std::string_view word, std::string_view keyword) {
    if (same_word(word, keyword)) return;
    throw Fault("expected " + in_quotes(keyword) + ", found " +
                (word.empty() ? "the end of the file" : in_quotes(word)));
  }

  TextReader in_;
  MeshFile& file_;
  CornerMerger merger_;
  std::vector<std::uint32_t> corners_;
};

Corner load_corner(const char* from) {
  return {load<float>(from, ByteOrder::little), load<float>(from + 4, ByteOrder::little),
          load<float>(from + 8, ByteOrder::little)};
}

std::uint32_t declared_triangles(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + header_bytes, ByteOrder::little);
}

void read_binary(std::string_view bytes, MeshFile& file) {
  if (bytes.size() < preamble_bytes) throw Fault("the file is cut off: too short for an STL header");
  const std::size_t count = declared_triangles(bytes);
  bytes.remove_prefix(preamble_bytes);
  if (count > bytes.size() / triangle_bytes)
    throw Fault("the file is cut off: it has room for " + std::to_string(bytes.size() / triangle_bytes) +
                " of " + std::to_string(count) + " triangles");
  file.mesh.triangles.reserve(count);
  CornerMerger merger(file);
  std::vector<std::uint32_t> corners(3);
  for (std::size_t i = 0; i < count; ++i) {
    const char* triangle = bytes.data() + i * triangle_bytes;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = merger.vertex(load_corner(triangle + 12 * (k + 1)));
    add_face(file, corners);
    if (load<std::uint16_t>(triangle + 48, ByteOrder::little) != 0) ignore(file, "face attributes");
  }
  if (bytes.size() > count * triangle_bytes) ignore(file, "bytes after the last triangle");
}

/// Many binary files begin with "solid" too. They have the size that their count asks for, or a zero byte in
/// the header, which no text has.
bool is_text(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || !same_word(bytes.substr(begin, 5), "solid")) return false;
  if (bytes.size() >= preamble_bytes &&
      bytes.size() == preamble_bytes + std::uint64_t{declared_triangles(bytes)} * triangle_bytes)
    return false;
  return bytes.substr(0, preamble_bytes).find('\0') == std::string_view::npos;
}

/// The normal is zero where the triangle has no area.
template <typename Emit>
void for_each_facet(const IndexedMesh& mesh, Emit emit) {
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Point& a = mesh.points[ia];
    const Point& b = mesh.points[ib];
    const Point& c = mesh.points[ic];
    emit((b - a).cross(c - a).stableNormalized(), a, b, c);
  }
}

std::string text_stl(const IndexedMesh& mesh) {
  TextWriter out(true);
  out << "solid whittle\n";
  for_each_facet(mesh, [&](const Point& normal, const Point& a, const Point& b, const Point& c) {
    out << "facet normal " << normal << "\nouter loop\n";
    out << "vertex " << a << "\nvertex " << b << "\nvertex " << c << "\nendloop\nendfacet\n";
  });
  out << "endsolid whittle\n";
  return out.take();
}

std::string binary_stl(const IndexedMesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw Fault("binary STL cannot hold more than 4294967295 triangles");
  std::string bytes = "binary STL, written by whittle";
  bytes.resize(header_bytes, '\0');
  bytes.reserve(preamble_bytes + mesh.triangles.size() * triangle_bytes);
  append_little(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for_each_facet(mesh, [&](const Point& normal, const Point& a, const Point& b, const Point& c) {
    for (const Point& point : {normal, a, b, c})
      for (const double value : point) append_little(bytes, static_cast<float>(value));
    append_little(bytes, std::uint16_t{0});
  });
  return bytes;
}

}  // namespace

MeshFile read_stl(std::string_view bytes, std::size_t& line) {
  MeshFile file;
  file.single_precision = true;
  if (is_text(bytes)) {
    file.report.format = "STL, ASCII";
    TextStl(bytes, line, file).read();
  } else {
    file.report.format = "STL, binary";
    read_binary(bytes, file);
  }
  return file;
}

std::string stl_bytes(const IndexedMesh& mesh, const WriteOptions& options) {
  return options.ascii ? text_stl(mesh) : binary_stl(mesh);
}

}  // namespace whittle::files
