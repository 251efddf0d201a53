/// \file
/// What is written reads back, to the last bit.
#include <limits>

#include "samples.hh"

namespace whittle::files {
namespace {

TEST_CASE("round trip: every format, every coordinate bit") {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    const bool single = flavour.options.single_precision;
    const IndexedMesh mesh = single ? strip<float>(500) : strip<double>(500);
    write_mesh(folder / flavour.file, mesh, flavour.options);
    const MeshFile back = read_mesh(folder / flavour.file);
    // Text without types is read as double, and the shortest digits of a float name another double.
    const bool typed = flavour.format != "OBJ" && flavour.format != "OFF";
    CHECK((typed || !single ? same_bits<double>(back.mesh, mesh) : same_bits<float>(back.mesh, mesh)));
    CHECK(back.single_precision == (typed && single));
    CHECK(back.report.format == flavour.format);
    CHECK(back.report.ignored.empty());
    CHECK(back.report.dropped_degenerate == 0);
  }
}

TEST_CASE("round trip: the ends of the range, and minus zero") {
  const Folder folder;
  using Double = std::numeric_limits<double>;
  using Float = std::numeric_limits<float>;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    IndexedMesh mesh;
    mesh.triangles = {{0, 1, 2}};
    if (flavour.options.single_precision) {
      mesh.points = {{Float::max(), Float::min(), Float::denorm_min()},
                     {-Float::max(), -0.0, 0.1F},
                     {16777217.0F, 1, 2}};
      write_mesh(folder / flavour.file, mesh, flavour.options);
      CHECK(same_bits<float>(read_mesh(folder / flavour.file).mesh, mesh));
    } else {
      mesh.points = {
          {Double::max(), Double::min(), Double::denorm_min()}, {-Double::max(), -0.0, 0.1}, {1.0 / 3, 1, 2}};
      write_mesh(folder / flavour.file, mesh, flavour.options);
      CHECK(same_bits<double>(read_mesh(folder / flavour.file).mesh, mesh));
    }
  }
}

TEST_CASE("round trip: writing twice gives the same bytes") {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    write_mesh(folder / flavour.file, strip<double>(50), flavour.options);
    const std::string first = folder.get(flavour.file);
    write_mesh(folder / flavour.file, strip<double>(50), flavour.options);
    CHECK(folder.get(flavour.file) == first);
  }
}

TEST_CASE("round trip: an empty mesh stays empty") {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    write_mesh(folder / flavour.file, {}, flavour.options);
    if (flavour.format == "OBJ") {
      CHECK(folder.get(flavour.file).empty());
    } else {
      CHECK(read_mesh(folder / flavour.file).mesh.points.empty());
    }
  }
}

TEST_CASE("write_mesh refuses what no reader would take back") {
  const Folder folder;
  IndexedMesh mesh = strip<double>(3);
  const auto error = [&](const std::string& name, const WriteOptions& options = {}) {
    return folder.message([&] { write_mesh(folder / name, mesh, options); });
  };
  CHECK(error("a.xyz") ==
        "a.xyz: unknown format '.xyz'; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  CHECK(error("a") == "a: no extension; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  mesh.points[1].y() = 1e39;
  CHECK(error("a.stl") == "a.stl: not written: a coordinate is too large for a 32-bit float");
  CHECK(error("a.obj", {false, true}) == "a.obj: not written: a coordinate is too large for a 32-bit float");
  CHECK(error("b.obj").empty());
  mesh.points[1].y() = std::nan("");
  CHECK(error("a.ply") == "a.ply: not written: a coordinate is not finite");
  mesh.points[1].y() = 0;
  mesh.triangles.push_back({0, 1, 3});
  CHECK(error("a.off") == "a.off: not written: a triangle names a vertex that is not there");
  CHECK(folder.entries() == 1);
}

}  // namespace
}  // namespace whittle::files
