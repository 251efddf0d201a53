/// \file
/// STL, as text and binary. It names no vertices: every corner is one, for join() to find those that are the same.
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/TextReader.hh"
#include "files/TextWriter.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/rounding.hh"

namespace whittle::files {
namespace {

constexpr std::size_t stl_header_bytes = 80;
constexpr std::size_t preamble_bytes = stl_header_bytes + 4;  // and the count
constexpr std::size_t triangle_bytes = 50;                    // normal, three corners, attribute

using Point = IndexedMesh::Point;

class TextStl {
 public:
  TextStl(std::string_view bytes, std::size_t& line, MeshBuilder& builder)
      : in_(bytes, line, {}), builder_(builder) {}

  /// One solid or several. A file that ends early is read to its last whole facet, if that is to be fixed.
  void read() {
    try {
      read_solids();
    } catch (const Fault& fault) {
      if (in_.remaining() > 0) throw;
      if (!builder_.fixes())
        throw Fault(std::string(fault.what()) + ": the file is cut off; --repair fix reads what is there");
      IndexedMesh& mesh = builder_.mesh();
      mesh.points.resize(points_of_facets_);
      mesh.triangles.resize(triangles_of_facets_);
      builder_.report().wrong_count = "the file is cut off: read to its last whole facet";
    }
  }

 private:
  void read_solids() {
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
      corners_.push_back(static_cast<std::uint32_t>(builder_.mesh().points.size()));
      builder_.add_point(x, y, z);
    }
    check(word, "endloop");
    expect("endfacet");
    builder_.add_face(corners_);
    points_of_facets_ = builder_.mesh().points.size();
    triangles_of_facets_ = builder_.mesh().triangles.size();
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
  MeshBuilder& builder_;
  std::vector<std::uint32_t> corners_;
  std::size_t points_of_facets_ = 0, triangles_of_facets_ = 0;  ///< without the one at hand
};

std::uint32_t declared_triangles(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + stl_header_bytes, ByteOrder::little);
}

void read_binary(std::string_view bytes, MeshBuilder& builder) {
  if (bytes.size() < preamble_bytes) throw Fault("the file is cut off: too short for an STL header");
  const std::size_t declared = declared_triangles(bytes);
  bytes.remove_prefix(preamble_bytes);
  const std::size_t count = bytes.size() / triangle_bytes;
  if (count != declared) {
    const std::string what = std::to_string(declared) + " triangles are declared, " + std::to_string(count) +
                             (count < declared ? " are there: the file is cut off" : " are there");
    if (!builder.fixes()) throw Fault(what + "; --repair fix reads what is there");
    builder.report().wrong_count = what;
  }
  builder.mesh().triangles.reserve(count);
  builder.mesh().points.reserve(3 * count);
  std::vector<std::uint32_t> corners(3);
  for (std::size_t i = 0; i < count; ++i) {
    const char* triangle = bytes.data() + i * triangle_bytes;
    const auto coordinate = [&](std::size_t number) {
      return load<float>(triangle + sizeof(float) * number, ByteOrder::little);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t x = 3 * (k + 1);  // the normal comes first
      corners[k] = static_cast<std::uint32_t>(3 * i + k);
      builder.add_point(coordinate(x), coordinate(x + 1), coordinate(x + 2));
    }
    builder.add_face(corners);
    if (load<std::uint16_t>(triangle + 48, ByteOrder::little) != 0) builder.ignore("face attributes");
  }
  if (bytes.size() > count * triangle_bytes) builder.ignore("bytes after the last triangle");
}

/// Many binary files begin with "solid" too. They have the size that their count implies, or a zero byte in
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
  bytes.resize(stl_header_bytes, '\0');
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

bool may_be_stl(std::string_view bytes) {
  if (is_text(bytes)) return true;
  // A byte that no text has makes it binary, cut off or not.
  return bytes.substr(0, preamble_bytes).find('\0') != std::string_view::npos;
}

MeshFile read_stl(std::string_view bytes, const ReadOptions& options, std::size_t& line) {
  MeshFile file;
  file.single_precision = true;
  MeshBuilder builder(file, options);
  if (is_text(bytes)) {
    file.report.format = "STL, ASCII";
    TextStl(bytes, line, builder).read();
  } else {
    file.report.format = "STL, binary";
    read_binary(bytes, builder);
  }
  return file;
}

std::string stl_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, WriteReport& report) {
  choose(attributes, {}, report);
  note_rounding(mesh, report);
  return options.ascii ? text_stl(mesh) : binary_stl(mesh);
}

}  // namespace whittle::files
