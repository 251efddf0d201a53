/// \file
/// OFF's variants.
#include "samples.hh"

namespace whittle::files {
namespace {

/// A triangle whose vertices have the same numbers behind their coordinates.
std::string triangle(const std::string& header, const std::string& behind) {
  std::string text = header + "\n3 1 0\n";
  for (const char* place : {"0 0 0", "1 0 0", "0 1 0"}) text += place + (" " + behind) + "\n";
  return text + "3 0 1 2\n";
}

TEST_CASE("OFF: every combination of normals, colours and texture coordinates") {
  const Folder folder;
  for (const bool texture : {false, true}) {
    for (const bool colour : {false, true}) {
      for (const bool normal : {false, true}) {
        const std::string header =
            std::string(texture ? "ST" : "") + (colour ? "C" : "") + (normal ? "N" : "") + "OFF # comment";
        INFO(header);
        const MeshFile file = folder.read(
            "a.off", triangle(header, std::string(normal ? "0 0.6 0.8 " : "") +
                                          (colour ? "0.1 0.2 0.3 0.4 " : "") + (texture ? "0.5 0.25" : "")));
        CHECK(file.report.notes().empty());
        CHECK(file.attributes.size() == std::size_t{texture} + colour + normal);
        if (normal)
          CHECK(find(file.attributes, Kind::normal).values ==
                std::vector<float>{0, 0.6F, 0.8F, 0, 0.6F, 0.8F, 0, 0.6F, 0.8F});
        if (colour) {
          const Attribute& found = find(file.attributes, Kind::colour);
          CHECK(found.components == 4);
          CHECK_FALSE(found.bytes);
          CHECK(found.values[3] == 0.4F);
        }
        if (texture) {
          const Attribute& found = find(file.attributes, Kind::texture);
          CHECK(found.values == std::vector<float>{0.5F, 0.25F, 0.5F, 0.25F, 0.5F, 0.25F});
          CHECK_FALSE(found.downwards);
        }
      }
    }
  }
}

TEST_CASE("OFF: colours of whole numbers are bytes, with a point they are not") {
  const Folder folder;
  const auto colour = [&](const std::string& numbers) {
    return folder.read("a.off", triangle("COFF", numbers)).attributes.at(0);
  };
  CHECK(colour("255 0 51").bytes);
  CHECK(colour("255 0 51").values[2] == 0.2F);
  CHECK(colour("255 0 51").components == 3);
  CHECK(colour("300 -1 0 0").values[0] == 1);
  CHECK(colour("300 -1 0 0").values[1] == 0);
  CHECK(colour("0 0 0").bytes);
  CHECK_FALSE(colour("1.0 0 0").bytes);
  CHECK_FALSE(colour("1 0 1 1").bytes);  // 0..1 after all
  CHECK(colour("1 0 1 1").values[0] == 1);
}

TEST_CASE("OFF: what the header does not name is noted") {
  const Folder folder;
  const auto ignored = [&](const std::string& text) { return folder.read("a.off", text).report.ignored; };
  CHECK(ignored(triangle("OFF", "9 9 9 9")) == Names{"vertex attributes"});
  CHECK(ignored(triangle("NOFF", "0 0 1 9")) == Names{"vertex attributes"});
  CHECK(ignored(triangle("STOFF", "0 0 1")) == Names{"vertex attributes"});
  CHECK(ignored("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n") == Names{"face colours"});
}

TEST_CASE("OFF: errors in attributes name the line") {
  const Folder folder;
  const auto error = [&](const std::string& text) { return folder.error("a.off", text); };
  CHECK(error(triangle("NOFF", "0 1")) == "a.off:3: expected a number, found the end of the line");
  CHECK(error(triangle("STOFF", "")) == "a.off:3: expected a number, found the end of the line");
  CHECK(error(triangle("COFF", "1 2")) == "a.off:3: a colour has 2 numbers instead of 3 or 4");
  CHECK(error(triangle("STCOFF", "1")) == "a.off:3: a colour has 0 numbers instead of 3 or 4");
  CHECK(error(triangle("COFF", "1 2 3 4 5 6 7 8 9 10")) ==
        "a.off:3: a colour has 10 numbers instead of 3 or 4");
  CHECK(error("COFF\n2 0 0\n0 0 0 1 2 3\n0 0 0 1 2 3 4\n") == "a.off:4: a colour has 4 numbers instead of 3");
  CHECK(error(triangle("COFF", "a b c")) == "a.off:3: expected a number, found 'a'");
  CHECK(error("COFF BINARY\n") == "a.off:1: binary OFF is not supported");
  CHECK(error("STCN4OFF\n1 0 0\n0 0 0 0\n") ==
        "a.off:1: OFF with other than three coordinates is not supported");
}

TEST_CASE("OFF: attributes as written") {
  const Folder folder;
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}};
  Attribute colour = attribute(Kind::colour, 4, {0, 0.5F, 1, 0.2F});
  const Attribute normal = attribute(Kind::normal, 3, {0, 0, 1});
  const Attribute texture = attribute(Kind::texture, 2, {0.5F, 1});
  write_mesh(folder / "a.off", mesh, {}, {colour, normal, texture});
  CHECK(folder.get("a.off") == "STCNOFF\n1 0 0\n0 0 0 0 0 1 0.0 0.5 1.0 0.2 0.5 1\n");
  colour.bytes = true;
  write_mesh(folder / "a.off", mesh, {}, {colour});
  CHECK(folder.get("a.off") == "COFF\n1 0 0\n0 0 0 0 128 255 51\n");
}

}  // namespace
}  // namespace whittle::files
