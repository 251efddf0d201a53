/// \file
/// A file makes `whittle info` take memory in proportion to its size, never to the counts it declares.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "Folder.hh"

extern char** environ;

namespace {

constexpr long kMiB = 1024;  // in the units of ru_maxrss

#ifdef WHITTLE_SANITIZED
constexpr long kShadow = 2;  // with what a sanitizer adds to the program, which this one is built without
#else
constexpr long kShadow = 1;
#endif

struct Ended {
  int code = -1;      ///< the exit code; -1: killed
  long peak_kib = 0;  ///< of resident memory
};

Ended info(const std::filesystem::path& path) {
  std::string program = WHITTLE_PROGRAM, name = path.string();
  char command[] = "info", quiet[] = "--quiet";
  char* arguments[] = {program.data(), command, name.data(), quiet, nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int file : {1, 2}) posix_spawn_file_actions_addopen(&files, file, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  REQUIRE(::posix_spawn(&child, program.c_str(), &files, nullptr, arguments, environ) == 0);
  posix_spawn_file_actions_destroy(&files);
  int status = 0;
  rusage usage{};
  REQUIRE(::wait4(child, &status, 0, &usage) == child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, usage.ru_maxrss};
}

struct File {
  std::string name, bytes;
};

void put(const scratch::Folder& folder, const File& file) {
  std::ofstream out(folder / file.name, std::ios::binary);
  out << file.bytes;
  REQUIRE(out.flush().good());
}

std::string little(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i, value >>= 8) bytes += static_cast<char>(value & 0xffU);
  return bytes;
}

std::string times(std::size_t n, const std::string& text) {
  std::string all;
  all.reserve(n * text.size());
  for (std::size_t i = 0; i < n; ++i) all += text;
  return all;
}

std::string glb(std::string json, const std::string& data = "") {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string body = little(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
  if (!data.empty()) body += little(static_cast<std::uint32_t>(data.size())) + std::string("BIN\0", 4) + data;
  return "glTF" + little(2) + little(static_cast<std::uint32_t>(12 + body.size())) + body;
}

/// A scene of one mesh whose accessor has no data behind it, so that all of it is zeros.
std::string zeros(const std::string& count) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"componentType":5126,"type":"VEC3","count":)" +
         count + "}]}";
}

/// Nodes that each have the next one ten times, down to a mesh.
std::string family() {
  std::string nodes;
  for (int i = 0; i < 30; ++i) {
    const std::string child = std::to_string(i + 1);
    nodes += R"({"children":[)";
    nodes += times(9, child + ",");
    nodes += child;
    nodes += "]},";
  }
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"({"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"componentType":5126,"type":"VEC3","count":3}]})";
}

const std::string kPly =
    "property float x\nproperty float y\nproperty float z\nelement face 4294967295\n"
    "property list uint uint vertex_indices\nend_header\n";

/// Files that claim far more than they hold.
std::vector<File> liars() {
  const std::string all = "\xff\xff\xff\xff";
  return {{"ascii.ply", "ply\nformat ascii 1.0\nelement vertex 4294967295\n" + kPly + "0 0 0\n"},
          {"binary.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\n" + kPly + "...."},
          {"faces.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 0\n" + kPly + all + all},
          {"nothing.ply",
           "ply\nformat ascii 1.0\nelement void 9223372036854775807\nelement vertex 4294967295\n" + kPly},
          {"counts.off", "OFF\n4294967295 4294967295 4294967295\n0 0 0\n"},
          {"corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967295 0 1 2\n"},
          {"a.stl", std::string(80, ' ') + all + std::string(50, '\0')},
          {"triangles.om", "OMT\x41" + all + all + all},
          {"polygons.om", "OMP\x42" + all + all + all + std::string("\0\x44", 2)},
          {"index.obj", "v 0 0 0\nf 4294967295 1 1\n"},
          {"zeros.gltf", zeros("4294967295")},
          {"zeros.glb", glb(zeros("4294967295"))},
          {"many.gltf", zeros("18446744073709551615")},
          {"family.gltf", family()},
          {"length.glb", "glTF" + little(2) + all + all + "JSON{}"}};
}

/// The files of 4 MiB that hold the most for their size.
std::vector<File> dense() {
  constexpr std::size_t n = 4 << 20;
  const std::string little_ply = "ply\nformat binary_little_endian 1.0\n";
  const std::string points = "property uchar x\nproperty uchar y\nproperty uchar z\n";
  return {{"points.obj", times(n / 8, "v 0 0 0\n")},
          {"faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + times(n / 8, "f 1 2 3\n")},
          {"polygon.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf" + times(n / 6, " 1 2 3") + "\n"},
          {"faces.off",
           "OFF\n3 " + std::to_string(n / 8) + " 0\n0 0 0\n1 0 0\n0 1 0\n" + times(n / 8, "3 0 1 2\n")},
          {"points.ply", little_ply + "element vertex " + std::to_string(n / 3) + "\n" + points +
                             "element face 0\nproperty list uchar uchar vertex_indices\nend_header\n" +
                             times(n / 3, "abc")},
          {"faces.ply", little_ply + "element vertex 3\n" + points + "element face " + std::to_string(n / 4) +
                            "\nproperty list uchar uchar vertex_indices\nend_header\n" +
                            std::string("\0\0\0\1\0\0\0\1\0", 9) + times(n / 4, std::string("\3\0\1\2", 4))},
          {"a.stl", std::string(80, ' ') + little(n / 50) + times(n / 50, std::string(50, '\0'))},
          {"deep.gltf", times(n, "[")},
          {"wide.gltf", R"({"asset":{"version":"2.0"},"nodes":[)" + times(n / 3, "{},") + "{}]}"}};
}

long idle_peak(const scratch::Folder& folder) {
  put(folder, {"idle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"});
  const Ended idle = info(folder / "idle.obj");
  REQUIRE(idle.code == 0);
  return idle.peak_kib;
}

/// Calls `check(how it ended, KiB more than a tiny file takes)` for each file.
template <typename Check>
void for_each_ended(const std::vector<File>& files, Check check) {
  const scratch::Folder folder;
  const long idle = idle_peak(folder);
  for (const File& file : files) {
    put(folder, file);
    const Ended ended = info(folder / file.name);
    INFO(file.name << ": " << ended.peak_kib - idle << " KiB more than a tiny file");
    check(ended, ended.peak_kib - idle);
  }
}

}  // namespace

TEST_CASE("memory: a file that claims a lot is refused and gets nothing") {
  for_each_ended(liars(), [](const Ended& ended, long more_kib) {
    CHECK(ended.code == 2);
    // glTF may say "zeros" shortly, and gets up to 16 MiB of them.
    CHECK(more_kib < kShadow * 20 * kMiB);
  });
}

TEST_CASE("memory: the densest files take a small multiple of their size") {
  for_each_ended(dense(), [](const Ended& ended, long more_kib) {
    CHECK((ended.code == 0 || ended.code == 2));
    CHECK(more_kib < kShadow * 64 * 4 * kMiB);
  });
}
