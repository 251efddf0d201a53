/// \file
/// Geomview's OFF, as text: reading.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/TextReader.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

constexpr TextReader::Syntax off_syntax{'#', false};

/// What the first word means: `[ST][C][N][4][n]OFF`, and behind it the first count where a file lacks the
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

Attribute vertex_attribute(Kind kind, std::size_t components) {
  Attribute attribute;
  attribute.kind = kind;
  attribute.components = components;
  return attribute;
}

class OffReader {
 public:
  OffReader(std::string_view bytes, const ReadOptions& options, std::size_t& line)
      : in_(bytes, line, off_syntax), builder_(file_, options) {}

  MeshFile read() {
    file_.report.format = "OFF";
    keyword_ = parse_keyword(in_.word_anywhere());
    if (!keyword_.valid) throw Fault("not an OFF file: the first word is not OFF");
    if (keyword_.other_dimension) throw Fault("OFF with other than three coordinates is not supported");
    read_counts();
    for (std::uint64_t i = 0; i < vertices_; ++i) read_vertex();
    for (std::uint64_t i = 0; i < faces_; ++i) read_face();
    if (in_.next_line()) throw Fault("there is more in the file than its counts say");
    finish_colours();
    for (Attribute* attribute : {&normals_, &colours_, &texture_})
      if (!attribute->values.empty()) file_.attributes.push_back(std::move(*attribute));
    return std::move(file_);
  }

 private:
  /// Vertices, faces and edges. The edges are not needed, and some files leave them out.
  void read_counts() {
    std::string_view first = keyword_.glued_count.empty() ? in_.word() : keyword_.glued_count;
    if (first == "BINARY") throw Fault("binary OFF is not supported");
    if (first.empty()) {
      next_line();
      first = in_.word();
    }
    vertices_ = parse_count(first);
    faces_ = in_.count();
    if (const std::string_view edges = in_.word(); !edges.empty()) parse_count(edges);
    if (const std::string_view word = in_.word(); !word.empty()) throw Fault("unexpected " + in_quotes(word));
    check_declared(vertices_, "vertices", 6, in_.remaining());  // "0 0 0" and a line end
    check_declared(faces_, "faces", 8, in_.remaining());        // "3 0 1 2" and a line end
    file_.mesh.points.reserve(vertices_);
    file_.mesh.triangles.reserve(faces_);
  }

  /// Coordinates, then normal, colour and texture coordinates as far as the header names them.
  void read_vertex() {
    next_line();
    const double x = in_.real<double>();
    const double y = in_.real<double>();
    const double z = in_.real<double>();
    builder_.add_point(x, y, z);
    if (keyword_.normals)
      for (int i = 0; i < 3; ++i) normals_.values.push_back(builder_.component(in_.real<float>()));
    if (keyword_.colours) {
      read_colour();
    } else {
      if (keyword_.texture) read_texture();
      if (!in_.word().empty()) builder_.ignore("vertex attributes");
    }
  }

  void read_texture() {
    for (int i = 0; i < 2; ++i) texture_.values.push_back(builder_.component(in_.real<float>()));
  }

  /// Only the length of the line tells whether a colour has three numbers or four.
  void read_colour() {
    constexpr std::size_t most_words = 8;
    std::string_view words[most_words];
    std::size_t count = 0;
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word(), ++count)
      if (count < most_words) words[count] = word;
    const std::size_t components = count - std::min<std::size_t>(count, keyword_.texture ? 2 : 0);
    if (colours_.values.empty()) colours_.components = components == 4 ? 4 : 3;
    if (components != colours_.components)
      throw Fault("a colour has " + std::to_string(components) + " numbers instead of " +
                  (colours_.values.empty() ? "3 or 4" : std::to_string(colours_.components)));
    for (std::size_t i = 0; i < components; ++i) {
      const float value = builder_.component(parse_real<float>(words[i]));
      any_point_ = any_point_ || words[i].find_first_of(".eE") != std::string_view::npos;
      largest_ = std::max(largest_, value);
      colours_.values.push_back(value);
    }
    for (std::size_t i = components; i < count; ++i)
      texture_.values.push_back(builder_.component(parse_real<float>(words[i])));
  }

  /// Whole numbers are 0..255, unless nothing is larger than 1 and something is: then they are 0..1 after
  /// all.
  void finish_colours() {
    if (any_point_ || largest_ == 1.0F) return;
    colours_.bytes = true;
    for (float& value : colours_.values)
      value = from_byte(static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F)));
  }

  void read_face() {
    next_line();
    corners_.clear();
    const std::uint64_t corners = in_.count();
    for (std::uint64_t i = 0; i < corners; ++i) corners_.push_back(builder_.index(in_.integer(), vertices_));
    builder_.add_face(corners_);
    if (!in_.word().empty()) builder_.ignore("face colours");
  }

  void next_line() {
    if (!in_.next_line()) throw Fault("the file is cut off");
  }

  TextReader in_;
  MeshFile file_;
  MeshBuilder builder_;
  Keyword keyword_;
  Attribute normals_ = vertex_attribute(Kind::normal, 3);
  Attribute colours_ = vertex_attribute(Kind::colour, 3);
  Attribute texture_ = vertex_attribute(Kind::texture, 2);
  bool any_point_ = false;  ///< a colour was written with a decimal point
  float largest_ = 0;       ///< number in a colour
  std::vector<std::uint32_t> corners_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
};

}  // namespace

bool is_off(std::string_view bytes) {
  std::size_t line = 0;
  return parse_keyword(TextReader(bytes, line, off_syntax).word_anywhere()).valid;
}

MeshFile read_off(std::string_view bytes, const ReadOptions& options, std::size_t& line) {
  return OffReader(bytes, options, line).read();
}

}  // namespace whittle::files
