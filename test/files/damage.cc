/// \file
/// Damaged files: a FileError or a sound mesh, never anything else.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>
#include <thread>

#include "gltf_samples.hh"
#include "samples.hh"
#include "sound.hh"

namespace whittle::files {
namespace {

/// Reads and requires that a FileError of one line comes, or a mesh that can be used as it is.
/// \return whether a mesh came
bool survives(const std::filesystem::path& path, Repair repair) {
  try {
    if (const char* what = unsound(read_mesh(path, {repair}))) FAIL(what);
    return true;
  } catch (const FileError& error) {
    const std::string text = error.what();
    if (text.find(path.string()) != 0 || text.find('\n') != std::string::npos) FAIL("not one line: " << text);
    return false;
  }
}

/// Overwrites without a rename; the tests do this many thousand times.
class Scratch {
 public:
  Scratch(const Folder& folder, const std::string& name)
      : path_(folder / name), file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { ::close(file_); }

  /// Damage is looked at with and without repair, turn and turn about.
  bool survives_as(const std::string& bytes) {
    REQUIRE(::pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()));
    REQUIRE(::ftruncate(file_, static_cast<off_t>(bytes.size())) == 0);
    fixes_ = !fixes_;
    return survives(path_, fixes_ ? Repair::fix : Repair::report);
  }

 private:
  std::filesystem::path path_;
  int file_;
  bool fixes_ = false;
};

/// One sample of each format, and files with more in them than the writers make.
std::vector<std::pair<std::string, std::string>> samples(const Folder& folder, std::uint32_t vertices) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Flavour& flavour : flavours()) {
    write_mesh(folder / flavour.file, strip<float>(vertices), flavour.options);
    all.emplace_back(flavour.file, folder.get(flavour.file));
    const std::string rich = "attributes-" + flavour.file;
    write_mesh(folder / rich, square(), flavour.options,
               {square_normals(), square_colours(false, true), square_seam(), scalar("q", {1, 2, 3, 4})});
    all.emplace_back(rich, folder.get(rich));
  }
  all.emplace_back("rich.gltf", gltf_text(gltf_square()));
  write_levels(folder / "levels.glb", {{square(), {square_texture()}, {}, 0}, {square(), {}, {}, 1}});
  all.emplace_back("levels.glb", folder.get("levels.glb"));
  all.emplace_back("rich.obj",
                   "mtllib a.mtl\no a\nv 0 0 0 1 1 1\nv 1 0 0\nv 1 1 -0.5e-3\nv 0 1 0\nvt 0 0\nvt 1 0 0\nvn "
                   "0 0 1\nusemtl a\n"
                   "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -1//1 \\\n-2//1 -3//1\nl 1 2\n");
  all.emplace_back("rich.off",
                   "# c\nSTCNOFF\n4 2 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 1 0\n"
                   "1 1 0 0 0 1 1 1 1 1 1 1\n0 1 0 0 0 1 1 1 1 1 0 1\n"
                   "4 0 1 2 3 255 0 0\n3 0 1 2\n");
  const std::string elements =
      "element vertex 4\nproperty short x\nproperty float nx\nproperty short y\nproperty list uchar short l\n"
      "property short z\nelement face 2\nproperty uchar red\nproperty list uchar ushort vertex_index\n"
      "element e 1\nproperty int i\nend_header\n";
  all.emplace_back("rich.ply",
                   "ply\nformat ascii 1.0\ncomment c\n" + elements +
                       "0 0 0 0 0\n1 0 0 1 5 0\n1 0 1 0 0\n0 0 1 2 5 5 0\n9 4 0 1 2 3\n9 3 0 1 2\n-7\n");
  std::string big = "ply\nformat binary_big_endian 1.0\n" + elements;
  for (int i = 0; i < 4; ++i) big += std::string("\0\1\x3f\x80\0\0\0\2\1\0\7\0\3", 13);
  big += std::string("\5\4\0\0\0\1\0\2\0\3\5\3\0\0\0\1\0\2\0\0\0\7", 22);
  all.emplace_back("big.ply", big);
  return all;
}

TEST_CASE("damage: the samples themselves are sound") {
  const Folder folder;
  for (const auto& [name, bytes] : samples(folder, 8)) {
    INFO(name);
    CHECK(folder.error(name, bytes).empty());
  }
}

TEST_CASE("damage: files cut at every byte are refused or read soundly") {
  const Folder folder;
  for (const auto& [name, bytes] : samples(folder, 8)) {
    INFO(name);
    Scratch scratch(folder, "cut-" + name);
    for (std::size_t length = 0; length < bytes.size(); ++length)
      scratch.survives_as(bytes.substr(0, length));
  }
}

TEST_CASE("damage: larger files cut at every percent are refused or read soundly") {
  const Folder folder;
  for (const Flavour& flavour : flavours()) {
    INFO(flavour.file);
    write_mesh(folder / flavour.file, strip<float>(3000), flavour.options);
    const std::string bytes = folder.get(flavour.file);
    Scratch scratch(folder, "cut-" + flavour.file);
    int meshes = 0;
    for (std::size_t percent = 0; percent < 100; ++percent)
      meshes += scratch.survives_as(bytes.substr(0, bytes.size() * percent / 100)) ? 1 : 0;
    // Only OBJ has no way to tell, and only while the cut leaves whole numbers. Half of them are repaired: of STL what is
    // there is read then, else a file that is cut off is none the less an error.
    const bool is_stl = flavour.format.substr(0, 3) == "STL";
    if (flavour.format != "OBJ") CHECK(meshes == (is_stl ? 49 : 0));
  }
}

TEST_CASE("damage: random bytes changed, removed and repeated") {
  const Folder folder;
  std::mt19937 random(20240229);
  const auto below = [&](std::size_t end) { return random() % end; };
  const std::string likely = "0123456789-+.eE \n\\/#nlistopvfy\xff\x7f";
  for (const auto& [name, bytes] : samples(folder, 8)) {
    INFO(name);
    Scratch scratch(folder, "mutated-" + name);
    for (int round = 0; round < 3000; ++round) {
      std::string mutated = bytes;
      for (std::size_t change = 0; change <= below(4); ++change) {
        const std::size_t at = below(mutated.size());
        switch (below(5)) {
          case 0:
            mutated[at] = static_cast<char>(random());
            break;
          case 1:
            mutated[at] = likely[below(likely.size())];
            break;
          case 2:
            mutated[at] = static_cast<char>(mutated[at] ^ (1 << below(8)));
            break;
          case 3:
            mutated.erase(at, 1 + below(8));
            break;
          default:
            mutated.insert(at, mutated.substr(below(mutated.size()), 1 + below(8)));
            break;
        }
        if (mutated.empty()) break;
      }
      scratch.survives_as(mutated);
    }
  }
}

TEST_CASE("damage: random bytes behind each beginning") {
  const Folder folder;
  std::mt19937 random(7);
  for (const auto& [name, beginning] : std::vector<std::pair<std::string, std::string>>{
           {"a.obj", ""},
           {"a.obj", "v "},
           {"a.off", "OFF\n"},
           {"a.off", "OFF 4 4 0\n"},
           {"a.stl", ""},
           {"a.om", ""},
           {"a.om", "OMT\x22"},
           {"a.om", "OMP\x42"},
           {"a.glb", "glTF\2"},
           {"a.gltf", "{\"asset\":{\"version\":\"2.0\"},"},
           {"a.stl", "solid "},
           {"a.ply", "ply\n"},
           {"a.ply", "ply\nformat ascii 1.0\nelement vertex "}}) {
    Scratch scratch(folder, name);
    for (int round = 0; round < 300; ++round) {
      std::string bytes = beginning;
      for (std::size_t length = random() % 400; length > 0; --length) bytes += static_cast<char>(random());
      scratch.survives_as(bytes);
    }
  }
}

TEST_CASE("read_mesh: files that cannot be opened or told") {
  const Folder folder;
  const auto error = [&](const std::string& name) {
    return folder.message([&] { read_mesh(folder / name); });
  };
  CHECK(error("none.obj") == "none.obj: No such file or directory");
  CHECK(folder.error("empty.obj", "") == "empty.obj: the file is empty");
  CHECK(folder.error("a.xyz", "v 0 0 0\n") ==
        "a.xyz: unknown format '.xyz'; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  CHECK(folder.error("a", "v 0 0 0\n") ==
        "a: no extension; known are .3mf, .glb, .gltf, .obj, .off, .om, .ply and .stl");
  std::filesystem::create_directory(folder / "d.obj");
  CHECK(error("d.obj") == "d.obj: Is a directory");
  CHECK(error("a/b.obj") == "a/b.obj: Not a directory");
  CHECK(folder.message([] { read_mesh("/dev/zero"); }) == "/dev/zero: neither a file nor a pipe");
}

TEST_CASE("read_mesh: from a pipe") {
  const Folder folder;
  const std::filesystem::path pipe = folder / "pipe.obj";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  write_mesh(folder / "a.obj", strip<double>(20000));
  const std::string bytes = folder.get("a.obj");
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << bytes; });
  const MeshFile file = read_mesh(pipe);
  writer.join();
  CHECK(same_bits<double>(file.mesh, strip<double>(20000)));
}

}  // namespace
}  // namespace whittle::files
