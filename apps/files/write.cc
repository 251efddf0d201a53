/// \file
/// From a mesh to a file.
#include <cmath>
#include <utility>
#include <vector>

#include "files/Choice.hh"
#include "files/Fault.hh"
#include "files/formats.hh"
#include "files/gzip.hh"
#include "files/split.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

Format format_for(const std::filesystem::path& path, const WriteOptions& options) {
  if (options.format.empty() && path == "-") throw Fault("the format of standard output must be named");
  const Format format =
      format_of_extension(options.format.empty() ? extension_of_format(path) : "." + options.format);
  if (format == Format::gltf) throw Fault(".gltf is only read; glTF is written as .glb");
  return format;
}

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

std::size_t components_of(Kind kind) {
  return kind == Kind::normal ? 3 : kind == Kind::texture ? 2 : 1;
}

void check_attribute(const IndexedMesh& mesh, const Attribute& attribute) {
  const bool right_size = attribute.kind == Kind::colour
                              ? attribute.components == 3 || attribute.components == 4
                              : attribute.components == components_of(attribute.kind);
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

/// Whether a format can hold an attribute.
bool can_hold(Format format, const Attribute& attribute) {
  if (format == Format::stl || format == Format::three_mf) return false;
  if (format == Format::om) return attribute.per_vertex() || attribute.kind == Kind::texture;
  return attribute.kind != Kind::scalar || format == Format::ply || format == Format::glb;
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
  bool seen[4] = {false, false, false, false};
  for (const Attribute& attribute : attributes) {
    const bool is_second = std::exchange(seen[static_cast<std::size_t>(attribute.kind)], true);
    if (is_second && attribute.kind != Kind::scalar) continue;
    if (!attribute.per_vertex() && takes_at_vertices(format, attribute.kind, options))
      out.push_back(&attribute);
  }
  return out;
}

}  // namespace

std::string mesh_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                       const WriteOptions& options, Format format, WriteReport& report) {
  check_mesh(mesh, attributes, options.single_precision || format == Format::stl || format == Format::glb);
  if (!all_finite(attributes))
    return mesh_bytes(mesh, with_finite_values(attributes, report), options, format, report);
  if (const auto at_corners = to_be_split(attributes, format, options); !at_corners.empty()) {
    SplitMesh split = split_mesh(mesh, attributes, at_corners);
    report.doubled_vertices = split.mesh.points.size() - mesh.points.size();
    report.first_vertex = std::move(split.first);
    return mesh_bytes(split.mesh, split.attributes, options, format, report);
  }
  switch (format) {
    case Format::obj:
      return obj_bytes(mesh, attributes, options, report);
    case Format::off:
      return off_bytes(mesh, attributes, options, report);
    case Format::ply:
      return ply_bytes(mesh, attributes, options, report);
    case Format::stl:
      return stl_bytes(mesh, attributes, options, report);
    case Format::three_mf:
      return three_mf_bytes(mesh, attributes, options, report);
    case Format::om:
      return om_bytes(mesh, attributes, options, report);
    default:
      return glb_bytes({{&mesh, &attributes, 0}}, report);
  }
}

std::vector<std::string> take_unwritable(attributes::Attributes& attributes,
                                         const std::filesystem::path& path, const WriteOptions& options,
                                         const std::function<bool(const Attribute&)>& keeps) {
  const Format format = naming(path, [&] { return format_for(path, options); });
  std::vector<std::string> gone;
  attributes::Attributes left;
  bool seen[4] = {false, false, false, false};
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

Encoded encode_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options,
                    const attributes::Attributes& attributes) {
  return naming(path, [&] {
    Encoded encoded;
    encoded.bytes = mesh_bytes(mesh, attributes, options, format_for(path, options), encoded.report);
    if (is_gzip_name(path)) encoded.bytes = gzipped(encoded.bytes);
    return encoded;
  });
}

WriteReport write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                       const WriteOptions& options, const attributes::Attributes& attributes) {
  const Encoded encoded = encode_mesh(path, mesh, options, attributes);
  write_file(path, encoded.bytes);
  return encoded.report;
}

Encoded encode_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels) {
  return naming(path, [&] {
    Encoded encoded;
    std::vector<attributes::Attributes> finite;
    finite.reserve(levels.size());
    std::vector<LevelView> views;
    for (const Level& level : levels) {
      check_mesh(level.mesh, level.attributes, true);
      finite.push_back(with_finite_values(level.attributes, encoded.report));
      views.push_back({&level.mesh, &finite.back(), level.error});
    }
    encoded.bytes = glb_bytes(views, encoded.report);
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
  naming(path, [&] { return format_for(path, options); });
  check_creatable(path);
}

}  // namespace whittle::files
