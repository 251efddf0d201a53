#include "batch/Items.hh"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "Folder.hh"
#include "catch.hh"

using namespace whittle::batch;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::vector<Item> items_of(const fs::path& source, const fs::path& out, const std::string& format) {
  const Listing listing = list_items(source, out, format);
  CHECK(listing.problems.empty());
  return listing.items;
}

void touch(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "";
}

}  // namespace

TEST_CASE("a folder gives its meshes and those of the folders in it, in order, without the results") {
  const scratch::Folder folder;
  const fs::path in = folder.path();
  for (const char* name : {"b.ply", "a.obj", "notes.txt", "deep/er/c.STL", "out/a.obj", "out/x.ply",
                           "out/.whittle/claims/y.ply", ".whittle/claims/z.ply"})
    touch(in / name);
  const auto items = items_of(in, in / "out", "");
  REQUIRE(items.size() == 3);
  CHECK(items[0].in == in / "a.obj");
  CHECK(items[0].out == in / "out/a.obj");
  CHECK(items[1].in == in / "b.ply");
  CHECK(items[2].out == in / "out/deep/er/c.STL");
  CHECK(items[2].name == "deep%2Fer%2Fc.STL");
  CHECK(items_of(in, in / "out", "glb")[0].out == in / "out/a.glb");
}

TEST_CASE("a .gltf stays one") {
  const scratch::Folder folder;
  touch(folder.path() / "a.gltf");
  const auto items = items_of(folder.path(), "out", "");
  REQUIRE(items.size() == 1);
  CHECK(items[0].out == "out/a.gltf");
}

TEST_CASE("a manifest names meshes relative to itself") {
  const scratch::Folder folder;
  const fs::path list = folder.path() / "list.txt";
  std::ofstream(list) << "# two of them\n\nscans/a.ply  \n/data/b.obj\n";
  const auto items = items_of(list, "out", "");
  REQUIRE(items.size() == 2);
  CHECK(items[0].in == folder.path() / "scans/a.ply");
  CHECK(items[0].out == "out/a.ply");
  CHECK(items[1].in == "/data/b.obj");
}

TEST_CASE("a manifest may begin with a byte-order mark and end its lines as others do") {
  const scratch::Folder folder;
  std::ofstream(folder.path() / "list") << "\xEF\xBB\xBF"
                                           "a.ply\r\nb.ply";
  const auto items = items_of(folder.path() / "list", "out", "");
  REQUIRE(items.size() == 2);
  CHECK(items[0].in == folder.path() / "a.ply");
  CHECK(items[1].in == folder.path() / "b.ply");
}

TEST_CASE("results may go into the folder that holds the source, or that of the source itself") {
  const scratch::Folder folder;
  const fs::path in = folder.path() / "scans";
  touch(in / "a.ply");
  touch(in / ".whittle/claims/a.ply");
  CHECK(items_of(in, folder.path(), "").size() == 1);
  CHECK(items_of(in, folder.path() / "scans/..", "").size() == 1);
  CHECK(items_of(in, in, "").size() == 1);
  CHECK(items_of(in, in / ".", "").size() == 1);
}

TEST_CASE("folders nested deeper than files may be open are listed whole") {
  const scratch::Folder folder;
  fs::path deep = folder.path() / "in";
  for (int i = 0; i < 40; ++i) touch((deep /= "d") / "a.ply");
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  rlimit few = before;
  few.rlim_cur = 16;
  REQUIRE(setrlimit(RLIMIT_NOFILE, &few) == 0);
  const Listing listing = list_items(folder.path() / "in", folder.path() / "out", "");
  setrlimit(RLIMIT_NOFILE, &before);
  CHECK(listing.problems.empty());
  CHECK(listing.items.size() == 40);
}

TEST_CASE("a folder that cannot be listed is told, and the others are listed") {
  const scratch::Folder folder;
  touch(folder.path() / "in/closed/a.ply");
  touch(folder.path() / "in/open/b.ply");
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(folder.path() / "in/closed", fs::perms::none);
  const bool is_root = geteuid() == 0;
  if (is_root) REQUIRE(seteuid(65534) == 0);
  const Listing listing = list_items(folder.path() / "in", folder.path() / "out", "");
  if (is_root) REQUIRE(seteuid(0) == 0);
  fs::permissions(folder.path() / "in/closed", fs::perms::all);
  CHECK(listing.items.size() == 1);
  REQUIRE(listing.problems.size() == 1);
  CHECK_THAT(listing.problems[0], Contains("in/closed: cannot be listed: Permission denied"));
}

TEST_CASE("a link that leads nowhere is a mesh that will fail, a pipe in a folder is none") {
  const scratch::Folder folder;
  touch(folder.path() / "in/a.ply");
  fs::create_symlink("gone.ply", folder.path() / "in/b.ply");
  REQUIRE(mkfifo((folder.path() / "in/c.ply").c_str(), 0600) == 0);
  const auto items = items_of(folder.path() / "in", folder.path() / "out", "");
  REQUIRE(items.size() == 2);
  CHECK(items[1].in == folder.path() / "in/b.ply");
}

TEST_CASE("the name of a long path fits into a file's name and differs from others") {
  const scratch::Folder folder;
  const std::string part(100, 'n');
  for (const char* name : {"a.ply", "b.ply"}) touch(folder.path() / "in" / part / part / part / name);
  const auto items = items_of(folder.path() / "in", folder.path() / "out", "");
  REQUIRE(items.size() == 2);
  CHECK(items[0].name != items[1].name);
  CHECK(items[0].name.size() <= 120);
}

TEST_CASE("a result that would replace another input is refused, one that replaces its own is not") {
  const scratch::Folder folder;
  const fs::path at = folder.path();
  touch(at / "in/a.ply");
  touch(at / "in/in/a.ply");
  CHECK_THROWS_WITH(list_items(at / "in", at, ""), Contains("would replace the input"));
  fs::create_symlink("a.ply", at / "in/in/link.ply");
  CHECK_THROWS_WITH(list_items(at / "in/in", at / "in/in", ""), Contains("would replace the input"));
  fs::remove(at / "in/in/link.ply");
  CHECK(items_of(at / "in/in", at / "in/in", "").size() == 1);
}

TEST_CASE("results whose names differ in case only are refused where that makes one file of them") {
  const scratch::Folder folder;
  const fs::path in = folder.path() / "in";
  for (const char* name : {"a.ply", "A.ply", "b.ply"}) touch(in / name);
  CHECK_THROWS_WITH(list_items(in, folder.path() / "out", "", [](fs::path) { return false; }),
                    Contains("in/a.ply and") && Contains("out/a.ply, as case does not count"));
  CHECK(list_items(in, folder.path() / "out", "", [](fs::path) { return true; }).items.size() == 3);
  fs::remove(in / "A.ply");
  CHECK(list_items(in, folder.path() / "out", "", [](fs::path) { return false; }).items.size() == 2);
}

TEST_CASE("whether case counts is found out in the nearest folder, which is left as it was") {
  const scratch::Folder folder;
  touch(folder.path() / "seen.ply");
  CHECK(case_counts_in(folder.path() / "to/be/made") == !fs::exists(folder.path() / "SEEN.ply"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
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
  CHECK_THAT(why(folder.path() / "missing", ""),
             Contains("missing: there is no folder of this name, nor a list of meshes"));
  CHECK_THAT(why(folder.path() / "*.obj", ""), Contains("a pattern is not one: name the folder"));
  std::ofstream(folder.path() / "list") << "a.ply\nb.txt\n";
  CHECK_THAT(why(folder.path() / "list", ""), Contains("list:2: not the name of a mesh file"));
  std::ofstream(folder.path() / "twice") << "x/a.ply\ny/a.ply\n";
  CHECK_THAT(why(folder.path() / "twice", ""), Contains("would both become"));
  touch(folder.path() / "in/a.ply");
  touch(folder.path() / "in/a.obj");
  CHECK_THAT(why(folder.path() / "in/a.ply", ""), Contains("is a mesh; batch takes a folder"));
  CHECK(why(folder.path() / "in", "").empty());
}

TEST_CASE("results that would be called the same keep the extensions of their inputs in their names") {
  const scratch::Folder folder;
  const fs::path in = folder.path() / "in";
  for (const char* name : {"a.ply.gz", "a.obj", "a.OFF", "b.obj"}) touch(in / name);
  std::vector<fs::path> names;
  for (const Item& item : list_items(in, "out", "stl").items) names.push_back(item.out);
  std::sort(names.begin(), names.end());
  CHECK(names == std::vector<fs::path>{"out/a.obj.stl", "out/a.off.stl", "out/a.ply.stl", "out/b.stl"});
}
