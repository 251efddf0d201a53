/// \file
/// Stanford PLY: any elements and properties in any order, as text or binary of either byte order.
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "files/Fault.hh"
#include "files/TextReader.hh"
#include "files/TextWriter.hh"
#include "files/build.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/ply_body.hh"
#include "files/ply_header.hh"

namespace whittle::files {
namespace {

constexpr std::size_t unread = static_cast<std::size_t>(-1);

struct Grouped {
  std::string_view name;
  const char* group;
};

/// Properties that belong together are noted as one attribute.
constexpr Grouped grouped_properties[] = {
    {"nx", "normals"},
    {"ny", "normals"},
    {"nz", "normals"},
    {"red", "colours"},
    {"green", "colours"},
    {"blue", "colours"},
    {"alpha", "colours"},
    {"r", "colours"},
    {"g", "colours"},
    {"b", "colours"},
    {"a", "colours"},
    {"s", "texture coordinates"},
    {"t", "texture coordinates"},
    {"u", "texture coordinates"},
    {"v", "texture coordinates"},
    {"texture_u", "texture coordinates"},
    {"texture_v", "texture coordinates"},
    {"texcoord", "texture coordinates"},
};

/// \param element  "vertex" or "face"
std::string attribute_name(const std::string& element, const std::string& property) {
  for (const Grouped& known : grouped_properties) {
    if (known.name != property) continue;
    if (std::string_view(known.group) == "texture coordinates") return known.group;
    return element + " " + known.group;
  }
  return element + " property " + in_quotes(property);
}

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads the body. Values is PlyText or PlyBytes.
template <typename Values>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, Values& values, MeshFile& file)
      : header_(header), values_(values), file_(file) {}

  void read() {
    const PlyElement* vertex = header_.find("vertex");
    if (vertex == nullptr) throw Fault("the header has no element vertex");
    vertices_ = vertex->count;
    for (const PlyElement& element : header_.elements) {
      check_fits(element);
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        skip_element(element);
    }
  }

 private:
  void check_fits(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += Values::least_bytes(property.is_list ? property.length_type : property.type);
    if (least > 0)
      check_declared(element.count, "of element " + in_quotes(element.name), least, values_.remaining());
  }

  void read_vertices(const PlyElement& element) {
    const std::vector<std::size_t> axes = axes_of(element);
    file_.mesh.points.reserve(element.count);
    std::array<double, 3> point{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      for (std::size_t k = 0; k < axes.size(); ++k) {
        if (axes[k] == unread)
          skip(element.properties[k]);
        else
          point[axes[k]] = values_.real(element.properties[k].type);
      }
      add_point(file_, point[0], point[1], point[2]);
      values_.end_line();
    }
  }

  /// For each property the coordinate it holds: 0, 1, 2, or `unread`.
  std::vector<std::size_t> axes_of(const PlyElement& element) {
    std::vector<std::size_t> axes;
    std::size_t found = 0;
    file_.single_precision = true;
    for (const PlyProperty& property : element.properties) {
      const std::size_t axis = std::string_view("xyz").find(property.name);
      if (property.is_list || property.name.size() != 1 || axis == std::string_view::npos) {
        axes.push_back(unread);
        ignore(file_, attribute_name("vertex", property.name));
        continue;
      }
      axes.push_back(axis);
      ++found;
      file_.single_precision = file_.single_precision && property.type == PlyType::float32;
    }
    if (found != 3) throw Fault("the vertices lack x, y or z");
    return axes;
  }

  void read_faces(const PlyElement& element) {
    if (element.count == 0) return;
    const PlyProperty* corner_list = nullptr;
    for (const PlyProperty& property : element.properties) {
      if (is_corner_list(property) && corner_list == nullptr)
        corner_list = &property;
      else
        ignore(file_, attribute_name("face", property.name));
    }
    if (corner_list == nullptr) throw Fault("the faces have no list vertex_indices");
    if (!ply_is_integer(corner_list->type)) throw Fault("the vertex indices are not integers");

    file_.mesh.triangles.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      for (const PlyProperty& property : element.properties) {
        if (&property == corner_list)
          read_corners(property);
        else
          skip(property);
      }
      values_.end_line();
    }
  }

  void read_corners(const PlyProperty& list) {
    corners_.clear();
    const std::uint64_t length = list_length(list);
    for (std::uint64_t i = 0; i < length; ++i)
      corners_.push_back(checked_index(values_.integer(list.type), vertices_));
    add_face(file_, corners_);
  }

  void skip_element(const PlyElement& element) {
    // Without properties there is nothing in the body, however many are declared.
    if (element.count == 0 || element.properties.empty()) return;
    ignore(file_, "element " + in_quotes(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      for (const PlyProperty& property : element.properties) skip(property);
      values_.end_line();
    }
  }

  void skip(const PlyProperty& property) {
    values_.skip(property.type, property.is_list ? list_length(property) : 1);
  }

  std::uint64_t list_length(const PlyProperty& list) {
    const std::int64_t length = values_.integer(list.length_type);
    if (length < 0) throw Fault("a list of negative length");
    return static_cast<std::uint64_t>(length);
  }

  const PlyHeader& header_;
  Values& values_;
  MeshFile& file_;
  std::uint64_t vertices_ = 0;
  std::vector<std::uint32_t> corners_;
};

std::string text_body(const IndexedMesh& mesh, bool single_precision) {
  TextWriter out(single_precision);
  for (const IndexedMesh::Point& point : mesh.points) out << point << "\n";
  for (const auto& [a, b, c] : mesh.triangles)
    out << "3 " << std::uint64_t{a} << " " << std::uint64_t{b} << " " << std::uint64_t{c} << "\n";
  return out.take();
}

std::string little_endian_body(const IndexedMesh& mesh, bool single_precision) {
  std::string body;
  body.reserve(mesh.points.size() * 3 * (single_precision ? 4 : 8) + mesh.triangles.size() * 13);
  for (const IndexedMesh::Point& point : mesh.points) {
    for (const double value : point) {
      if (single_precision)
        append_little(body, static_cast<float>(value));
      else
        append_little(body, value);
    }
  }
  for (const IndexedMesh::Triangle& triangle : mesh.triangles) {
    append_little(body, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) append_little(body, corner);
  }
  return body;
}

}  // namespace

bool is_ply(std::string_view bytes) {
  return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 5) == "ply\r\n";
}

MeshFile read_ply(std::string_view bytes, std::size_t& line) {
  MeshFile file;
  TextReader in(bytes, line, {});
  const PlyHeader header = read_ply_header(in);
  if (header.encoding == PlyEncoding::ascii) {
    file.report.format = "PLY, ASCII";
    PlyText values(in);
    BodyReader<PlyText>(header, values, file).read();
    if (in.next_line()) throw Fault("there is more in the file than its header declares");
  } else {
    const bool little = header.encoding == PlyEncoding::little_endian;
    file.report.format = little ? "PLY, binary little endian" : "PLY, binary big endian";
    PlyBytes values(in.rest(), little ? ByteOrder::little : ByteOrder::big);
    line = 0;
    BodyReader<PlyBytes>(header, values, file).read();
    if (values.remaining() > 0) ignore(file, "bytes after the last element");
  }
  return file;
}

std::string ply_bytes(const IndexedMesh& mesh, const WriteOptions& options) {
  const std::string real = options.single_precision ? "float" : "double";
  // Some readers know no uint, so int as long as it can name every vertex.
  const bool fits_int = mesh.points.size() <= std::size_t{std::numeric_limits<std::int32_t>::max()};
  std::string bytes = "ply\nformat ";
  bytes += options.ascii ? "ascii" : "binary_little_endian";
  bytes += " 1.0\nelement vertex " + std::to_string(mesh.points.size());
  for (const char* axis : {"x", "y", "z"}) bytes += "\nproperty " + real + " " + axis;
  bytes += "\nelement face " + std::to_string(mesh.triangles.size());
  bytes +=
      std::string("\nproperty list uchar ") + (fits_int ? "int" : "uint") + " vertex_indices\nend_header\n";
  return bytes + (options.ascii ? text_body : little_endian_body)(mesh, options.single_precision);
}

}  // namespace whittle::files
