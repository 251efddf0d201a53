/// \file
/// Files appear whole or not at all, and nothing is left behind.
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "samples.hh"

namespace whittle::files {
namespace {

namespace fs = std::filesystem;

/// Root may write everywhere, so for a while be a user who may not.
class AsNobody {
 public:
  explicit AsNobody(const Folder& folder) : was_root_(::geteuid() == 0) {
    fs::permissions(folder.path(), fs::perms::all);
    if (was_root_) REQUIRE(::seteuid(65534) == 0);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;
  ~AsNobody() {
    if (was_root_ && ::seteuid(0) != 0) std::abort();
  }

 private:
  bool was_root_;
};

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  REQUIRE(::lstat(path.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

TEST_CASE("write_file: makes and replaces, and leaves only the file") {
  const Folder folder;
  write_file(folder / "a.json", "one");
  CHECK(folder.get("a.json") == "one");
  write_file(folder / "a.json", std::string("t\0o", 3));
  CHECK(folder.get("a.json") == std::string("t\0o", 3));
  write_file(folder / "empty", "");
  CHECK(fs::file_size(folder / "empty") == 0);
  write_file(folder / std::string(255, 'n'), "long");
  CHECK(folder.get(std::string(255, 'n')) == "long");
  CHECK(folder.entries() == 3);
}

TEST_CASE("write_file: a new file honours the umask, an old one keeps its bits") {
  const Folder folder;
  const mode_t before = ::umask(027);
  write_file(folder / "new", "x");
  ::umask(before);
  CHECK(mode_of(folder / "new") == 0640);
  REQUIRE(::chmod((folder / "new").c_str(), 0604) == 0);
  write_file(folder / "new", "y");
  CHECK(mode_of(folder / "new") == 0604);
}

TEST_CASE("write_file: an old file keeps its extended attributes, its access control list among them") {
  const Folder folder;
  folder.put("a", "old");
  const fs::path file = folder / "a";
  if (::setxattr(file.c_str(), "user.scanner", "7", 1, 0) != 0) return tests::skip("extended attributes");
  // Version 2; then tag, permissions and user each: owner rw, user 65534 r, group none, mask r, others none.
  const std::string list(
      "\2\0\0\0"
      "\1\0\6\0\xff\xff\xff\xff"
      "\2\0\4\0\xfe\xff\0\0"
      "\4\0\0\0\xff\xff\xff\xff"
      "\x10\0\4\0\xff\xff\xff\xff"
      "\x20\0\0\0\xff\xff\xff\xff",
      44);
  const char* const acl = "system.posix_acl_access";
  const bool has_lists = ::setxattr(file.c_str(), acl, list.data(), list.size(), 0) == 0;
  write_file(file, "new");
  CHECK(folder.get("a") == "new");
  std::string value(100, '\0');
  CHECK(::getxattr(file.c_str(), "user.scanner", value.data(), value.size()) == 1);
  CHECK(value[0] == '7');
  if (!has_lists) return;
  const ssize_t size = ::getxattr(file.c_str(), acl, value.data(), value.size());
  CHECK(value.substr(0, size > 0 ? static_cast<std::size_t>(size) : 0) == list);
  CHECK(mode_of(file) == 0640);
}

TEST_CASE("write_file: readers that hold the old file keep it") {
  const Folder folder;
  folder.put("a", "old");
  std::ifstream old(folder / "a");
  write_file(folder / "a", "new");
  std::string word;
  old >> word;
  CHECK(word == "old");
}

TEST_CASE("write_file: a link is followed, also to a file that is still to be made") {
  const Folder folder;
  fs::create_directory(folder / "sub");
  folder.put("sub/real", "old");
  fs::create_symlink("sub/real", folder / "link");
  fs::create_symlink("link", folder / "second");
  write_file(folder / "second", "new");
  CHECK(folder.get("sub/real") == "new");
  CHECK(fs::is_symlink(folder / "second"));
  CHECK(fs::is_symlink(folder / "link"));

  fs::create_symlink("sub/later", folder / "dangling");
  check_creatable(folder / "dangling");
  write_file(folder / "dangling", "made");
  CHECK(folder.get("sub/later") == "made");
  CHECK(fs::is_symlink(folder / "dangling"));

  fs::create_symlink("loop", folder / "loop");
  CHECK(folder.message([&] { write_file(folder / "loop", ""); }) ==
        "loop: Too many levels of symbolic links");
}

TEST_CASE("write_file: a device is written to, and its failure is told") {
  const Folder folder;
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(folder.message([] { write_file("/dev/full", "x"); }) == "/dev/full: No space left on device");
  fs::create_symlink("/dev/full", folder / "full.obj");
  CHECK(folder.message([&] { write_mesh(folder / "full.obj", strip<double>(3)); }) ==
        "full.obj: No space left on device");
  CHECK(fs::is_symlink(folder / "full.obj"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("write_file: what is open under /proc is appended to, not replaced") {
  const Folder folder;
  folder.put("out", "before ");
  std::FILE* out = std::fopen((folder / "out").c_str(), "a");
  REQUIRE(out != nullptr);
  write_file("/proc/self/fd/" + std::to_string(::fileno(out)), "json ");
  std::fputs("after", out);
  std::fclose(out);
  CHECK(folder.get("out") == "before json after");
}

/// Both the check and the write fail with this message, and nothing changes in the folder.
void check_refused(const Folder& folder, const std::string& name, const std::string& message) {
  const std::size_t entries = folder.entries();
  CHECK(folder.message([&] { check_creatable(folder / name); }) == message);
  CHECK(folder.message([&] { check_writable(folder / name); }) == message);
  CHECK(folder.message([&] { write_file(folder / name, "new"); }) == message);
  CHECK(folder.message([&] { write_mesh(folder / name, strip<double>(3)); }) == message);
  CHECK(folder.entries() == entries);
}

TEST_CASE("unwritable targets are refused before and when writing") {
  const Folder folder;
  folder.put("file", "x");
  fs::create_directory(folder / "folder.obj");
  check_refused(folder, "none/a.obj", "none/a.obj: its folder does not exist; make it first");
  check_refused(folder, "file/a.obj", "file/a.obj: Not a directory");
  check_refused(folder, "folder.obj", "folder.obj: Is a directory");
  const std::string long_name = std::string(300, 'n') + ".obj";
  check_refused(folder, long_name, long_name + ": File name too long");
  CHECK(folder.message([] { check_creatable(""); }) == ": No such file or directory");
}

TEST_CASE("read-only files and folders are refused, and the old file stays") {
  const Folder folder;
  folder.put("old.obj", "old");
  fs::create_directory(folder / "closed");
  folder.put("closed/old.obj", "old");
  REQUIRE(::chmod((folder / "old.obj").c_str(), 0444) == 0);
  REQUIRE(::chmod((folder / "closed/old.obj").c_str(), 0666) == 0);
  REQUIRE(::chmod((folder / "closed").c_str(), 0555) == 0);
  {
    const AsNobody nobody(folder);
    check_refused(folder, "old.obj", "old.obj: Permission denied");
    check_refused(folder, "closed/old.obj", "closed/old.obj: Permission denied");
    check_refused(folder, "closed/new.obj", "closed/new.obj: Permission denied");
    CHECK(folder.get("old.obj") == "old");
    CHECK(folder.get("closed/old.obj") == "old");
    write_file(folder / "new.obj", "new");
  }
  REQUIRE(::chmod((folder / "closed").c_str(), 0755) == 0);
  CHECK(folder.get("new.obj") == "new");
}

TEST_CASE("read_mesh: a file that may not be read") {
  const Folder folder;
  folder.put("a.obj", "v 0 0 0\n");
  REQUIRE(::chmod((folder / "a.obj").c_str(), 0) == 0);
  const AsNobody nobody(folder);
  CHECK(folder.message([&] { read_mesh(folder / "a.obj"); }) == "a.obj: Permission denied");
}

TEST_CASE("check_writable and check_creatable leave nothing behind") {
  const Folder folder;
  folder.put("old.ply", "old");
  check_writable(folder / "new.ply");
  check_writable(folder / "old.ply");
  check_creatable(folder / "new.json");
  CHECK(folder.get("old.ply") == "old");
  CHECK(folder.entries() == 1);
  CHECK(folder.message([&] { check_writable(folder / "new.json"); }) ==
        "new.json: unknown format '.json'; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  CHECK(folder.message([&] { check_writable(folder / "new"); }) ==
        "new: no extension; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
}

TEST_CASE("a path without a folder means the current one") {
  const Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const std::string error = folder.message([] {
    check_writable("a.off");
    write_mesh("a.off", strip<double>(3));
  });
  fs::current_path(before);
  CHECK(error.empty());
  CHECK(fs::exists(folder / "a.off"));
}

}  // namespace
}  // namespace whittle::files
