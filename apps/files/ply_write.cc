/// \file
/// Stanford PLY: writing, as text or binary little endian.
#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <vector>

#include "files/Choice.hh"
#include "files/PlyTextures.hh"
#include "files/TextWriter.hh"
#include "files/bytes.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;

/// The properties of a vertex, besides its place, in the order of their values.
class VertexHeader {
 public:
  void add(const std::string& name, const char* type) {
    names_.push_back(name);
    text_ += std::string("\nproperty ") + type + " " + name;
  }

  /// Keeps a name from those who come later.
  void reserve(const std::string& name) { names_.push_back(name); }

  /// A name is one word, and nothing else may have it already.
  bool can_add(const std::string& name) const {
    const bool one_word = !name.empty() && std::all_of(name.begin(), name.end(),
                                                       [](unsigned char c) { return std::isgraph(c) != 0; });
    return one_word && std::find(names_.begin(), names_.end(), name) == names_.end();
  }

  const std::string& text() const { return text_; }

 private:
  std::vector<std::string> names_ = {"x", "y", "z"};
  std::string text_;
};

VertexHeader describe_vertices(Choice& choice, WriteReport& report) {
  VertexHeader header;
  if (choice.normal)
    for (const char* name : {"nx", "ny", "nz"}) header.add(name, "float");
  if (choice.colour) {
    const char* names[] = {"red", "green", "blue", "alpha"};
    for (std::size_t k = 0; k < choice.colour->components; ++k)
      header.add(names[k], choice.colour->bytes ? "uchar" : "float");
    header.reserve("alpha");  // or it would be taken for the colours' own
  }
  if (choice.texture && choice.texture->per_vertex())
    for (const char* name : {"s", "t"}) header.add(name, "float");
  std::vector<const Attribute*> scalars;
  for (const Attribute* scalar : choice.scalars) {
    if (header.can_add(scalar->name)) {
      header.add(scalar->name, "float");
      scalars.push_back(scalar);
    } else {
      leave_out(report, to_string(*scalar));
    }
  }
  choice.scalars = scalars;
  return header;
}

/// Values as text, one line for each thing.
class TextBody {
 public:
  explicit TextBody(bool single_precision) : out_(single_precision) {}

  void point(const IndexedMesh::Point& point) { out_ << point; }
  void real(float value) { out_ << " " << value; }
  void byte(std::uint8_t value) { out_ << " " << std::uint64_t{value}; }
  void begin_list(std::uint8_t length) { out_ << std::uint64_t{length}; }
  void next_list(std::uint8_t length) { byte(length); }
  void index(std::uint32_t index) { out_ << " " << std::uint64_t{index}; }
  void number(std::int32_t number) { out_ << (" " + std::to_string(number)).c_str(); }
  void end_line() { out_ << "\n"; }
  std::string take() { return out_.take(); }

 private:
  TextWriter out_;
};

/// Values as bytes, little endian.
class ByteBody {
 public:
  explicit ByteBody(bool single_precision) : single_precision_(single_precision) {}

  void point(const IndexedMesh::Point& point) {
    for (const double value : point) {
      if (single_precision_)
        append_little(bytes_, static_cast<float>(value));
      else
        append_little(bytes_, value);
    }
  }
  void real(float value) { append_little(bytes_, value); }
  void byte(std::uint8_t value) { append_little(bytes_, value); }
  void begin_list(std::uint8_t length) { byte(length); }
  void next_list(std::uint8_t length) { byte(length); }
  void index(std::uint32_t index) { append_little(bytes_, index); }
  void number(std::int32_t number) { append_little(bytes_, number); }
  void end_line() {}
  std::string take() { return std::move(bytes_); }

 private:
  bool single_precision_;
  std::string bytes_;
};

template <typename Body>
void write_vertex(Body& body, const Choice& choice, std::size_t vertex) {
  if (choice.normal)
    for (std::size_t k = 0; k < 3; ++k) body.real(choice.normal->value(vertex)[k]);
  if (choice.colour) {
    for (std::size_t k = 0; k < choice.colour->components; ++k) {
      const float value = choice.colour->value(vertex)[k];
      if (choice.colour->bytes)
        body.byte(to_byte(value));
      else
        body.real(value);
    }
  }
  if (choice.texture && choice.texture->per_vertex()) {
    body.real(choice.texture->value(vertex)[0]);
    body.real(v_of(*choice.texture, vertex, false));
  }
  for (const Attribute* scalar : choice.scalars) body.real(*scalar->value(vertex));
}

template <typename Body>
std::string body_of(const IndexedMesh& mesh, const Choice& choice, const PlyImages& images,
                    bool single_precision) {
  Body body(single_precision);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    body.point(mesh.points[i]);
    write_vertex(body, choice, i);
    body.end_line();
  }
  const bool texture_at_corners = choice.texture && !choice.texture->per_vertex();
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    body.begin_list(3);
    for (const std::uint32_t corner : mesh.triangles[face]) body.index(corner);
    if (texture_at_corners) {
      body.next_list(6);
      for (const std::uint32_t value : choice.texture->corners[face]) {
        body.real(choice.texture->value(value)[0]);
        body.real(v_of(*choice.texture, value, false));
      }
    }
    if (!images.of_face.empty()) body.number(images.of_face[face]);
    body.end_line();
  }
  return body.take();
}

}  // namespace

std::string ply_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, const PlyImages& images, WriteReport& report) {
  Choice choice =
      choose(attributes, {Place::vertices, Place::vertices, Place::corners, Place::vertices}, report);
  const std::string real = options.single_precision ? "float" : "double";
  // Some readers know no uint, so int as long as it can name every vertex.
  const bool fits_int = mesh.points.size() <= std::size_t{std::numeric_limits<std::int32_t>::max()};
  std::string bytes = "ply\nformat ";
  bytes += options.ascii ? "ascii" : "binary_little_endian";
  bytes += " 1.0";
  for (const std::string& name : images.names) bytes += "\ncomment TextureFile " + name;
  bytes += "\nelement vertex " + std::to_string(mesh.points.size());
  for (const char* axis : {"x", "y", "z"}) bytes += "\nproperty " + real + " " + axis;
  bytes += describe_vertices(choice, report).text();
  bytes += "\nelement face " + std::to_string(mesh.triangles.size());
  bytes += std::string("\nproperty list uchar ") + (fits_int ? "int" : "uint") + " vertex_indices";
  if (choice.texture && !choice.texture->per_vertex()) bytes += "\nproperty list uchar float texcoord";
  if (!images.of_face.empty()) bytes += "\nproperty int texnumber";
  bytes += "\nend_header\n";
  return bytes + (options.ascii ? body_of<TextBody> : body_of<ByteBody>)(mesh, choice, images,
                                                                         options.single_precision);
}

}  // namespace whittle::files
