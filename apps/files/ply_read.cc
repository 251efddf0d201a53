/// \file
/// Stanford PLY: any elements and properties in any order, as text or binary of either byte order.
#include <cstdint>
#include <optional>
#include <vector>

#include "files/Fault.hh"
#include "files/MeshBuilder.hh"
#include "files/PlyColumns.hh"
#include "files/PlyFaceColours.hh"
#include "files/TextReader.hh"
#include "files/bytes.hh"
#include "files/formats.hh"
#include "files/ply_body.hh"
#include "files/ply_header.hh"
#include "files/ply_strips.hh"
#include "files/settle.hh"
#include "files/subset.hh"

namespace whittle::files {
namespace {

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Two numbers for each corner, as MeshLab writes them.
bool is_texture_list(const PlyProperty& property) {
  return property.is_list && property.name == "texcoord";
}

/// \param property  of a face
std::string unread_name(const std::string& property) {
  if (property == "red" || property == "green" || property == "blue" || property == "alpha")
    return "face colours";
  if (property == "nx" || property == "ny" || property == "nz") return "face normals";
  return "face property " + in_quotes(property);
}

enum class Faces { none, strips, fans, grid };

/// The elements that are faces in another form.
Faces faces_of(const std::string& element) {
  if (element == "tristrips" || element == "tristrip") return Faces::strips;
  if (element == "trifans" || element == "trifan") return Faces::fans;
  return element == "range_grid" ? Faces::grid : Faces::none;
}

/// Reads the body. Values is PlyText or PlyBytes.
template <typename Values>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, Values& values, MeshFile& file, const ReadOptions& options)
      : header_(header), values_(values), file_(file), builder_(file, options) {
    texture_.kind = attributes::Kind::texture;
    texture_.components = 2;
  }

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
      else if (faces_of(element.name) != Faces::none)
        read_lists(element, faces_of(element.name));
      else
        skip_element(element);
    }
    finish_faces();
    if (header_.texture_file) builder_.ignore("texture image");
    settle(file_);
  }

  void ignore(const char* what) { builder_.ignore(what); }

 private:
  void check_fits(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += Values::least_bytes(property.is_list ? property.length_type : property.type);
    if (least > 0)
      check_declared(element.count, "of element " + in_quotes(element.name), least, values_.remaining());
  }

  bool has_texture_at_corners() const {
    const PlyElement* face = header_.find("face");
    if (face == nullptr || face->count == 0) return false;
    for (const PlyProperty& property : face->properties)
      if (is_texture_list(property)) return true;
    return false;
  }

  void read_vertices(const PlyElement& element) {
    PlyColumns columns(element, has_texture_at_corners(), builder_);
    file_.single_precision = columns.single_precision();
    file_.mesh.points.reserve(element.count);
    columns.resize(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        if (columns.is_read(k))
          columns.set(i, k, values_.real(element.properties[k].type));
        else
          skip(element.properties[k]);
      }
      builder_.add_point(columns.point()[0], columns.point()[1], columns.point()[2]);
      end_line();
    }
    file_.attributes = columns.take();
  }

  void read_faces(const PlyElement& element) {
    if (element.count == 0) return;
    colours_.emplace(element, header_.find("vertex"), builder_);
    const PlyProperty* corner_list = nullptr;
    const PlyProperty* texture_list = nullptr;
    for (const PlyProperty& property : element.properties) {
      if (is_corner_list(property) && corner_list == nullptr)
        corner_list = &property;
      else if (is_texture_list(property))
        texture_list = &property;
      else if (!colours_->has(static_cast<std::size_t>(&property - element.properties.data())))
        builder_.ignore(unread_name(property.name));
    }
    if (corner_list == nullptr) throw Fault("the faces have no list vertex_indices");
    if (!ply_is_integer(corner_list->type)) throw Fault("the vertex indices are not integers");

    file_.mesh.triangles.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      texture_numbers_.clear();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (&property == corner_list)
          read_corners(property);
        else if (&property == texture_list)
          read_texture(property);
        else if (colours_->takes(k))
          colours_->set(k, property.type, values_.real(property.type));
        else
          skip(property);
      }
      end_line();
      add_face();
    }
  }

  /// Faces as lists of another kind than their corners.
  void read_lists(const PlyElement& element, Faces kind) {
    const PlyProperty* list = nullptr;
    for (const PlyProperty& property : element.properties)
      if (is_corner_list(property) && list == nullptr) list = &property;
    if (list == nullptr || !ply_is_integer(list->type)) return skip_element(element);
    if (kind == Faces::grid) grid_.emplace(header_.grid_columns, header_.grid_rows, element.count);
    std::vector<std::int64_t> indices;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      indices.clear();
      for (const PlyProperty& property : element.properties) {
        if (&property != list) {
          skip(property);
          continue;
        }
        const std::uint64_t length = list_length(property);
        for (std::uint64_t k = 0; k < length; ++k) indices.push_back(values_.integer(list->type));
      }
      end_line();
      if (grid_ && kind == Faces::grid && indices.size() > 1)
        throw Fault("a cell of the range_grid with more than one vertex");
      if (grid_ && kind == Faces::grid)
        grid_->add_cell(indices.empty() ? no_vertex : builder_.index(indices[0], vertices_));
      else
        add_ply_strip(indices, kind == Faces::fans, vertices_, builder_);
    }
  }

  /// To be called when all is read.
  void finish_faces() {
    if (grid_) grid_->add_faces(builder_);
    if (!colours_) return;  // there is no face
    builder_.cut_late({&texture_of_, &colours_->all()});
    builder_.add_attribute(std::move(texture_), texture_of_);
    builder_.add_attribute(colours_->take(), colours_->all());
    drop_degenerate_faces(file_);
  }

  void read_corners(const PlyProperty& list) {
    corners_.clear();
    const std::uint64_t length = list_length(list);
    for (std::uint64_t i = 0; i < length; ++i)
      corners_.push_back(builder_.index(values_.integer(list.type), vertices_));
  }

  void read_texture(const PlyProperty& list) {
    const std::uint64_t length = list_length(list);
    for (std::uint64_t i = 0; i < length; ++i)
      texture_numbers_.push_back(builder_.component(values_.real(list.type)));
  }

  /// Faces without texture coordinates may stand among others that have some.
  void add_face() {
    texture_of_.face.clear();
    if (!texture_numbers_.empty()) {
      if (texture_numbers_.size() != 2 * corners_.size())
        throw Fault("a face of " + std::to_string(corners_.size()) + " corners has " +
                    std::to_string(texture_numbers_.size()) + " numbers of texture coordinates");
      for (std::size_t i = 0; i < corners_.size(); ++i)
        texture_of_.face.push_back(static_cast<std::uint32_t>(texture_.n_values() + i));
      texture_.values.insert(texture_.values.end(), texture_numbers_.begin(), texture_numbers_.end());
    }
    builder_.add_face(corners_, {&texture_of_, &colours_->at_corners(corners_.size())});
  }

  void skip_element(const PlyElement& element) {
    // Without properties there is nothing in the body, however many are declared.
    if (element.count == 0 || element.properties.empty()) return;
    builder_.ignore("element " + in_quotes(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.begin_line();
      for (const PlyProperty& property : element.properties) skip(property);
      end_line();
    }
  }

  void skip(const PlyProperty& property) {
    values_.skip(property.type, property.is_list ? list_length(property) : 1);
  }

  void end_line() {
    if (values_.end_line()) ++file_.report.overlong_lines;
  }

  std::uint64_t list_length(const PlyProperty& list) {
    const std::int64_t length = values_.integer(list.length_type);
    if (length < 0) throw Fault("a list of negative length");
    return static_cast<std::uint64_t>(length);
  }

  const PlyHeader& header_;
  Values& values_;
  MeshFile& file_;
  MeshBuilder builder_;
  attributes::Attribute texture_;
  CornerValues texture_of_;
  std::optional<PlyFaceColours> colours_;
  std::optional<PlyGrid> grid_;
  std::uint64_t vertices_ = 0;
  std::vector<std::uint32_t> corners_;
  std::vector<float> texture_numbers_;  ///< of the face at hand
};

}  // namespace

bool is_ply(std::string_view bytes) {
  return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 5) == "ply\r\n";
}

MeshFile read_ply(std::string_view bytes, const ReadOptions& options, std::size_t& line) {
  MeshFile file;
  TextReader in(bytes, line, {});
  const PlyHeader header = read_ply_header(in);
  if (header.encoding == PlyEncoding::ascii) {
    file.report.format = "PLY, ASCII";
    PlyText values(in);
    BodyReader<PlyText>(header, values, file, options).read();
    if (in.next_line()) throw Fault("there is more in the file than its header declares");
  } else {
    const bool little = header.encoding == PlyEncoding::little_endian;
    file.report.format = little ? "PLY, binary little endian" : "PLY, binary big endian";
    PlyBytes values(in.rest(), little ? ByteOrder::little : ByteOrder::big);
    line = 0;
    BodyReader<PlyBytes> reader(header, values, file, options);
    reader.read();
    if (values.remaining() > 0) reader.ignore("bytes after the last element");
  }
  return file;
}

}  // namespace whittle::files
