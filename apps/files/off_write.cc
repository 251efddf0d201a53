/// \file
/// Geomview's OFF: writing.
#include "files/Choice.hh"
#include "files/TextWriter.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;

/// Whole numbers are 0..255 in OFF, so a float that is whole needs its decimal point.
void write_colour(TextWriter& out, const Attribute& colour, std::size_t vertex) {
  for (std::size_t k = 0; k < colour.components; ++k) {
    const float value = colour.value(vertex)[k];
    out << " ";
    if (colour.bytes)
      out << std::uint64_t{to_byte(value)};
    else
      out.with_point(value);
  }
}

}  // namespace

std::string off_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                      const WriteOptions& options, WriteReport& report) {
  const Choice choice =
      choose(attributes, {Place::vertices, Place::vertices, Place::vertices, Place::nowhere}, report);
  TextWriter out(options.single_precision);
  if (choice.texture) out << "ST";
  if (choice.colour) out << "C";
  if (choice.normal) out << "N";
  out << "OFF\n" << mesh.points.size() << " " << mesh.triangles.size() << " 0\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out << mesh.points[i];
    if (choice.normal) out.floats(choice.normal->value(i), 3);
    if (choice.colour) write_colour(out, *choice.colour, i);
    if (choice.texture) out << " " << choice.texture->value(i)[0] << " " << v_of(*choice.texture, i, false);
    out << "\n";
  }
  for (const auto& [a, b, c] : mesh.triangles)
    out << "3 " << std::uint64_t{a} << " " << std::uint64_t{b} << " " << std::uint64_t{c} << "\n";
  return out.take();
}

}  // namespace whittle::files
