#include "batch/Items.hh"

#include <fstream>

#include "Folder.hh"
#include "catch.hh"

using namespace whittle::batch;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

void touch(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "";
}

}  // namespace

TEST_CASE("a folder gives its meshes and those of the folders in it, in order, without the results") {
  const scratch::Folder folder;
  const fs::path in = folder.path();
  for (const char* name : {"b.ply", "a.obj", "notes.txt", "deep/er/c.STL", "out/a.obj", "out/x.ply"})
    touch(in / name);
  const auto items = list_items(in, in / "out", "");
  REQUIRE(items.size() == 3);
  CHECK(items[0].in == in / "a.obj");
  CHECK(items[0].out == in / "out/a.obj");
  CHECK(items[1].in == in / "b.ply");
  CHECK(items[2].out == in / "out/deep/er/c.STL");
  CHECK(items[2].name == "deep%2Fer%2Fc.STL");
  CHECK(list_items(in, in / "out", "glb")[0].out == in / "out/a.glb");
}

TEST_CASE("glTF, which is only read, becomes GLB") {
  const scratch::Folder folder;
  touch(folder.path() / "a.gltf");
  const auto items = list_items(folder.path(), "out", "");
  REQUIRE(items.size() == 1);
  CHECK(items[0].out == "out/a.glb");
}

TEST_CASE("a manifest names meshes relative to itself") {
  const scratch::Folder folder;
  const fs::path list = folder.path() / "list.txt";
  std::ofstream(list) << "# two of them\n\nscans/a.ply  \n/data/b.obj\n";
  const auto items = list_items(list, "out", "");
  REQUIRE(items.size() == 2);
  CHECK(items[0].in == folder.path() / "scans/a.ply");
  CHECK(items[0].out == "out/a.ply");
  CHECK(items[1].in == "/data/b.obj");
}

TEST_CASE("a bad folder or manifest is refused in one line that names it") {
  const scratch::Folder folder;
  const auto why = [&](const fs::path& source, const std::string& format) -> std::string {
    try {
      list_items(source, "out", format);
    } catch (const BatchError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(why(folder.path() / "missing", ""), Contains("missing: there is no such file"));
  std::ofstream(folder.path() / "list") << "a.ply\nb.txt\n";
  CHECK_THAT(why(folder.path() / "list", ""), Contains("list:2: not the name of a mesh file"));
  std::ofstream(folder.path() / "twice") << "x/a.ply\ny/a.ply\n";
  CHECK_THAT(why(folder.path() / "twice", ""), Contains("would both become"));
  touch(folder.path() / "in/a.ply");
  touch(folder.path() / "in/a.obj");
  CHECK_THAT(why(folder.path() / "in", "glb"), Contains("would both become"));
  CHECK(why(folder.path() / "in", "").empty());
}
