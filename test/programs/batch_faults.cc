/// \file
/// What a batch does when something is wrong with one mesh, with its folders, or with a batch before it.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "TorusFile.hh"
#include "batch/Claim.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::Folder;
using programs::whittle_program;
namespace fs = std::filesystem;

namespace {

const IndexedMesh& small() {
  static const IndexedMesh mesh = meshes::torus(8, 5);  // 80 faces
  return mesh;
}

std::size_t faces(const fs::path& file) {
  return files::read_mesh(file).mesh.triangles.size();
}

struct Batch {
  void put(const fs::path& name) const {
    fs::create_directories((at() / name).parent_path());
    files::write_mesh(at() / name, small());
  }
  fs::path at() const { return folder.path(); }
  programs::Outcome run(const std::string& source, const std::string& out,
                        std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"batch", folder / source, "--out", folder / out, "--ratio", "0.5"};
    words.insert(words.end(), more.begin(), more.end());
    return whittle_program(words);
  }
  Folder folder;
};

/// Starts the program on a mesh that never comes: a pipe without a writer.
pid_t start_on_pipe(const Batch& batch) {
  REQUIRE(::mkfifo((batch.at() / "never.ply").c_str(), 0600) == 0);
  std::ofstream(batch.at() / "list.txt") << "never.ply\n";
  const std::string list = batch.folder / "list.txt", out = batch.folder / "out";
  const pid_t process = ::fork();
  REQUIRE(process >= 0);
  if (process == 0) {
    ::execl(WHITTLE_PROGRAM, "whittle", "batch", list.c_str(), "--out", out.c_str(), "--ratio", "0.5",
            "--quiet", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  return process;
}

/// The writing end of a pipe, once there is a reader. As long as it is open, the reader waits for more.
int open_writer(const fs::path& pipe) {
  return ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
}

bool has_reader(int writer) {
  pollfd end{writer, 0, 0};
  ::poll(&end, 1, 0);
  return (end.revents & POLLERR) == 0;
}

/// Waits until it is so, at most half a minute.
template <typename Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 3000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

TEST_CASE("batch goes on after a mesh whose folder, name or record makes trouble") {
  const Batch batch;
  const std::string part(100, 'n');
  const fs::path deep = fs::path(part) / part / part / "deep.ply";
  for (const fs::path& name :
       {fs::path("in/a.ply"), fs::path("in/file/b.ply"), "in" / deep, fs::path("in/z.ply")})
    batch.put(name);
  fs::create_directories(batch.at() / "out/.whittle/done");
  std::ofstream(batch.at() / "out/file") << "";  // where a folder should be
  std::ofstream(batch.at() / "out/.whittle/done/a.ply.json") << "{\"arguments\": 7, \"result\": []}";
  fs::create_directories(batch.at() / "out/.whittle/done/z.ply.json");  // no room for its record
  const auto done = batch.run("in", "out", {"--resume"});
  INFO(done.out << done.err);
  CHECK(done.code == 1);
  CHECK_THAT(done.out, Contains("2 done;") && Contains("2 failed;"));
  CHECK_THAT(done.err, Contains("file/b.ply: failed") && Contains("z.ply: failed"));
  CHECK(faces(batch.at() / "out/a.ply") == 40);
  CHECK(faces(batch.at() / "out" / deep) == 40);
  CHECK_FALSE(fs::exists(batch.at() / "out/z.ply"));
  CHECK(fs::is_empty(batch.at() / "out/.whittle/work"));
  CHECK(fs::is_empty(batch.at() / "out/.whittle/claims"));
  CHECK_THAT(batch.run("in", "out", {"--resume"}).out, Contains("2 done before;"));
}

TEST_CASE("batch takes names that begin with a minus") {
  const Batch batch;
  batch.put("-a.ply");
  std::ofstream(batch.at() / "list.txt") << "-a.ply\n";
  std::ofstream(batch.at() / "run.sh")
      << "cd '" << batch.at().string()
      << "' && exec '" WHITTLE_PROGRAM "' batch list.txt --out=-out --ratio 0.5\n";
  const auto done = programs::run("/bin/bash", {batch.folder / "run.sh"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK(faces(batch.at() / "-out/-a.ply") == 40);
}

TEST_CASE("batch resumes by the input's path and the contents of a selection, too") {
  const Batch batch;
  batch.put("one/a.ply");
  std::ofstream(batch.at() / "keep.txt") << "0\n";
  const std::vector<std::string> more{"--resume", "--lock", "selection:" + batch.folder / "keep.txt"};
  CHECK_THAT(batch.run("one", "out", more).out, Contains("1 done;"));
  CHECK_THAT(batch.run("one", "out", more).out, Contains("1 done before;"));
  std::ofstream(batch.at() / "keep.txt") << "1\n";
  CHECK_THAT(batch.run("one", "out", more).out, Contains("1 done;"));
  fs::create_directory(batch.at() / "two");
  fs::copy(batch.at() / "one/a.ply", batch.at() / "two");
  fs::last_write_time(batch.at() / "two/a.ply", fs::last_write_time(batch.at() / "one/a.ply"));
  CHECK_THAT(batch.run("two", "out", more).out, Contains("1 done;"));
  CHECK_THAT(batch.run("two", "out", more).out, Contains("1 done before;"));
}

TEST_CASE(
    "batch in place decimates each mesh once, whenever it was stopped and whatever became of the times") {
  const Batch batch;
  batch.put("in/a.ply");
  const std::string original = programs::contents(batch.at() / "in/a.ply");
  CHECK_THAT(batch.run("in", "in", {"--resume"}).out, Contains("1 done;"));
  CHECK(faces(batch.at() / "in/a.ply") == 40);
  // As a copy to another machine leaves it.
  fs::last_write_time(batch.at() / "in/a.ply", fs::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK_THAT(batch.run("in", "in", {"--resume"}).out, Contains("1 done before;"));
  CHECK(faces(batch.at() / "in/a.ply") == 40);
  // Stopped between the record and the result: it has to be done.
  std::ofstream(batch.at() / "in/a.ply", std::ios::binary) << original;
  CHECK_THAT(batch.run("in", "in", {"--resume"}).out, Contains("1 done;"));
  CHECK(faces(batch.at() / "in/a.ply") == 40);
}

TEST_CASE("batch leaves a mesh to another process that lives, and takes that of a dead one") {
  const Batch batch;
  batch.put("in/a.ply");
  fs::create_directories(batch.at() / "out/.whittle/claims");
  {
    const auto claim = batch::Bid(batch.at() / "out/.whittle/claims/a.ply").take();
    REQUIRE(claim);
    const auto done = batch.run("in", "out", {"--resume"});
    CHECK(done.code == 0);
    CHECK_THAT(done.out, Contains("1 in work elsewhere;"));
    CHECK_FALSE(fs::exists(batch.at() / "out/a.ply"));
  }
  const auto claim_and_die = [&] {
    const pid_t process = ::fork();
    REQUIRE(process >= 0);
    if (process == 0) {
      const auto claim = batch::Bid(batch.at() / "out/.whittle/claims/a.ply").take();
      ::_exit(claim ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(process, &status, 0) == process);
    REQUIRE(status == 0);
  };
  claim_and_die();
  CHECK_THAT(batch.run("in", "out", {"--resume"}).out, Contains("1 done;"));
  claim_and_die();  // between the result and the end of the claim
  CHECK_THAT(batch.run("in", "out", {"--resume"}).out, Contains("1 done before;"));
  CHECK(fs::is_empty(batch.at() / "out/.whittle/claims"));
}

TEST_CASE("a batch that is hung up or killed leaves no child, and one that is hung up no claim") {
  for (const int signal : {SIGHUP, SIGKILL}) {
    const Batch batch;
    const pid_t process = start_on_pipe(batch);
    int writer = -1;
    CHECK(comes_true([&] { return (writer = open_writer(batch.at() / "never.ply")) >= 0; }));
    REQUIRE(::kill(process, signal) == 0);
    int status = 0;
    REQUIRE(::waitpid(process, &status, 0) == process);
    CHECK(comes_true([&] { return !has_reader(writer); }));
    ::close(writer);
    if (signal == SIGHUP) {
      CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 1));
      CHECK(fs::is_empty(batch.at() / "out/.whittle/claims"));
    }
  }
}

TEST_CASE("batch says which folder it could not list, and ends with 1") {
  if (::geteuid() == 0) {
    // Root may list every folder, but not one whose path is longer than paths can be.
    const Batch batch;
    batch.put("in/a.ply");
    const std::string part(250, 'n');
    int at = ::open((batch.folder / "in").c_str(), O_RDONLY | O_DIRECTORY);
    for (int i = 0; i < 18; ++i) {
      REQUIRE(::mkdirat(at, part.c_str(), 0700) == 0);
      const int next = ::openat(at, part.c_str(), O_RDONLY | O_DIRECTORY);
      ::close(at);
      at = next;
    }
    ::close(at);
    const auto done = batch.run("in", "out");
    CHECK(done.code == 1);
    CHECK_THAT(done.err, Contains("cannot be listed: File name too long"));
    CHECK_THAT(done.out, Contains("1 meshes: 1 done;"));
    REQUIRE(std::system(("rm -rf '" + batch.folder / "in'").c_str()) == 0);
  } else {
    tests::skip("a user's closed folder is tried by the tests of the listing");
  }
}
