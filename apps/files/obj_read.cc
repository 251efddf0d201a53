/// \file
/// Wavefront OBJ: reading.
#include <cstdint>
#include <vector>

#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/ObjColours.hh"
#include "files/ObjIndices.hh"
#include "files/ObjParts.hh"
#include "files/ObjPieces.hh"
#include "files/TextReader.hh"
#include "files/formats.hh"
#include "files/obj_statements.hh"
#include "files/settle.hh"
#include "files/subset.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

constexpr TextReader::Syntax obj_syntax{'#', true};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const ReadOptions& options, std::size_t& line)
      : bytes_(bytes),
        in_(bytes, line, obj_syntax),
        line_(line),
        builder_(file_, options),
        fixes_(options.repair == Repair::fix) {}

  MeshFile read() {
    file_.report.format = "OBJ";
    const bool in_pieces = read_pieces();
    if (!in_pieces) read_lines();
    add_colours();
    add_at_corners(texture_, texture_of_, texture_indices_);
    add_at_corners(normals_, normal_of_, normal_indices_);
    file_.parts = parts_.take_parts();
    if (!in_pieces) {
      drop_faces_without_vertices(file_);
      drop_degenerate_faces(file_);
    }
    settle(file_);
    return std::move(file_);
  }

 private:
  /// On several threads, if the file is as most are.
  bool read_pieces() {
    ObjLists lists;
    if (!read_obj_in_pieces(bytes_, lists)) return false;
    file_.mesh.points = std::move(lists.points);
    file_.mesh.triangles = std::move(lists.triangles);
    file_.report.dropped_degenerate = lists.faces - file_.mesh.triangles.size();
    texture_.values = std::move(lists.texture);
    normals_.values = std::move(lists.normals);
    texture_of_.triangles = std::move(lists.texture_of);
    normal_of_.triangles = std::move(lists.normal_of);
    std::size_t faces = 0;
    for (const ObjLists::Statement& statement : lists.statements) {
      if (statement.faces > faces) parts_.add_faces(statement.triangles);
      faces = statement.faces;
      parts_.take(statement.keyword, [&] { return statement.rest; });
    }
    if (lists.faces > faces && !lists.statements.empty()) parts_.add_faces(file_.mesh.triangles.size());
    return true;
  }

  void read_lines() {
    while (in_.next_line()) {
      const std::string_view keyword = in_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      else if (keyword == "vt")
        read_texture();
      else if (keyword == "vn")
        read_normal();
      else if (!parts_.take(keyword, [&] { return in_.rest_of_line(); }))
        builder_.ignore(unread_statement(keyword));
    }
    if (!fixes_) vertex_indices_.check(file_.mesh.points.size(), line_);
    builder_.cut_late({&texture_of_, &normal_of_});
  }

  void read_vertex() {
    const double x = in_.real<double>();
    const double y = in_.real<double>();
    const double z = in_.real<double>();
    builder_.add_point(x, y, z);
    float extra[5] = {1, 1, 1, 1, 1};
    std::size_t count = 0;
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word(), ++count) {
      if (count == 5) throw Fault("a vertex has more than 8 numbers");
      extra[count] = builder_.component(parse_real<float>(word));
    }
    if (count == 2) throw Fault("a vertex has 5 numbers");
    if (count == 1 || count == 5) builder_.ignore("vertex weights");
    if (count >= 3) colours_.add(extra, count, file_.mesh.points.size() - 1);
  }

  void read_texture() {
    const float u = builder_.component(in_.real<float>());
    float v = 0;
    if (const std::string_view word = in_.word(); !word.empty())
      v = builder_.component(parse_real<float>(word));
    if (const std::string_view word = in_.word(); !word.empty()) {
      if (parse_real<float>(word) != 0) builder_.ignore("depths of texture coordinates");
    }
    texture_.values.insert(texture_.values.end(), {u, v});
  }

  void read_normal() {
    for (int i = 0; i < 3; ++i) normals_.values.push_back(builder_.component(in_.real<float>()));
  }

  void read_face() {
    corners_.clear();
    texture_of_.face.clear();
    normal_of_.face.clear();
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word()) read_corner(word);
    for (CornerValues* values : {&texture_of_, &normal_of_})
      if (!values->face.empty()) values->face.resize(corners_.size(), no_value);
    builder_.add_face(corners_, {&texture_of_, &normal_of_});
    parts_.add_faces(file_.mesh.triangles.size());
  }

  /// A corner is `v`, `v/t`, `v//n` or `v/t/n`; some programs leave the slashes of what is not there.
  void read_corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    const std::int64_t index = parse_integer(word.substr(0, slash));
    corners_.push_back(vertex_indices_.resolve(index, file_.mesh.points.size(), line_));
    if (slash == std::string_view::npos) return;
    word.remove_prefix(slash + 1);
    const std::size_t second = word.find('/');
    if (const std::string_view texture = word.substr(0, second); !texture.empty())
      set_value(texture_of_, texture_indices_, texture, texture_.n_values());
    if (second == std::string_view::npos) return;
    if (const std::string_view normal = word.substr(second + 1); !normal.empty())
      set_value(normal_of_, normal_indices_, normal, normals_.n_values());
  }

  /// \param count  values of the list so far
  void set_value(CornerValues& values, ObjIndices& indices, std::string_view word, std::size_t count) {
    values.face.resize(corners_.size() - 1, no_value);  // corners before this one may have had none
    values.face.push_back(indices.resolve(parse_integer(word), count, line_));
  }

  void add_colours() {
    if (colours_.empty()) return;
    if (colours_.have_weights()) builder_.ignore("vertex weights");
    file_.attributes.push_back(colours_.take(file_.mesh.points.size(), file_.report.missing_values));
  }

  void add_at_corners(Attribute& attribute, CornerValues& corners, const ObjIndices& indices) {
    if (attribute.values.empty()) {
      if (!corners.triangles.empty())
        builder_.ignore("indices of " + to_string(attribute) + " that are not there");
      return;
    }
    if (!fixes_) indices.check(attribute.n_values(), line_);
    for (IndexedMesh::Triangle& triangle : corners.triangles)
      for (std::uint32_t& corner : triangle)
        if (corner >= attribute.n_values()) corner = no_value;
    // Clouds of points come with a normal behind each point.
    const bool cloud = file_.mesh.triangles.empty() && attribute.n_values() == file_.mesh.points.size();
    if (cloud)
      file_.attributes.push_back(std::move(attribute));
    else if (corners.triangles.empty())
      builder_.ignore(to_string(attribute) + " that no face uses");
    else
      builder_.add_attribute(std::move(attribute), corners);
  }

  static Attribute empty_attribute(Kind kind, std::size_t components) {
    Attribute attribute;
    attribute.kind = kind;
    attribute.components = components;
    return attribute;
  }

  std::string_view bytes_;
  TextReader in_;
  std::size_t& line_;
  MeshFile file_;
  MeshBuilder builder_;
  bool fixes_;
  ObjIndices vertex_indices_{"vertex"}, texture_indices_{"texture coordinate"}, normal_indices_{"normal"};
  Attribute texture_ = empty_attribute(Kind::texture, 2);
  Attribute normals_ = empty_attribute(Kind::normal, 3);
  CornerValues texture_of_, normal_of_;
  ObjParts parts_;
  ObjColours colours_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

bool may_be_obj(std::string_view bytes) {
  std::size_t line = 0;
  TextReader in(bytes, line, obj_syntax);
  return in.next_line() && is_obj_keyword(in.word());
}

MeshFile read_obj(std::string_view bytes, const ReadOptions& options, std::size_t& line) {
  return ObjReader(bytes, options, line).read();
}

}  // namespace whittle::files
