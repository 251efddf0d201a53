/// \file
/// Writing that does not come to its end: killed, or without room.
#include <fcntl.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include "samples.hh"

namespace whittle::files {
namespace {

/// Runs an action in a process of its own that ends without cleaning up.
/// \return its process id
pid_t start(const std::function<void()>& action) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child > 0) return child;
  try {
    action();
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

/// \return true if the process ended by itself and well
bool wait_for(pid_t child) {
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool can_write_without_name(const Folder& folder) {
  const int file = ::open(folder.path().c_str(), O_WRONLY | O_TMPFILE, 0600);
  if (file >= 0) ::close(file);
  return file >= 0;
}

TEST_CASE("a process that is killed while it writes leaves the old file or the new one, and nothing else") {
  const Folder folder;
  const std::string old(100000, 'o'), fresh(20000000, 'n');
  for (int round = 0; round < 20; ++round) {
    folder.put("a", old);
    const pid_t child = start([&] { write_file(folder / "a", fresh); });
    std::this_thread::sleep_for(std::chrono::milliseconds(round));
    REQUIRE(::kill(child, SIGKILL) == 0);
    wait_for(child);
    const std::string left = folder.get("a");
    CHECK((left == old || left == fresh));
    // A name is given at the very end; before that, nothing of a killed process stays where the file system
    // can do without.
    if (can_write_without_name(folder)) CHECK(folder.entries() <= 2);
  }
}

TEST_CASE("a process that is killed in the middle of writing leaves no file of its own") {
  const Folder folder;
  if (!can_write_without_name(folder)) return;
  folder.put("a", "old");
  // So much that it cannot be done before it is killed: the limit stops it after the first part.
  const pid_t child = start([&] {
    const rlimit limit{1 << 20, 1 << 20};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_DFL);  // which kills
    write_file(folder / "a", std::string(4 << 20, 'n'));
  });
  CHECK_FALSE(wait_for(child));
  CHECK(folder.get("a") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a file that may not grow: the old one stays and the failure is told") {
  const Folder folder;
  folder.put("a.obj", "old");
  const pid_t child = start([&] {
    const rlimit limit{1 << 16, 1 << 16};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
    const std::string message = folder.message([&] { write_mesh(folder / "a.obj", strip<double>(100000)); });
    if (message != "a.obj: File too large") std::abort();
  });
  CHECK(wait_for(child));
  CHECK(folder.get("a.obj") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a full disk: the old file stays and the failure is told") {
  const Folder folder;
  const std::filesystem::path disk = folder / "disk";
  std::filesystem::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=256k") != 0) return;  // may not be mounted here
  struct Unmount {
    const std::filesystem::path& disk;
    ~Unmount() { ::umount2(disk.c_str(), MNT_DETACH); }
  } unmount{disk};
  write_mesh(disk / "a.ply", strip<double>(100));
  const std::string old = folder.get("disk/a.ply");
  CHECK(folder.message([&] { write_mesh(disk / "a.ply", strip<double>(100000)); }) ==
        "disk/a.ply: No space left on device");
  CHECK(folder.get("disk/a.ply") == old);
  CHECK(std::distance(std::filesystem::directory_iterator(disk), {}) == 1);
  write_mesh(disk / "a.ply", strip<double>(200));
  CHECK(read_mesh(disk / "a.ply").mesh.points.size() == 200);
}

}  // namespace
}  // namespace whittle::files
