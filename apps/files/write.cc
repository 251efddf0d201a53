/// \file
/// From a mesh to a file.
#include <cmath>
#include <utility>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/GltfOutput.hh"
#include "files/Outputs.hh"
#include "files/companions.hh"
#include "files/formats.hh"
#include "files/gzip.hh"
#include "files/obj_materials.hh"
#include "files/split.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

constexpr std::size_t kKinds = 6;

/// A value that is not finite would make a file that few programs read. Scalars may say "none" so.
attributes::Attributes with_finite_values(attributes::Attributes attributes, WriteReport& report) {
  for (Attribute& attribute : attributes) {
    if (attribute.kind == Kind::scalar) continue;
    for (float& value : attribute.values) {
      if (std::isfinite(value)) continue;
      value = 0;
      reduce(report, to_string(attribute) + " that are not finite written as 0");
    }
  }
  return attributes;
}

bool all_finite(const attributes::Attributes& attributes) {
  for (const Attribute& attribute : attributes) {
    if (attribute.kind == Kind::scalar) continue;
    for (const float value : attribute.values)
      if (!std::isfinite(value)) return false;
  }
  return true;
}

bool is_gltf(Format format) {
  return format == Format::glb || format == Format::gltf;
}

std::size_t components_of(const Attribute& attribute) {
  switch (attribute.kind) {
    case Kind::normal:
      return 3;
    case Kind::texture:
      return 2;
    case Kind::scalar:
      return 1;
    default:
      return attribute.components;
  }
}

void check_attribute(const IndexedMesh& mesh, const Attribute& attribute) {
  const bool right_size = attribute.kind == Kind::colour
                              ? attribute.components == 3 || attribute.components == 4
                              : attribute.components == components_of(attribute);
  bool fits = right_size && attribute.values.size() % attribute.components == 0;
  if (fits && attribute.per_vertex()) {
    fits = attribute.n_values() == mesh.points.size();
  } else if (fits) {
    fits = attribute.corners.size() == mesh.triangles.size();
    for (const IndexedMesh::Triangle& corners : attribute.corners)
      for (const std::uint32_t corner : corners) fits = fits && corner < attribute.n_values();
  }
  if (!fits) throw Fault("not written: " + to_string(attribute) + " do not fit the mesh");
}

/// What no reader would take back is not written.
void check_mesh(const IndexedMesh& mesh, const attributes::Attributes& attributes, bool single_precision) {
  for (const IndexedMesh::Point& point : mesh.points) {
    for (const double value : point) {
      if (!std::isfinite(value)) throw Fault("not written: a coordinate is not finite");
      if (single_precision && !std::isfinite(static_cast<float>(value)))
        throw Fault("not written: a coordinate is too large for a 32-bit float");
    }
  }
  for (const IndexedMesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.points.size())
        throw Fault("not written: a triangle names a vertex that is not there");
  for (const Attribute& attribute : attributes) check_attribute(mesh, attribute);
}

void check_parts(const IndexedMesh& mesh, const Parts& parts) {
  bool fits = parts.of_face.empty() || parts.of_face.size() == mesh.triangles.size();
  for (const std::uint32_t part : parts.of_face) fits = fits && part < parts.list.size();
  for (const Part& part : parts.list)
    fits = fits && (part.material == Part::none || part.material < parts.materials.size());
  for (const Material& material : parts.materials)
    fits = fits && (!material.image || *material.image < parts.images.size());
  if (!fits) throw Fault("not written: parts do not fit the mesh");
}

/// "materials in a.mtl, b.mtl": for people.
std::string where_materials_are(const std::vector<std::string>& libraries) {
  std::string text;
  for (const std::string& library : libraries) text += (text.empty() ? "materials in " : ", ") + library;
  return text;
}

void encode_obj(const std::filesystem::path& path, const IndexedMesh& mesh,
                const attributes::Attributes& attributes, const WriteOptions& options, const Parts& parts,
                Encoded& out) {
  ObjMaterials beside = obj_materials(parts, path, options.copy_materials, out.report);
  out.bytes = obj_bytes(mesh, attributes, options, parts, beside.libraries, out.report);
  out.report.materials = where_materials_are(beside.libraries);
  out.companions = std::move(beside.companions);
}

/// Whether a format can hold an attribute.
bool can_hold(Format format, const Attribute& attribute) {
  if (attribute.kind == Kind::vector || attribute.kind == Kind::skin) return false;
  if (format == Format::stl || format == Format::three_mf) return false;
  if (format == Format::om) return attribute.per_vertex() || attribute.kind == Kind::texture;
  return attribute.kind != Kind::scalar || format == Format::ply || is_gltf(format);
}

bool can_hold_materials(Format format) {
  return format == Format::obj || is_gltf(format);
}

/// Whether a format has values of a kind at vertices only, and more vertices help.
bool takes_at_vertices(Format format, Kind kind, const WriteOptions& options) {
  if (format == Format::obj) return kind == Kind::colour;
  if (format == Format::off) return kind != Kind::scalar;
  if (format == Format::ply) return kind != Kind::texture || options.texture_at_vertices;
  return false;  // STL has none; where OM has half-edges, a doubled vertex is a hole
}

/// Those that are written and differ at corners where the format has values at vertices.
std::vector<const Attribute*> to_be_split(const attributes::Attributes& attributes, Format format,
                                          const WriteOptions& options) {
  std::vector<const Attribute*> out;
  bool seen[kKinds] = {};
  for (const Attribute& attribute : attributes) {
    const bool is_second = std::exchange(seen[static_cast<std::size_t>(attribute.kind)], true);
    if (is_second && attribute.kind != Kind::scalar) continue;
    if (!attribute.per_vertex() && takes_at_vertices(format, attribute.kind, options))
      out.push_back(&attribute);
  }
  return out;
}

}  // namespace

Format format_to_write(const std::filesystem::path& path, const WriteOptions& options) {
  if (options.format.empty() && path == "-") throw Fault("the format of standard output must be named");
  const Format format =
      format_of_extension(options.format.empty() ? extension_of_format(path) : "." + options.format);
  if (format == Format::gltf && !has_a_folder(path))
    throw Fault(std::string("gltf has its data in a file beside it; ") +
                (path == "-" ? "standard output takes glb" : "devices and pipes take glb"));
  return format;
}

void encode_as(const std::filesystem::path& path, const IndexedMesh& mesh,
               const attributes::Attributes& attributes, const WriteOptions& options, Format format,
               const Parts& parts, Encoded& out) {
  check_parts(mesh, parts);
  check_mesh(mesh, attributes, options.single_precision || format == Format::stl || is_gltf(format));
  WriteReport& report = out.report;
  if (!all_finite(attributes))
    return encode_as(path, mesh, with_finite_values(attributes, report), options, format, parts, out);
  if (const auto at_corners = to_be_split(attributes, format, options); !at_corners.empty()) {
    SplitMesh split = split_mesh(mesh, attributes, at_corners);
    report.doubled_vertices = split.mesh.points.size() - mesh.points.size();
    report.first_vertex = std::move(split.first);
    return encode_as(path, split.mesh, split.attributes, options, format, parts, out);
  }
  const bool has_unit = !options.unit.empty() && options.unit != "millimeter";
  if (has_unit && format != Format::three_mf) leave_out(report, "the unit, '" + options.unit + "'");
  if (!can_hold_materials(format) && parts.has_materials()) leave_out(report, "materials");
  switch (format) {
    case Format::obj:
      return encode_obj(path, mesh, attributes, options, parts, out);
    case Format::off:
      out.bytes = off_bytes(mesh, attributes, options, report);
      break;
    case Format::ply:
      out.bytes = ply_bytes(mesh, attributes, options, report);
      break;
    case Format::stl:
      out.bytes = stl_bytes(mesh, attributes, options, report);
      break;
    case Format::three_mf:
      out.bytes = three_mf_bytes(mesh, attributes, options, parts, report);
      break;
    case Format::om:
      out.bytes = om_bytes(mesh, attributes, options, report);
      break;
    default:
      GltfOutput document = gltf_of({{&mesh, &attributes, &parts, 0}}, report);
      encode_gltf(document, path, format, options, true, out);
  }
}

std::vector<std::string> take_unwritable(attributes::Attributes& attributes,
                                         const std::filesystem::path& path, const WriteOptions& options,
                                         const std::function<bool(const Attribute&)>& keeps) {
  const Format format = naming(path, [&] { return format_to_write(path, options); });
  std::vector<std::string> gone;
  attributes::Attributes left;
  bool seen[kKinds] = {};
  for (Attribute& attribute : attributes) {
    const bool holds = can_hold(format, attribute);
    const bool is_second = holds && std::exchange(seen[static_cast<std::size_t>(attribute.kind)], true) &&
                           attribute.kind != Kind::scalar;
    if ((holds && !is_second) || keeps(attribute)) {
      left.push_back(std::move(attribute));
      continue;
    }
    const bool at_corners = format == Format::om && !attribute.per_vertex();
    gone.push_back((is_second ? "a second set of " : "") + to_string(attribute) +
                   (at_corners && !is_second ? " that differ between the corners of a vertex" : ""));
  }
  attributes = std::move(left);
  return gone;
}

bool holds_scenes(const std::filesystem::path& path, const WriteOptions& options) {
  return naming(path, [&] { return is_gltf(format_to_write(path, options)); });
}

bool writes_text(const std::filesystem::path& path, const WriteOptions& options) {
  const Format format = naming(path, [&] { return format_to_write(path, options); });
  const bool may_be_text = format == Format::ply || format == Format::stl;
  return format == Format::obj || format == Format::off || format == Format::three_mf ||
         (may_be_text && options.ascii);
}

bool holds_materials(const std::filesystem::path& path, const WriteOptions& options) {
  return naming(path, [&] { return can_hold_materials(format_to_write(path, options)); });
}

Encoded encode_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options,
                    const attributes::Attributes& attributes, const Parts& parts) {
  return naming(path, [&] {
    Encoded encoded;
    encode_as(path, mesh, attributes, options, format_to_write(path, options), parts, encoded);
    if (is_gzip_name(path)) encoded.bytes = gzipped(encoded.bytes);
    return encoded;
  });
}

WriteReport write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                       const WriteOptions& options, const attributes::Attributes& attributes,
                       const Parts& parts) {
  Encoded encoded = encode_mesh(path, mesh, options, attributes, parts);
  if (encoded.companions.empty()) {
    write_file(path, encoded.bytes);
    return encoded.report;
  }
  Outputs outputs;
  outputs.add("mesh", path);
  outputs.write("mesh", std::move(encoded.bytes));
  outputs.write_beside(std::move(encoded.companions));
  outputs.commit();
  return encoded.report;
}

Encoded encode_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels,
                          const WriteOptions& options) {
  return naming(path, [&] {
    Encoded encoded;
    std::vector<attributes::Attributes> finite;
    finite.reserve(levels.size());
    std::vector<LevelView> views;
    for (const Level& level : levels) {
      check_mesh(level.mesh, level.attributes, true);
      finite.push_back(with_finite_values(level.attributes, encoded.report));
      check_parts(level.mesh, level.parts);
      views.push_back({&level.mesh, &finite.back(), &level.parts, level.error});
    }
    GltfOutput document = gltf_of(views, encoded.report);
    encode_gltf(document, path, Format::glb, options, true, encoded);
    if (is_gzip_name(path)) encoded.bytes = gzipped(encoded.bytes);
    return encoded;
  });
}

WriteReport write_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels) {
  const Encoded encoded = encode_glb_levels(path, levels);
  write_file(path, encoded.bytes);
  return encoded.report;
}

void check_writable(const std::filesystem::path& path, const WriteOptions& options) {
  naming(path, [&] { return format_to_write(path, options); });
  check_creatable(path);
}

}  // namespace whittle::files
