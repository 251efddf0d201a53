/// \file
/// Geomview's OFF, as text.
#include <cstdint>
#include <vector>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/TextWriter.hh"
#include "files/build.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

constexpr TextReader::Syntax off_syntax{'#', false};

/// What the first word says: `[ST][C][N][4][n]OFF`, and behind it the first count where a file lacks the
/// blank.
struct Keyword {
  bool valid = false;
  bool texture = false;
  bool colours = false;
  bool normals = false;
  bool other_dimension = false;  ///< four coordinates, or a count of coordinates in the header
  std::string_view glued_count;
};

bool take(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

Keyword parse_keyword(std::string_view word) {
  Keyword keyword;
  keyword.texture = take(word, "ST");
  keyword.colours = take(word, "C");
  keyword.normals = take(word, "N");
  const bool four = take(word, "4");
  keyword.other_dimension = take(word, "n") || four;
  keyword.valid = take(word, "OFF") && word.find_first_not_of("0123456789") == std::string_view::npos;
  keyword.glued_count = word;
  return keyword;
}

class OffReader {
 public:
  OffReader(std::string_view bytes, std::size_t& line) : in_(bytes, line, off_syntax) {}

  MeshFile read() {
    file_.report.format = "OFF";
    const Keyword keyword = parse_keyword(in_.word_anywhere());
    if (!keyword.valid) throw Fault("not an OFF file: the first word is not OFF");
    if (keyword.other_dimension) throw Fault("OFF with other than three coordinates is not supported");
    read_counts(keyword.glued_count);
    if (keyword.normals) ignore(file_, "vertex normals");
    if (keyword.colours) ignore(file_, "vertex colours");
    if (keyword.texture) ignore(file_, "texture coordinates");
    const bool attributes_named = !file_.report.ignored.empty();
    for (std::uint64_t i = 0; i < vertices_; ++i) read_vertex(attributes_named);
    for (std::uint64_t i = 0; i < faces_; ++i) read_face();
    if (in_.next_line()) throw Fault("there is more in the file than its counts say");
    return std::move(file_);
  }

 private:
  /// Vertices, faces and edges. The edges are not needed, and some files leave them out.
  void read_counts(std::string_view glued) {
    std::string_view first = glued.empty() ? in_.word() : glued;
    if (first == "BINARY") throw Fault("binary OFF is not supported");
    if (first.empty()) {
      next_line();
      first = in_.word();
    }
    vertices_ = parse_count(first);
    faces_ = in_.count();
    if (const std::string_view edges = in_.word(); !edges.empty()) parse_count(edges);
    end_line();
    check_declared(vertices_, "vertices", 6, in_.remaining());  // "0 0 0" and a line end
    check_declared(faces_, "faces", 8, in_.remaining());        // "3 0 1 2" and a line end
    file_.mesh.points.reserve(vertices_);
    file_.mesh.triangles.reserve(faces_);
  }

  void read_vertex(bool attributes_named) {
    next_line();
    const double x = in_.real<double>();
    const double y = in_.real<double>();
    const double z = in_.real<double>();
    add_point(file_, x, y, z);
    if (!attributes_named && !in_.word().empty()) ignore(file_, "vertex attributes");
  }

  void read_face() {
    next_line();
    corners_.clear();
    const std::uint64_t corners = in_.count();
    for (std::uint64_t i = 0; i < corners; ++i) corners_.push_back(checked_index(in_.integer(), vertices_));
    add_face(file_, corners_);
    if (!in_.word().empty()) ignore(file_, "face colours");
  }

  void next_line() {
    if (!in_.next_line()) throw Fault("the file is cut off");
  }

  void end_line() {
    if (const std::string_view word = in_.word(); !word.empty()) throw Fault("unexpected " + in_quotes(word));
  }

  TextReader in_;
  MeshFile file_;
  std::vector<std::uint32_t> corners_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
};

}  // namespace

bool is_off(std::string_view bytes) {
  std::size_t line = 0;
  return parse_keyword(TextReader(bytes, line, off_syntax).word_anywhere()).valid;
}

MeshFile read_off(std::string_view bytes, std::size_t& line) {
  return OffReader(bytes, line).read();
}

std::string off_bytes(const IndexedMesh& mesh, const WriteOptions& options) {
  TextWriter out(options.single_precision);
  out << "OFF\n" << mesh.points.size() << " " << mesh.triangles.size() << " 0\n";
  for (const IndexedMesh::Point& point : mesh.points) out << point << "\n";
  for (const auto& [a, b, c] : mesh.triangles)
    out << "3 " << std::uint64_t{a} << " " << std::uint64_t{b} << " " << std::uint64_t{c} << "\n";
  return out.take();
}

}  // namespace whittle::files
