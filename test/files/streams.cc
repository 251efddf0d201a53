/// \file
/// Standard input and standard output.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

#include <iostream>

#include "gltf_samples.hh"

namespace whittle::files {
namespace {

/// For a while a descriptor is another file.
class Redirect {
 public:
  Redirect(int number, int file) : number_(number), kept_(::dup(number)) {
    std::cout.flush();  // what the test program itself has yet to say
    REQUIRE(::dup2(file, number) == number);
  }
  Redirect(const Redirect&) = delete;
  Redirect& operator=(const Redirect&) = delete;
  ~Redirect() {
    if (::dup2(kept_, number_) < 0) std::abort();
    ::close(kept_);
  }

 private:
  int number_, kept_;
};

/// Reads "-" while these bytes come through a pipe.
MeshFile read_from_pipe(const std::string& bytes) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  std::thread writer([&] {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t written = ::write(ends[1], bytes.data() + done, bytes.size() - done);
      if (written <= 0) break;
      done += static_cast<std::size_t>(written);
    }
    ::close(ends[1]);
  });
  struct Join {
    std::thread& thread;
    int end;
    ~Join() {
      thread.join();
      ::close(end);
    }
  } join{writer, ends[0]};
  const Redirect input(STDIN_FILENO, ends[0]);
  return read_mesh("-");
}

TEST_CASE("read_mesh: standard input, whose format the content tells") {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    write_mesh(folder / flavour.file, strip<float>(20), flavour.options);
    const MeshFile file = read_from_pipe(folder.get(flavour.file));
    CHECK(file.report.format == flavour.format);
    CHECK(same_bits<float>(file.mesh, strip<float>(20)));
  }
  CHECK(read_from_pipe(gltf_text(gltf_square())).report.format == "glTF, JSON");
  CHECK(read_from_pipe("# comment\n\nmtllib a\nv 0 0 0\n").report.format == "OBJ");
}

TEST_CASE("read_mesh: standard input that is a file, wherever it stands") {
  const Folder folder;
  folder.put("a", "skipped\nOFF\n1 0 0\n0 0 0\n");
  const int file = ::open((folder / "a").c_str(), O_RDONLY);
  REQUIRE(::lseek(file, 8, SEEK_SET) == 8);
  {
    const Redirect input(STDIN_FILENO, file);
    CHECK(read_mesh("-").mesh.points.size() == 1);
  }
  ::close(file);
}

TEST_CASE("read_mesh: errors of standard input") {
  const Folder folder;
  const auto error = [&](const std::string& bytes) { return folder.message([&] { read_from_pipe(bytes); }); };
  CHECK(error("") == "standard input: the file is empty");
  CHECK(error("hello\n") == "standard input: the content is of no known format");
  CHECK(error("v 0 0 0\nv 1 2\n") == "standard input:2: expected a number, found the end of the line");
  CHECK(error(std::string(83, '\0')) == "standard input: the file is cut off: too short for an STL header");
}

TEST_CASE("write_mesh: standard output in a format that is named") {
  const Folder folder;
  for (const char* format : {"obj", "off", "ply", "stl", "om", "glb", "PLY"}) {
    INFO(format);
    const int file = ::open((folder / "out").c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
    {
      const Redirect output(STDOUT_FILENO, file);
      write_mesh("-", strip<float>(20), {false, true, format});
    }
    ::close(file);
    write_mesh(folder / (std::string("a.") + format), strip<float>(20), {false, true});
    CHECK(folder.get("out") == folder.get(std::string("a.") + format));
  }
  CHECK_FALSE(std::filesystem::exists("-"));
}

TEST_CASE("write_mesh: a format that is named wins over the extension") {
  const Folder folder;
  write_mesh(folder / "a.obj", square(), {false, false, "off"});
  CHECK(folder.get("a.obj").substr(0, 4) == "OFF\n");
  check_writable(folder / "a", {false, false, "ply"});
  CHECK(folder.message([] { check_writable("-"); }) ==
        "standard output: the format of standard output must be named");
  CHECK(
      folder.message([] {
        check_writable("-", {false, false, "xyz"});
      }) ==
      "standard output: unknown format '.xyz'; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  check_writable("-", {false, false, "glb"});
}

TEST_CASE("write_mesh: standard output that is full or closed") {
  const Folder folder;
  const int full = ::open("/dev/full", O_WRONLY);
  std::string message;
  {
    const Redirect output(STDOUT_FILENO, full);
    message = folder.message([] { write_mesh("-", square(), {false, false, "ply"}); });
  }
  ::close(full);
  CHECK(message == "standard output: No space left on device");
}

}  // namespace
}  // namespace whittle::files
