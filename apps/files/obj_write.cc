/// \file
/// Wavefront OBJ: writing.
#include <algorithm>
#include <numeric>

#include "files/Choice.hh"
#include "files/TextWriter.hh"
#include "files/formats.hh"
#include "files/mtl.hh"

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

std::string on_one_line(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return name;
}

/// The statements that make one part of another; null: there was none before.
void write_part(TextWriter& out, const Part& part, const Part* before,
                const std::vector<std::string>& materials) {
  const Part nothing;
  const Part& old = before ? *before : nothing;
  const auto write = [&](const char* keyword, const std::string& now, const std::string& then,
                         const char* otherwise) {
    if (now != then) out << keyword << (now.empty() ? otherwise : on_one_line(now)) << "\n";
  };
  const auto name = [&](const Part& of) {
    return of.material == Part::none ? std::string() : materials[of.material];
  };
  write("o ", part.object, old.object, "default");
  write("g ", part.group, old.group, "default");
  write("usemtl ", name(part), name(old), "default");
  write("s ", part.smoothing, old.smoothing, "off");
}

/// The faces in the order in which they are written: part after part.
std::vector<std::uint32_t> by_part(const Parts& parts, std::size_t faces) {
  std::vector<std::uint32_t> order(faces);
  std::iota(order.begin(), order.end(), 0U);
  if (!parts.of_face.empty())
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return parts.of_face[a] < parts.of_face[b]; });
  return order;
}

}  // namespace

std::string obj_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, const Parts& parts,
                      const std::vector<std::string>& libraries, WriteReport& report) {
  const Choice choice =
      choose(attributes, {Place::corners, Place::vertices, Place::corners, Place::nowhere}, report);
  TextWriter out(options.single_precision);
  for (const std::string& library : libraries) out << "mtllib " << library << "\n";
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
  const std::vector<std::string> materials = obj_material_names(parts.materials);
  const Part* now = nullptr;
  for (const std::uint32_t face : by_part(parts, mesh.triangles.size())) {
    const Part* part = parts.of_face.empty() ? nullptr : &parts.list[parts.of_face[face]];
    if (part != now) write_part(out, *part, now, materials);
    now = part;
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
