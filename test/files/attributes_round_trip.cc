/// \file
/// Attributes that a format holds are read back as they were, and what it does not hold is reported.
#include <map>

#include "samples.hh"

namespace whittle::files {
namespace {

/// Flavours that hold them, by the kind of thing.
bool holds(const std::string& format, Kind kind, bool at_corners) {
  const bool obj = format == "OBJ", off = format == "OFF", om = format == "OM", glb = format[0] == 'g';
  const bool ply = format.find("PLY") == 0;
  if (kind == Kind::scalar) return ply || om || glb;
  const bool om_holds = om && (!at_corners || kind == Kind::texture);
  return obj || off || ply || om_holds || glb;
}

void check(const Attribute& attribute) {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file << ": " << to_string(attribute));
    const WriteReport report = write_mesh(folder / flavour.file, square(), flavour.options, {attribute});
    const MeshFile back = read_mesh(folder / flavour.file);
    CHECK(back.mesh.triangles == square().triangles);
    if (!holds(flavour.format, attribute.kind, !attribute.per_vertex())) {
      CHECK(report.left_out.size() == 1);
      CHECK(back.attributes.empty());
      continue;
    }
    CHECK(report.left_out.empty());
    REQUIRE(back.attributes.size() == 1);
    // Only glTF counts v downwards; there 1 - v is exact for these values.
    Attribute expected = attribute;
    const bool glb = flavour.format[0] == 'g';
    if (attribute.kind == Kind::texture && glb != attribute.downwards) {
      expected.downwards = glb;
      for (std::size_t i = 1; i < expected.values.size(); i += 2) expected.values[i] = 1 - expected.values[i];
    }
    CHECK(same_attribute(back.attributes[0], expected, square()));
    CHECK(report.reduced.empty());
  }
}

TEST_CASE("round trip: attributes of vertices") {
  check(square_normals());
  check(square_colours(true, false));
  check(square_texture());
  check(scalar("quality", {0.1F, -2, 1e30F, 0}));
}

TEST_CASE("round trip: attributes of corners, with a seam") {
  check(square_seam());
  check(attribute(Kind::normal, 3, {0, 0, 1, 0, 1, 0, 1, 0, 0}, {{0, 0, 0}, {1, 2, 1}}));
  Attribute colour = attribute(Kind::colour, 3, {0, 0.2F, 1, 1, 0.4F, 0}, {{0, 0, 0}, {1, 1, 1}});
  colour.bytes = true;
  check(colour);
}

TEST_CASE("round trip: floating colours and opacity") {
  const Folder folder;
  for (const char* file : {"a.off", "a.ply", "a.obj", "a.glb"}) {
    INFO(file);
    for (const bool opacity : {false, true}) {
      const Attribute colour = square_colours(false, opacity);
      CHECK(
          same_attribute(folder.there_and_back(file, square(), {colour}).attributes.at(0), colour, square()));
    }
    if (std::string(file) == "a.obj") continue;  // there opaque colours have three components
    const Attribute bytes = square_colours(true, true);
    CHECK(same_attribute(folder.there_and_back(file, square(), {bytes}).attributes.at(0), bytes, square()));
  }
}

TEST_CASE("round trip: all together, through every format that holds them") {
  const Folder folder;
  const Attributes all{square_colours(true, false), square_normals(), square_seam(),
                       scalar("confidence", {1, 0.5F, 0.25F, 0})};
  for (const char* file : {"a.ply", "a.om", "a.glb"}) {
    INFO(file);
    const MeshFile once = folder.there_and_back(file, square(), all);
    CHECK(once.attributes.size() == 4);
    // What came of a file goes back as it is.
    const MeshFile twice = folder.there_and_back(file, once.mesh, once.attributes);
    REQUIRE(twice.attributes.size() == 4);
    for (const Attribute& one : once.attributes)
      CHECK(same_attribute(find(twice.attributes, one.kind, one.name), one, once.mesh));
    CHECK(same_bits<double>(twice.mesh, once.mesh));
  }
}

TEST_CASE("round trip: texture coordinates turn over between glTF and the others, and back") {
  const Folder folder;
  const MeshFile glb = folder.there_and_back("a.glb", square(), {square_texture()});
  CHECK(glb.attributes.at(0).downwards);
  CHECK(glb.attributes[0].values[1] == 1 - 0.1F);
  const MeshFile obj = folder.there_and_back("a.obj", glb.mesh, glb.attributes);
  CHECK_FALSE(obj.attributes.at(0).downwards);
  for (std::size_t i = 0; i < 8; ++i)
    CHECK(std::abs(obj.attributes[0].values[i] - square_texture().values[i]) < 1e-7F);
}

TEST_CASE("write_mesh says what a format does not hold") {
  const Folder folder;
  const Attributes all{square_normals(), square_colours(false, true), square_seam(), square_texture(),
                       scalar("quality", {1, 2, 3, 4})};
  const auto report = [&](const char* file) { return write_mesh(folder / file, square(), {}, all); };
  CHECK(report("a.stl").left_out == Names{"normals", "colours", "texture coordinates", "property 'quality'"});
  CHECK(report("a.obj").left_out == Names{"a second set of texture coordinates", "property 'quality'"});
  CHECK(report("a.off").left_out == Names{"a second set of texture coordinates", "property 'quality'"});
  CHECK(report("a.om").left_out == Names{"a second set of texture coordinates", "opacity"});
  CHECK(report("a.om").reduced == Names{"colours rounded to 8 bits"});
  CHECK(report("a.om").notes() ==
        Names{"colours rounded to 8 bits", "not written: a second set of texture coordinates, opacity"});
  CHECK(report("a.glb").left_out == Names{"a second set of texture coordinates"});
}

TEST_CASE("write_mesh writes no value that is not finite, and no attribute that does not fit") {
  const Folder folder;
  Attribute normal = square_normals();
  normal.values[4] = std::nanf("");
  for (const char* file : {"a.obj", "a.off", "a.ply", "a.om", "a.glb"}) {
    INFO(file);
    const WriteReport report = write_mesh(folder / file, square(), {}, {normal});
    CHECK(report.reduced == Names{"normals that are not finite written as 0"});
    CHECK(read_mesh(folder / file).report.zeroed_values == 0);
  }
  normal = square_normals();
  normal.values.pop_back();
  const auto error = [&] {
    return folder.message([&] { write_mesh(folder / "b.obj", square(), {}, {normal}); });
  };
  CHECK(error() == "b.obj: not written: normals do not fit the mesh");
  normal = attribute(Kind::normal, 3, {0, 0, 1}, {{0, 0, 0}, {0, 0, 1}});
  CHECK(error() == "b.obj: not written: normals do not fit the mesh");
  normal = attribute(Kind::normal, 3, {0, 0, 1}, {{0, 0, 0}});
  CHECK(error() == "b.obj: not written: normals do not fit the mesh");
  normal = attribute(Kind::colour, 2, {0, 0, 1, 1, 1, 1, 0, 0});
  CHECK(error() == "b.obj: not written: colours do not fit the mesh");
}

TEST_CASE("scalars may be not a number where a file can say so") {
  const Folder folder;
  const Attribute nan = scalar("q", {1, std::nanf(""), 2, INFINITY});
  for (const WriteOptions& options : {WriteOptions{true, false}, WriteOptions{false, false}}) {
    const MeshFile back = folder.there_and_back("a.ply", square(), {nan}, options);
    CHECK(std::isnan(back.attributes.at(0).values[1]));
    CHECK(std::isinf(back.attributes[0].values[3]));
  }
  CHECK(std::isnan(folder.there_and_back("a.om", square(), {nan}).attributes.at(0).values[1]));
  const WriteReport report = write_mesh(folder / "a.glb", square(), {}, {nan});
  CHECK(report.reduced == Names{"property 'q': values that are not finite written as 0"});
  CHECK(read_mesh(folder / "a.glb").attributes.at(0).values == std::vector<float>{1, 0, 2, 0});
}

}  // namespace
}  // namespace whittle::files
