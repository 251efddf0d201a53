/// \file
/// Wavefront OBJ: positions and faces.
#include <cstdint>
#include <vector>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/TextWriter.hh"
#include "files/build.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

struct Unread {
  std::string_view keyword;
  const char* attribute;
};

/// The statements of the format that say nothing about the triangles.
constexpr Unread unread_statements[] = {
    {"vn", "vertex normals"},
    {"vt", "texture coordinates"},
    {"usemtl", "materials"},
    {"mtllib", "materials"},
    {"usemap", "materials"},
    {"maplib", "materials"},
    {"g", "groups"},
    {"o", "groups"},
    {"s", "groups"},
    {"mg", "groups"},
    {"l", "lines"},
    {"p", "points"},
    {"vp", "free-form geometry"},
    {"deg", "free-form geometry"},
    {"bmat", "free-form geometry"},
    {"step", "free-form geometry"},
    {"cstype", "free-form geometry"},
    {"curv", "free-form geometry"},
    {"curv2", "free-form geometry"},
    {"surf", "free-form geometry"},
    {"parm", "free-form geometry"},
    {"trim", "free-form geometry"},
    {"hole", "free-form geometry"},
    {"scrv", "free-form geometry"},
    {"sp", "free-form geometry"},
    {"con", "free-form geometry"},
    {"end", "free-form geometry"},
    {"ctech", "free-form geometry"},
    {"stech", "free-form geometry"},
    {"bevel", "display settings"},
    {"c_interp", "display settings"},
    {"d_interp", "display settings"},
    {"lod", "display settings"},
    {"shadow_obj", "display settings"},
    {"trace_obj", "display settings"},
};

const char* unread_attribute(std::string_view keyword) {
  for (const Unread& statement : unread_statements)
    if (statement.keyword == keyword) return statement.attribute;
  throw Fault("unknown statement " + in_quotes(keyword));
}

class ObjReader {
 public:
  ObjReader(std::string_view bytes, std::size_t& line) : in_(bytes, line, {'#', true}), line_(line) {}

  MeshFile read() {
    file_.report.format = "OBJ";
    while (in_.next_line()) {
      const std::string_view keyword = in_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_face();
      else
        ignore(file_, unread_attribute(keyword));
    }
    check_forward_reference();
    return std::move(file_);
  }

 private:
  void read_vertex() {
    const double x = in_.real<double>();
    const double y = in_.real<double>();
    const double z = in_.real<double>();
    add_point(file_, x, y, z);
    int extra = 0;
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word(), ++extra)
      parse_real<double>(word);
    if (extra == 1)
      ignore(file_, "vertex weights");
    else if (extra == 3 || extra == 4)
      ignore(file_, "vertex colours");
    else if (extra != 0)
      throw Fault("a vertex has " + std::to_string(3 + extra) + " numbers");
  }

  void read_face() {
    corners_.clear();
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word())
      corners_.push_back(corner(word));
    add_face(file_, corners_);
  }

  /// A corner is `v`, `v/t`, `v//n` or `v/t/n`.
  std::uint32_t corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (slash != std::string_view::npos) check_attributes(word.substr(slash + 1));
    const std::int64_t index = parse_integer(word.substr(0, slash));
    const auto vertices = static_cast<std::int64_t>(file_.mesh.points.size());
    if (index == 0) throw Fault("vertex index 0: OBJ counts from 1");
    if (index < -vertices) throw_index_out_of_range(index, file_.mesh.points.size());
    if (index < 0) return static_cast<std::uint32_t>(vertices + index);
    if (index > vertices && index > furthest_) {
      furthest_ = index;
      furthest_line_ = line_;
    }
    return static_cast<std::uint32_t>(index - 1);
  }

  static void check_attributes(std::string_view texture_and_normal) {
    const std::size_t slash = texture_and_normal.find('/');
    const std::string_view texture = texture_and_normal.substr(0, slash);
    if (!texture.empty()) parse_integer(texture);
    if (slash != std::string_view::npos) parse_integer(texture_and_normal.substr(slash + 1));
  }

  /// A face may name vertices that come later in the file, so what is out of range shows at the end only.
  void check_forward_reference() {
    const std::size_t vertices = file_.mesh.points.size();
    if (furthest_ <= static_cast<std::int64_t>(vertices)) return;
    line_ = furthest_line_;
    throw_index_out_of_range(furthest_, vertices);
  }

  TextReader in_;
  std::size_t& line_;
  MeshFile file_;
  std::vector<std::uint32_t> corners_;
  std::int64_t furthest_ = 0;  ///< the largest index of a vertex that was not there yet
  std::size_t furthest_line_ = 0;
};

}  // namespace

MeshFile read_obj(std::string_view bytes, std::size_t& line) {
  return ObjReader(bytes, line).read();
}

std::string obj_bytes(const IndexedMesh& mesh, const WriteOptions& options) {
  TextWriter out(options.single_precision);
  for (const IndexedMesh::Point& point : mesh.points) out << "v " << point << "\n";
  for (const auto& [a, b, c] : mesh.triangles)
    out << "f " << std::uint64_t{a} + 1 << " " << std::uint64_t{b} + 1 << " " << std::uint64_t{c} + 1 << "\n";
  return out.take();
}

}  // namespace whittle::files
