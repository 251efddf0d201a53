/// \file
/// From a mesh to a file.
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "files/Choice.hh"
#include "files/Descriptor.hh"
#include "files/Fault.hh"
#include "files/formats.hh"

namespace whittle::files {
namespace {

using attributes::Attribute;
using attributes::Kind;

Format format_for(const std::filesystem::path& path, const WriteOptions& options) {
  if (options.format.empty() && path == "-") throw Fault("the format of standard output must be named");
  const Format format =
      format_of_extension(options.format.empty() ? path.extension().string() : "." + options.format);
  if (format == Format::gltf) throw Fault(".gltf is only read; glTF is written as .glb");
  return format;
}

std::string name_of(const std::filesystem::path& path) {
  return path == "-" ? "standard output" : path.string();
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

/// Never replaced and never flushed to a disk: what is open there may be anything.
void write_standard_output(const std::string& bytes) {
  // What was printed before comes first.
  std::cout.flush();
  std::fflush(stdout);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) throw Fault(error_text(errno));
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  if (path == "-")
    naming(name_of(path), [&] { write_standard_output(bytes); });
  else
    write_file(path, bytes);
}

}  // namespace

std::string mesh_bytes(const IndexedMesh& mesh, const attributes::Attributes& attributes,
                       const WriteOptions& options, Format format, WriteReport& report) {
  check_mesh(mesh, attributes, options.single_precision || format == Format::stl || format == Format::glb);
  if (!all_finite(attributes))
    return mesh_bytes(mesh, with_finite_values(attributes, report), options, format, report);
  switch (format) {
    case Format::obj:
      return obj_bytes(mesh, attributes, options, report);
    case Format::off:
      return off_bytes(mesh, attributes, options, report);
    case Format::ply:
      return ply_bytes(mesh, attributes, options, report);
    case Format::stl:
      return stl_bytes(mesh, attributes, options, report);
    case Format::om:
      return om_bytes(mesh, attributes, options, report);
    default:
      return glb_bytes({{&mesh, &attributes, 0}}, report);
  }
}

WriteReport write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                       const WriteOptions& options, const attributes::Attributes& attributes) {
  WriteReport report;
  const std::string bytes = naming(name_of(path), [&] {
    return mesh_bytes(mesh, attributes, options, format_for(path, options), report);
  });
  write_bytes(path, bytes);
  return report;
}

WriteReport write_glb_levels(const std::filesystem::path& path, const std::vector<Level>& levels) {
  WriteReport report;
  const std::string bytes = naming(name_of(path), [&] {
    std::vector<attributes::Attributes> finite;
    finite.reserve(levels.size());
    std::vector<LevelView> views;
    for (const Level& level : levels) {
      check_mesh(level.mesh, level.attributes, true);
      finite.push_back(with_finite_values(level.attributes, report));
      views.push_back({&level.mesh, &finite.back(), level.error});
    }
    return glb_bytes(views, report);
  });
  write_bytes(path, bytes);
  return report;
}

void check_writable(const std::filesystem::path& path, const WriteOptions& options) {
  naming(name_of(path), [&] { return format_for(path, options); });
  if (path != "-") check_creatable(path);
}

}  // namespace whittle::files
