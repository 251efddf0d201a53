/// \file
/// The files of one run appear together, or none does, and none of them replaces what is read.
#include "files/Outputs.hh"

#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <locale>

#include "samples.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

TEST_CASE("outputs: they appear together when all are written") {
  const Folder folder;
  folder.put("old", "old");
  Outputs outputs;
  outputs.add("OUT", folder / "old");
  outputs.add("--json", folder / "new");
  outputs.add("--map", "");  // not asked for
  CHECK(outputs.has("OUT"));
  CHECK_FALSE(outputs.has("--map"));
  outputs.write("OUT", "one");
  outputs.write("--json", "two");
  outputs.write("--map", "three");
  CHECK(folder.get("old") == "old");
  CHECK_FALSE(fs::exists(folder / "new"));
  outputs.commit();
  CHECK(folder.get("old") == "one");
  CHECK(folder.get("new") == "two");
  CHECK(folder.entries() == 2);
}

TEST_CASE("outputs: without a commit nothing is left") {
  const Folder folder;
  {
    Outputs outputs;
    outputs.add("OUT", folder / "a");
    outputs.add("--json", folder / "b");
    outputs.write("OUT", "one");
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("outputs: a stream that fails keeps all files away") {
  const Folder folder;
  folder.put("old", "old");
  Outputs outputs;
  outputs.add("OUT", folder / "old");
  outputs.add("--json", folder / "new");
  outputs.add("--map", "/dev/full");
  for (const char* role : {"OUT", "--json", "--map"}) outputs.write(role, "x");
  CHECK(folder.message([&] { outputs.commit(); }) == "/dev/full: No space left on device");
  CHECK(folder.get("old") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("outputs: a file that cannot take its place takes those back that have") {
  const Folder folder;
  for (const char* name : {"old", "held", "other"}) folder.put(name, name);
  // A file that something is mounted on cannot be renamed over.
  if (::mount((folder / "other").c_str(), (folder / "held").c_str(), nullptr, MS_BIND, nullptr) != 0)
    return tests::skip("nothing may be mounted here");
  struct Unmount {
    const fs::path path;
    ~Unmount() { ::umount2(path.c_str(), MNT_DETACH); }
  };
  {
    const Unmount unmount{folder / "held"};
    for (const bool is_last : {false, true}) {
      Outputs outputs;
      if (!is_last) outputs.add("held", folder / "held");
      outputs.add("old", folder / "old");
      outputs.add("new", folder / "new");
      if (is_last) outputs.add("held", folder / "held");
      for (const char* role : {"held", "old", "new"}) outputs.write(role, "fresh");
      CHECK(folder.message([&] { outputs.commit(); }) == "held: Device or resource busy");
      CHECK(folder.get("old") == "old");
      CHECK(folder.entries() == 3);
    }
  }
  CHECK(folder.get("held") == "held");
}

/// What is said where an output, "A", meets an input or another output, "B".
std::string clash(const Folder& folder, const fs::path& a, const fs::path& b, bool is_input) {
  return folder.message([&] {
    Outputs outputs;
    if (is_input)
      outputs.reads("B", b);
    else
      outputs.add("B", b);
    outputs.add("A", a);
  });
}

TEST_CASE("outputs: two that lead to one file, or one to an input, are refused, whatever they are called") {
  const Folder folder;
  folder.put("a", "");
  folder.put("c", "");
  fs::create_directory(folder / "sub");
  fs::create_symlink("a", folder / "link");
  fs::create_symlink("new", folder / "dangling");
  fs::create_hard_link(folder / "a", folder / "hard");
  for (const char* name : {"a", "link", "hard", "sub/../a"}) {
    INFO(name);
    CHECK(clash(folder, folder / name, folder / "a", false) ==
          "B and A would both be written to " + (folder / "a").string());
    CHECK(clash(folder, folder / name, folder / "a", true) ==
          "A would overwrite B: " + (folder / "a").string());
  }
  for (const char* name : {"new", "NEW", "dangling", "sub/../new"}) {
    INFO(name);
    CHECK_FALSE(clash(folder, folder / name, folder / "new", false).empty());
  }
  for (const char* name : {"c", "A", "new", "sub/a"}) {
    INFO(name);
    CHECK(clash(folder, folder / name, folder / "a", false).empty());
    CHECK(clash(folder, folder / name, folder / "a", true).empty());
  }
  CHECK(clash(folder, folder / "a", folder / "missing", true).empty());
  CHECK(clash(folder, "/dev/null", "/dev/null", false).empty());
  CHECK(clash(folder, "-", "-", false) == "B and A would both be written to standard output");
  CHECK_FALSE(clash(folder, "-", "/dev/stdout", false).empty());
}

TEST_CASE("outputs: an output may replace the input that is named, and no other") {
  const Folder folder;
  folder.put("a", "old");
  Outputs outputs;
  outputs.reads("IN", folder / "a");
  outputs.add("OUT", folder / "a", "IN");
  outputs.write("OUT", "new");
  outputs.commit();
  CHECK(folder.get("a") == "new");
  Outputs others;
  others.reads("--lock", folder / "a");
  CHECK_FALSE(folder.message([&] { others.add("OUT", folder / "a", "IN"); }).empty());
}

TEST_CASE("outputs: one that cannot be written is refused when it is added") {
  const Folder folder;
  Outputs outputs;
  CHECK(folder.message([&] { outputs.add("OUT", folder / "none/a"); }) ==
        "none/a: its folder does not exist; make it first");
}

TEST_CASE("write_file: a replaced file keeps its owner and its bits where that is allowed") {
  const Folder folder;
  folder.put("a", "old");
  if (::chown((folder / "a").c_str(), 65534, 65533) != 0) return tests::skip("only root gives files away");
  REQUIRE(::chmod((folder / "a").c_str(), 0640) == 0);
  const auto check = [&] {
    struct stat status {};
    REQUIRE(::stat((folder / "a").c_str(), &status) == 0);
    CHECK(status.st_uid == 65534);
    CHECK(status.st_gid == 65533);
    CHECK((status.st_mode & 07777) == 0640);
  };
  write_file(folder / "a", "new");
  check();
  folder.put("b", "moved");
  move_file(folder / "b", folder / "a");
  check();
  CHECK(folder.get("a") == "moved");
  CHECK(folder.entries() == 1);
}

TEST_CASE("write_file: a file of another user in a folder such as /tmp is refused before it is written") {
  const Folder folder;
  folder.put("a", "old");
  if (::geteuid() != 0) return tests::skip("only root gives files away");
  REQUIRE(::chmod((folder / "a").c_str(), 0666) == 0);
  REQUIRE(::chmod(folder.path().c_str(), 01777) == 0);
  REQUIRE(::seteuid(65534) == 0);
  const std::string message = folder.message([&] { check_creatable(folder / "a"); });
  const std::string own = folder.message([&] { write_file(folder / "b", "new"); });
  const std::string again = folder.message([&] { write_file(folder / "b", "newer"); });
  REQUIRE(::seteuid(0) == 0);
  CHECK(message == "a: Operation not permitted");
  CHECK(own.empty());
  CHECK(again.empty());
}

TEST_CASE("move_file: over a link, to another file system, and to a device") {
  const Folder folder;
  folder.put("real", "old");
  fs::create_symlink("real", folder / "link");
  folder.put("a", "one");
  move_file(folder / "a", folder / "link");
  CHECK(folder.get("real") == "one");
  CHECK(fs::is_symlink(folder / "link"));
  folder.put("a", "two");
  CHECK(folder.message([&] { move_file(folder / "a", "/dev/full"); }) ==
        "/dev/full: No space left on device");
  CHECK(folder.get("a") == "two");
  fs::create_directory(folder / "disk");
  if (::mount("tmpfs", (folder / "disk").c_str(), "tmpfs", 0, "size=256k") != 0)
    return tests::skip("nothing may be mounted here");
  move_file(folder / "a", folder / "disk/a");
  const std::string moved = folder.get("disk/a");
  ::umount2((folder / "disk").c_str(), MNT_DETACH);
  CHECK(moved == "two");
  CHECK_FALSE(fs::exists(folder / "a"));
}

TEST_CASE("read_file: a device without an end is refused") {
  const Folder folder;
  folder.put("a", "bytes");
  folder.put("empty", "");
  CHECK(read_file(folder / "a") == "bytes");
  CHECK(read_file(folder / "empty").empty());
  CHECK(folder.message([] { read_file("/dev/zero"); }) == "/dev/zero: neither a file nor a pipe");
  CHECK(folder.message([&] { read_file(folder / "none"); }) == "none: No such file or directory");
}

/// Numbers with a decimal comma.
class Comma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("files are the same in a locale with a decimal comma") {
  const Folder folder;
  IndexedMesh mesh = square();
  for (auto& point : mesh.points) point += IndexedMesh::Point(1234.5, 0.125, -7654.25);
  const WriteOptions text{true, false, {}};
  const auto write_all_formats = [&](const std::string& stem) {
    for (const char* extension : {".obj", ".ply", ".off", ".stl", ".om", ".glb"})
      write_mesh(folder / (stem + extension), mesh, text);
  };
  write_all_formats("plain");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  // Where the machine has one, C's functions follow it too.
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  write_all_formats("comma");
  std::vector<IndexedMesh> read;
  for (const char* extension : {".obj", ".ply", ".off", ".stl", ".om", ".glb"})
    read.push_back(read_mesh(folder / (std::string("comma") + extension)).mesh);
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  std::size_t i = 0;
  for (const char* extension : {".obj", ".ply", ".off", ".stl", ".om", ".glb"}) {
    INFO(extension);
    CHECK(folder.get(std::string("comma") + extension) == folder.get(std::string("plain") + extension));
    CHECK(same_bits<float>(read[i++], read_mesh(folder / (std::string("plain") + extension)).mesh));
  }
}

}  // namespace
}  // namespace whittle::files
