/// \file
/// libFuzzer's entry to the reader of one format.
///
/// Whatever the bytes are, a Fault comes or a mesh that is sound; repaired it is manifold; and what is
/// written of it reads back.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <string_view>

#include "files/Fault.hh"
#include "files/Zip.hh"
#include "files/formats.hh"
#include "files/manifold.hh"
#include "fuzz/format.hh"
#include "sound.hh"

namespace {

using namespace whittle::files;

using whittle::fuzz::format;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

MeshFile parsed(std::string_view bytes, Format as, Repair repair) {
  std::size_t line = 0;
  MeshFile file = parse(bytes, as, {repair}, line);
  const char* what = unsound(file);
  require(what == nullptr, what);
  return file;
}

void check_manifold(const whittle::IndexedMesh& mesh) {
  const NonManifold found =
      count_nonmanifold(mesh, whittle::measure::sides_by_edge(mesh.triangles, mesh.points.size()));
  require(found.edges == 0 && found.vertices == 0, "not manifold after repair");
}

void check_there_and_back(const MeshFile& file) {
  const Format written = format == Format::gltf ? Format::glb : format;
  WriteOptions options;
  options.single_precision = file.single_precision;
  Encoded out;
  try {
    encode_as("-", file.mesh, file.attributes, options, written, {}, out);
  } catch (const Fault&) {
    return;  // too large for 32-bit floats
  }
  const MeshFile back = parsed(out.bytes, written, Repair::none);
  const std::size_t faces = back.mesh.triangles.size() + back.report.dropped_degenerate;
  require(faces == file.mesh.triangles.size(), "not as many faces there and back");
}

/// A glTF scene that is written back with the triangles that it has.
void check_scene(std::string_view bytes) {
  std::size_t line = 0;
  ReadOptions options;
  options.keep_scene = true;
  const MeshFile file = parse(bytes, format, options, line);
  const char* what = unsound(file);
  require(what == nullptr, what);
  std::vector<std::uint32_t> same(file.mesh.points.size());
  std::iota(same.begin(), same.end(), 0U);
  Encoded written;
  try {
    written = encode_scene("scene.glb", file, {file.mesh, file.attributes, file.parts.of_face, same});
  } catch (const FileError&) {
    return;  // JSON that is damaged elsewhere
  }
  const MeshFile back = parse(written.bytes, Format::glb, options, line);
  const std::size_t faces = back.mesh.triangles.size() + back.report.dropped_degenerate;
  require(faces == file.mesh.triangles.size(), "not as many faces there and back in a scene");
}

}  // namespace

namespace {

/// 3MF is read from an archive, whose checksums nothing survives that was changed; so what is no archive is the model in one.
std::string in_archive(std::string_view model) {
  ZipWriter zip;
  zip.add("_rels/.rels",
          "<Relationship Target='/a.model' "
          "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>");
  zip.add("a.model", std::string(model));
  return zip.take();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string archive;
  if (format == Format::three_mf && !is_zip(bytes)) bytes = archive = in_archive(bytes);
  try {
    check_there_and_back(parsed(bytes, format, Repair::report));
  } catch (const Fault&) {
  }
  try {
    const MeshFile fixed = parsed(bytes, format, Repair::fix);
    check_manifold(fixed.mesh);
    check_there_and_back(fixed);
  } catch (const Fault&) {
  }
  if (format != Format::glb && format != Format::gltf) return 0;
  try {
    check_scene(bytes);
  } catch (const Fault&) {
  }
  return 0;
}
