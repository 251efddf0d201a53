/// \file
/// glTF that is rounded and packed, by every command that writes it.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;

namespace {

std::string extensions_of(const std::string& glb) {
  std::string text;
  const std::string bytes = programs::contents(glb);
  for (const char* name : {"KHR_mesh_quantization", "EXT_meshopt_compression", "MSFT_lod"})
    if (bytes.find(name) != std::string::npos) text += std::string(text.empty() ? "" : " ") + name;
  return text;
}

}  // namespace

TEST_CASE("--quantize and --compress make glTF small, and say what was rounded") {
  const TorusFile in;
  const std::string out = in.folder / "out.glb", plain = in.folder / "plain.glb";
  CHECK(whittle_program({"simplify", in.path, plain, "--ratio", "0.5", "--quiet"}).code == 0);
  const auto done = whittle_program({"simplify", in.path, out, "--ratio", "0.5", "--quantize=14",
                                     "--compress", "meshopt", "--json", in.folder / "out.json"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK_THAT(done.err, Contains("positions rounded to 14 bits, by up to "));
  const Json json = Json::parse(programs::contents(in.folder / "out.json"));
  CHECK_THAT(json["output"]["reduced"][0].get<std::string>(), Contains("positions rounded to 14 bits"));
  CHECK(extensions_of(out) == "KHR_mesh_quantization EXT_meshopt_compression");
  CHECK(2 * programs::contents(out).size() < programs::contents(plain).size());
  CHECK(files::read_mesh(out).mesh.triangles.size() == 1344);

  CHECK(whittle_program({"lods", in.path, "--out", out, "--levels", "2", "--quantize", "--quiet"}).code == 0);
  CHECK(extensions_of(out) == "KHR_mesh_quantization MSFT_lod");
  CHECK(files::read_mesh(out).mesh.triangles.size() == 2688);
}

TEST_CASE("batch hands --quantize and --compress on") {
  const TorusFile in;
  const std::string list = in.folder / "list.txt";
  std::ofstream(list) << in.path << "\n";
  const auto done = whittle_program({"batch", list, "--out", in.folder / "small", "--format", "glb",
                                     "--ratio", "0.5", "--quantize", "--compress", "meshopt"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  std::size_t results = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(in.folder / "small"))
    if (entry.path().extension() == ".glb") {
      CHECK(extensions_of(entry.path()) == "KHR_mesh_quantization EXT_meshopt_compression");
      ++results;
    }
  CHECK(results == 1);
}

TEST_CASE("--quantize and --compress are for glTF, with bits that make sense") {
  const TorusFile in;
  const auto refused = [&](std::vector<std::string> words) {
    const auto done = whittle_program(words);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    return done.err;
  };
  const std::string ply = in.folder / "out.ply";
  CHECK_THAT(refused({"simplify", in.path, ply, "--ratio", "0.5", "--quantize"}),
             Contains("--quantize is for glTF: ") && Contains("out.ply is another format"));
  CHECK_THAT(refused({"lods", in.path, "--out", ply, "--compress", "meshopt"}),
             Contains("--compress is for glTF: "));
  CHECK_THAT(refused({"batch", in.folder.path(), "--out", in.folder / "x", "--ratio", "0.5", "--format",
                      "obj", "--quantize"}),
             Contains("--quantize is for glTF: --format obj is another format"));
  CHECK_THAT(refused({"simplify", in.path, in.folder / "a.glb", "--ratio", "0.5", "--quantize=7"}),
             Contains("--quantize"));
  CHECK_THAT(refused({"simplify", in.path, in.folder / "a.glb", "--ratio", "0.5", "--compress", "zip"}),
             Contains("--compress"));
}
