/// \file
/// Wavefront OBJ: writing.
#include "files/Choice.hh"
#include "files/TextWriter.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;

void write_normals(TextWriter& out, const Attribute& normal) {
  for (std::size_t i = 0; i < normal.n_values(); ++i) (out << "vn").floats(normal.value(i), 3) << "\n";
}

void write_texture(TextWriter& out, const Attribute& texture) {
  for (std::size_t i = 0; i < texture.n_values(); ++i)
    out << "vt " << texture.value(i)[0] << " " << v_of(texture, i, false) << "\n";
}

/// Behind the coordinates, as MeshLab and Blender have it. Few programs expect a fourth number, so opacity is
/// written only if something is not opaque.
std::size_t colour_numbers(const Attribute& colour) {
  if (colour.components == 3) return 3;
  for (std::size_t i = 0; i < colour.n_values(); ++i)
    if (colour.value(i)[3] != 1.0F) return 4;
  return 3;
}

/// Four numbers that all begin with 1 would be read as a weight and a colour; with a weight before them they are not.
bool wants_weight(const Attribute& colour, std::size_t numbers) {
  if (numbers < 4) return false;
  for (std::size_t i = 0; i < colour.n_values(); ++i)
    if (colour.value(i)[0] != 1.0F) return false;
  return true;
}

}  // namespace

std::string obj_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, WriteReport& report) {
  const Choice choice =
      choose(attributes, {Place::corners, Place::vertices, Place::corners, Place::nowhere}, report);
  TextWriter out(options.single_precision);
  const std::size_t colours = choice.colour ? colour_numbers(*choice.colour) : 0;
  const bool weight = choice.colour && wants_weight(*choice.colour, colours);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out << "v " << mesh.points[i];
    if (weight) out << " 1";
    if (colours > 0) out.floats(choice.colour->value(i), colours);
    out << "\n";
  }
  if (choice.texture) write_texture(out, *choice.texture);
  if (choice.normal) write_normals(out, *choice.normal);

  const auto number = [](std::uint32_t index) { return std::uint64_t{index} + 1; };  // OBJ counts from 1
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    out << "f";
    for (std::size_t k = 0; k < 3; ++k) {
      out << " " << number(mesh.triangles[face][k]);
      if (choice.texture) out << "/" << number(choice.texture->at(mesh, face, k));
      if (choice.normal) out << (choice.texture ? "/" : "//") << number(choice.normal->at(mesh, face, k));
    }
    out << "\n";
  }
  return out.take();
}

}  // namespace whittle::files
