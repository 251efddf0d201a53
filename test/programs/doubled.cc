/// \file
/// Files that double their vertices, through whittle simplify.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "TorusFile.hh"
#include "measure/MeshFacts.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;

namespace {

/// A torus in a PLY file, each face of which has vertices of its own.
struct SoupFile : TorusFile {
  IndexedMesh soup;

  SoupFile() {
    for (const auto& triangle : mesh.triangles) {
      const auto n = static_cast<std::uint32_t>(soup.points.size());
      for (const std::uint32_t v : triangle) soup.points.push_back(mesh.points[v]);
      soup.triangles.push_back({n, n + 1, n + 2});
    }
    files::write_mesh(path, soup);
  }

  Json simplified(const std::string& out, std::vector<std::string> more, int code = 0) const {
    std::vector<std::string> arguments{"simplify", path, folder / out, "--ratio", "0.2", "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto done = whittle_program(arguments);
    INFO(done.err);
    REQUIRE(done.code == code);
    return Json::parse(done.out);
  }
};

std::vector<std::size_t> numbers(const std::string& file) {
  std::istringstream in(programs::contents(file));
  std::vector<std::size_t> out;
  for (std::size_t n; in >> n;) out.push_back(n);
  return out;
}

}  // namespace

TEST_CASE("a mesh of faces on their own reaches its target and stays closed") {
  const SoupFile in;
  const Json json = in.simplified("out.ply", {"--map", in.folder / "map"});
  CHECK(json["input"]["vertices"] == in.mesh.points.size());
  CHECK(json["input"]["read"]["vertices_merged"] == in.soup.points.size() - in.mesh.points.size());
  const IndexedMesh out = files::read_mesh(in.folder / "out.ply").mesh;
  CHECK(measure::facts(out).boundary_edges == 0);

  // The map has a line for each vertex of the file; those at one place became the same.
  const std::vector<std::size_t> map = numbers(in.folder / "map");
  REQUIRE(map.size() == in.soup.points.size());
  std::vector<std::size_t> at(in.mesh.points.size(), out.points.size());
  for (std::size_t v = 0; v < map.size(); ++v) {
    const std::uint32_t welded = in.mesh.triangles[v / 3][v % 3];
    if (at[welded] == out.points.size()) at[welded] = map[v];
    CHECK(map[v] == at[welded]);
  }
}

TEST_CASE("a selection and a map count the vertices of the files, doubled ones included") {
  const SoupFile in;
  const std::string list = in.folder / "keep.txt";
  const std::size_t last = in.soup.points.size() - 1;
  std::ofstream(list) << "0 " << last << "\n";
  // Every face another colour: the result has its vertices several times, too.
  attributes::Attribute colour;
  colour.kind = attributes::Kind::colour;
  colour.components = 3;
  for (std::size_t v = 0; v < in.soup.points.size(); ++v)
    for (int k = 0; k < 3; ++k) colour.values.push_back(static_cast<float>(v / 3 % 5) / 4);
  files::write_mesh(in.path, in.soup, {}, {colour});
  const Json json = in.simplified("out.ply", {"--lock", "selection:" + list, "--map", in.folder / "map"});
  CHECK(json["vertices_locked"] == 2);
  const files::MeshFile out = files::read_mesh(in.folder / "out.ply", {files::Repair::none});
  CHECK(out.mesh.points.size() ==
        std::size_t(json["output"]["vertices"]) + std::size_t(json["output"]["vertices_doubled"]));
  CHECK(json["output"]["vertices_doubled"] > 0);
  const std::vector<std::size_t> map = numbers(in.folder / "map");
  REQUIRE(map.size() == in.soup.points.size());
  for (const std::size_t v : {std::size_t{0}, last}) CHECK(out.mesh.points.at(map[v]) == in.soup.points[v]);
}

TEST_CASE(
    "--repair none leaves doubled vertices as they are, and the reason of a missed target names --weld") {
  const SoupFile in;
  const Json json = in.simplified("out.ply", {"--repair", "none"}, 1);
  CHECK(json["output"]["faces"] == in.mesh.triangles.size());

  IndexedMesh jittered = in.soup;
  for (std::size_t v = 0; v < jittered.points.size(); ++v)
    jittered.points[v].z() += 1e-9 * static_cast<double>(v);
  files::write_mesh(in.path, jittered);
  const Json missed = in.simplified("out.ply", {}, 1);
  CHECK_THAT(missed["target_missed_because"].back(), Contains("--weld"));
  const auto line = whittle_program({"simplify", in.path, in.folder / "o.ply", "--ratio", "0.2"}).err;
  CHECK_THAT(line, Contains("--weld 0.0") && Contains(" joins neighbours; --force goes on") &&
                       !Contains("--pieces"));
  CHECK(in.simplified("out.ply", {"--weld", "1e-4"})["target_reached"] == true);
  CHECK(measure::facts(files::read_mesh(in.folder / "out.ply").mesh).boundary_edges == 0);
  for (const std::string bad : {"-1", "0", "nan", "inf", "0.1%", "1e3"}) {
    const auto done =
        whittle_program({"simplify", in.path, in.folder / "o.ply", "--ratio", "0.5", "--weld=" + bad});
    INFO(bad << done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains("weld"));
  }
}

TEST_CASE("a mesh with each face in both directions names --repair fix, which helps") {
  const TorusFile in;
  IndexedMesh both = in.mesh;
  for (const auto& [a, b, c] : in.mesh.triangles) both.triangles.push_back({a, c, b});
  files::write_mesh(in.path, both);
  const auto done = whittle_program({"simplify", in.path, in.folder / "o.ply", "--ratio", "0.2"});
  CHECK(done.code == 1);
  CHECK_THAT(done.err, Contains(std::to_string(in.mesh.triangles.size()) +
                                " faces lie on the vertices of others: --repair fix leaves them out"));
  CHECK(
      whittle_program({"simplify", in.path, in.folder / "o.ply", "--ratio", "0.2", "--repair", "fix"}).code ==
      0);
}

TEST_CASE("a weight at vertices that become one is the largest of them") {
  const SoupFile in;
  attributes::Attribute weight;
  weight.name = "weight";
  for (std::size_t v = 0; v < in.soup.points.size(); ++v)
    weight.values.push_back(v == 0 ? 1 : v == 1 ? 1 : 0);
  files::write_mesh(in.path, in.soup, {}, {weight});
  const Json json = in.simplified("out.ply", {"--weights", "weight", "--no-refit"});
  CHECK(json["target_reached"] == true);
  const IndexedMesh out = files::read_mesh(in.folder / "out.ply").mesh;
  CHECK(std::find(out.points.begin(), out.points.end(), in.soup.points[0]) != out.points.end());
}
