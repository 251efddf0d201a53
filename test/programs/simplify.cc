#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Process.hh"
#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

namespace {

programs::Outcome simplify(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "simplify");
  return programs::run(WHITTLE_PROGRAM, arguments);
}

/// A torus in a file, in a folder that holds nothing else.
struct Input {
  explicit Input(const std::string& name = "in.ply") : path(folder / name) { files::write_mesh(path, mesh); }
  programs::Folder folder;
  IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  std::string path;
};

}  // namespace

TEST_CASE("simplify writes a smaller mesh and says what it did") {
  const Input in;
  const auto done = simplify({in.path, in.folder / "out.obj", "--module", "ivdd:distance=0.9e"});
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(done.out, Contains("faces of 2688 left"));
  const auto out = files::read_mesh(in.folder / "out.obj");
  CHECK(out.mesh.triangles.size() < 2688);
  const auto facts = measure::facts(out.mesh);
  CHECK(facts.closed());
  CHECK(facts.euler_characteristic == 0);
}

TEST_CASE("simplify reads and writes every format") {
  for (const std::string from : {"a.obj", "a.ply", "a.off", "a.stl"})
    for (const std::string to : {"b.obj", "b.ply", "b.off", "b.stl"})
      for (const bool ascii : {false, true}) {
        const Input in(from);
        std::vector<std::string> arguments{in.path, in.folder / to, "--module", "fad", "--quiet"};
        if (ascii) arguments.push_back("--ascii");
        const auto done = simplify(arguments);
        INFO(from << " to " << to << done.err);
        CHECK(done.code == 0);
        CHECK(done.out.empty());
        CHECK(measure::facts(files::read_mesh(in.folder / to).mesh).closed());
      }
}

TEST_CASE("simplify --ratio 1 changes nothing but the format") {
  const Input in;
  const auto done = simplify({in.path, in.folder / "out.obj", "--ratio", "1"});
  CHECK(done.code == 0);
  CHECK_THAT(done.out,
             Contains("2688 faces of 2688 left") && Contains(" ms (reading ") && Contains(", writing "));
  const files::MeshFile before = files::read_mesh(in.path), after = files::read_mesh(in.folder / "out.obj");
  CHECK(after.mesh.triangles == before.mesh.triangles);
  CHECK(after.mesh.points == before.mesh.points);
  const auto more = simplify({in.path, in.folder / "out.obj", "--ratio", "1.01"});
  CHECK(more.code == 2);
  CHECK_THAT(more.err, Contains("the ratio must be above 0 and at most 1"));
}

TEST_CASE("simplify reads and writes packed files, also on standard input") {
  const Input in;
  CHECK(simplify({in.path, in.folder / "half.obj.gz", "--ratio", "0.5", "--quiet"}).code == 0);
  const std::string command = "'" WHITTLE_PROGRAM "' simplify - '" + in.folder / "out.ply" +
                              "' --ratio 0.5 --quiet <'" + in.folder / "half.obj.gz" + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(files::read_mesh(in.folder / "out.ply").mesh.triangles.size() == 672);
}

TEST_CASE("simplify refuses a target where there are no faces") {
  const Input in;
  std::ofstream(in.folder / "points.obj") << "v 0 0 0\nv 1 0 0\n";
  const auto done = simplify({in.folder / "points.obj", in.folder / "out.ply", "--faces", "5"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("there are no faces, so no target can be reached"));
  CHECK_FALSE(std::filesystem::exists(in.folder / "out.ply"));
}

TEST_CASE("a missed target names the weld that closes a torn mesh") {
  const Input in;
  // Two halves, each a little aside of the other, and all of the first one's boundary beside the second one's.
  IndexedMesh torn = in.mesh;
  const auto n = static_cast<std::uint32_t>(torn.points.size());
  for (std::uint32_t v = 0; v < n; ++v)
    torn.points.push_back(torn.points[v] + IndexedMesh::Point(0, 0, 1e-6));
  for (std::size_t f = 0; f < torn.triangles.size(); f += 2)
    for (std::uint32_t& corner : torn.triangles[f]) corner += n;
  files::write_mesh(in.path, torn);
  const auto done = simplify({in.path, in.folder / "out.ply", "--ratio", "0.1"});
  CHECK(done.code == 1);
  CHECK_THAT(done.err, Contains("--weld 0.0"));
}

TEST_CASE("simplify's JSON holds what was decided, to a file or to stdout") {
  const Input in;
  const std::vector<std::string> common{in.path, in.folder / "out.ply", "--module", "ivdd", "--ratio", "0.5",
                                        "--json"};
  auto to_file = common, to_stdout = common;
  to_file.push_back(in.folder / "record.json");
  to_stdout.push_back("-");
  CHECK(simplify(to_file).code == 0);
  const Json file = Json::parse(programs::contents(in.folder / "record.json"));
  const Json stdout_json = Json::parse(simplify(to_stdout).out);
  CHECK(file["output"] == stdout_json["output"]);

  CHECK(file["input"]["faces"] == 2688);
  CHECK(file["output"]["faces"] == 1344);
  CHECK(file["target"]["ratio"] == 0.5);
  CHECK(file["target_reached"] == true);
  CHECK(file["flipped_faces"] == 0);
  REQUIRE(file["stages"].size() == 1);
  CHECK(file["stages"][0]["driver"] == "bulk");
  CHECK(file["stages"][0]["faces_after"] == 1344);
  CHECK_THAT(file["stages"][0]["module"].get<std::string>(), Contains("ivdd:distance="));
  CHECK(file["stages"][0]["plan_ms"].get<double>() > 0);
}

TEST_CASE("simplify gives the same file on every run and with every driver") {
  const Input in;
  std::string first;
  for (const std::string driver : {"auto", "bulk", "sweep", "decimater", "auto"}) {
    REQUIRE(simplify({in.path, in.folder / "out.obj", "--module", "fad:angle=40", "--driver", driver}).code ==
            0);
    const std::string bytes = programs::contents(in.folder / "out.obj");
    if (first.empty()) first = bytes;
    if (driver == "auto" || driver == "bulk") CHECK(bytes == first);
    CHECK(bytes.size() == first.size());  // OpenMesh may begin a face at another corner
  }
}

TEST_CASE("simplify can end with a Delaunay retriangulation") {
  const Input in;
  const auto done = simplify({in.path, in.folder / "out.ply", "--module", "fad", "--delaunay", "20", "--json",
                              in.folder / "r.json"});
  CHECK(done.code == 0);
  const Json delaunay = Json::parse(programs::contents(in.folder / "r.json"))["delaunay"];
  CHECK(delaunay["edges_flipped"].get<int>() > 0);
  CHECK(delaunay["converged"] == true);
  CHECK(measure::facts(files::read_mesh(in.folder / "out.ply").mesh).closed());
}

TEST_CASE(
    "simplify ends with a refit after mq or where asked to, which brings the result closer to the input") {
  const Input in;
  const IndexedMesh input = files::read_mesh(in.path).mesh;
  const auto rms = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{in.path, in.folder / "out.ply", "--json", in.folder / "r.json"};
    words.insert(words.end(), options.begin(), options.end());
    CHECK(simplify(words).code == 0);
    return measure::distance(input, files::read_mesh(in.folder / "out.ply").mesh, {20000, 0}).two_sided.rms;
  };
  const auto told = [&] { return Json::parse(programs::contents(in.folder / "r.json"))["refit"]; };
  for (const std::string module : {"mq", "ivdd"}) {
    const double without = rms({"--module", module, "--ratio", "0.3", "--no-refit"});
    CHECK(told().is_null());
    const double with = rms({"--module", module, "--ratio", "0.3", "--refit"});
    CHECK(with < 0.95 * without);
    CHECK(told()["vertices_moved"].get<int>() > 0);
    CHECK(rms({"--module", module, "--ratio", "0.3"}) == (module == "mq" ? with : without));
  }
  rms({"--max-distance", "1%", "--ratio", "0.3"});
  CHECK(told().is_null());
  CHECK(rms({"--max-distance", "1%", "--ratio", "0.3", "--refit"}) > 0);
  CHECK(told().contains("dropped_for_the_bound"));
  const auto refused =
      simplify({in.path, in.folder / "out.ply", "--module", "mq:max-distance=0.01", "--refit"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("a refit does not keep the bound"));
}

TEST_CASE("simplify may overwrite its input") {
  const Input in;
  CHECK(simplify({in.path, in.path, "--module", "fad"}).code == 0);
  CHECK(files::read_mesh(in.path).mesh.triangles.size() < 2688);
  CHECK(in.folder.entries() == 1);
}

TEST_CASE("a target out of reach is exit 1, one line, and the mesh as far as it came") {
  const Input in;
  const auto done =
      simplify({in.path, in.folder / "out.ply", "--module", "ivdd:distance=0.5e", "--faces", "4", "--quiet"});
  CHECK(done.code == 1);
  CHECK(done.error_lines() == 1);
  CHECK_THAT(done.err, Contains("the target was not reached"));
  CHECK_FALSE(files::read_mesh(in.folder / "out.ply").mesh.triangles.empty());
}

TEST_CASE("a target without a module goes to mq, with any driver to the same surface") {
  const Input in;
  for (const char* driver : {"auto", "sweep", "lazy", "decimater"}) {
    const auto done = simplify({in.path, in.folder / "out.ply", "--faces", "500", "--driver", driver,
                                "--json", in.folder / "r.json"});
    CHECK(done.code == 0);
    const Json report = Json::parse(programs::contents(in.folder / "r.json"));
    CHECK(report["stages"][0]["module"] == "mq");
    CHECK(report["flipped_faces"] == 0);
    const IndexedMesh out = files::read_mesh(in.folder / "out.ply").mesh;
    CHECK(out.triangles.size() == 500);
    CHECK(measure::facts(out).closed());
    CHECK(measure::distance(in.mesh, out).two_sided.rms < 0.01);
  }
  CHECK(simplify({in.path, in.folder / "out.ply", "--vertices", "300", "--quiet"}).code == 0);
  CHECK(files::read_mesh(in.folder / "out.ply").mesh.points.size() == 300);
}

TEST_CASE("simplify counts and reports faces that OpenMesh cannot take") {
  const Input in;
  IndexedMesh mesh = in.mesh;
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][1], 700});
  files::write_mesh(in.path, mesh);
  const std::string out = in.folder / "out.ply";
  const auto sweep =
      simplify({in.path, out, "--module", "fad", "--driver", "sweep", "--json", in.folder / "r.json"});
  CHECK(sweep.code == 0);
  CHECK_THAT(sweep.err, Contains("1 faces are not manifold and were left out"));
  CHECK(Json::parse(programs::contents(in.folder / "r.json"))["nonmanifold_faces_dropped"] == 1);
  const std::string bulk = simplify({in.path, out, "--module", "fad"}).err;
  CHECK_THAT(bulk, Contains("non-manifold edge") && Contains("kept") && !Contains("left out"));
}

TEST_CASE("bad usage and bad input are exit 2 with one line that names the culprit, and nothing is written") {
  const Input in;
  const std::string out = in.folder / "out.ply";
  std::ofstream(in.folder / "broken.obj") << "v 0 0 0\nv 1 0 0\nf 1 2 3\n";
  const auto refused = [&](std::vector<std::string> arguments, const std::string& culprit) {
    const std::size_t files_before = in.folder.entries();
    const auto done = programs::run(WHITTLE_PROGRAM, arguments);
    INFO(culprit << " | " << done.err);
    CHECK(done.code == 2);
    CHECK(done.out.empty());
    CHECK(done.error_lines() == 1);
    CHECK_THAT(done.err, Contains(culprit));
    CHECK(in.folder.entries() == files_before);
  };
  refused({}, "no command given");
  refused({"melt"}, "melt");
  refused({"simplify"}, "IN");
  refused({"simplify", in.path}, "OUT");
  refused({"simplify", in.path, out}, "--module");
  refused({"simplify", in.path, out, "--module", "fda"}, "unknown module 'fda'");
  refused({"simplify", in.path, out, "--module", "fad:angel=3"}, "unknown key 'angel'");
  refused({"simplify", in.path, out, "--module", "ivdd:distance=3m"}, "unknown unit 'm'");
  refused({"simplify", in.path, out, "--module", "fad:angle=500"}, "angle=500 is out of range");
  refused({"simplify", in.path, out, "--module", "ivdd"}, "needs distance=");
  refused({"simplify", in.path, out, "--module", "fad", "--ratio", "2"}, "ratio");
  refused({"simplify", in.path, out, "--module", "fad", "--ratio", "half"}, "--ratio");
  refused({"simplify", in.path, out, "--module", "fad", "--faces", "-5"}, "--faces");
  refused({"simplify", in.path, out, "--module", "fad", "--vertices", "0"}, "--vertices");
  refused({"simplify", in.path, out, "--module", "fad", "--faces", "9", "--ratio", "0.5"}, "excludes");
  refused({"simplify", in.path, out, "--module", "fad", "--driver", "fast"}, "unknown driver 'fast'");
  refused({"simplify", in.path, out, "--module", "fad", "--delaunay", "200"}, "between 0 and 180");
  refused({"simplify", in.path, out, "--module", "fad", "--color"}, "--color");
  refused({"simplify", in.folder / "none.ply", out, "--module", "fad"}, "none.ply");
  refused({"simplify", in.folder / "broken.obj", out, "--module", "fad"}, "broken.obj:3");
  refused({"simplify", in.path, in.folder / "out.xyz", "--module", "fad"}, "out.xyz");
  refused({"simplify", in.path, in.folder / "no/such/out.ply", "--module", "fad"}, "no/such");
  refused({"simplify", in.path, out, "--module", "fad", "--json", in.folder / "no/such.json"},
          "no/such.json");
  refused({"simplify", in.path, "/dev/null/out.ply", "--module", "fad"}, "/dev/null");
}

TEST_CASE("whittle answers --help and --version on stdout with exit 0") {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--help"}, {"--version"}, {"simplify", "--help"}, {"measure", "--help"}, {"info", "--help"}}) {
    const auto done = programs::run(WHITTLE_PROGRAM, arguments);
    CHECK(done.code == 0);
    CHECK_FALSE(done.out.empty());
    CHECK(done.err.empty());
  }
  CHECK_THAT(simplify({"--help"}).out, Contains("ivdd:distance=0.0011"));
}

TEST_CASE("small pieces stay without crushing the rest, or vanish when asked") {
  const programs::Folder folder;
  const std::string in = folder / "dusty.ply", out = folder / "out.ply", map = folder / "map.txt";
  files::write_mesh(in, meshes::dusty_torus(60));  // 2,688 and 480 faces
  const auto kept = simplify({in, out, "--ratio", "0.05"});
  CHECK(kept.code == 1);
  CHECK_THAT(kept.err, Contains("60 small pieces keep up to four faces each") &&
                           Contains("--pieces by-error lets pieces go") && Contains("--force goes on"));
  const std::size_t faces = files::read_mesh(out).mesh.triangles.size();
  CHECK(faces > 370);
  CHECK(faces <= 387);  // 240, and the share of the others

  const auto forced = simplify({in, out, "--ratio", "0.05", "--force"});
  CHECK(forced.code == 1);
  CHECK_THAT(forced.err, Contains("60 small pieces keep up to four faces each") &&
                             Contains("--pieces by-error lets pieces go") && !Contains("--force"));
  CHECK(files::read_mesh(out).mesh.triangles.size() < 300);

  const auto let_go = simplify({in, out, "--ratio", "0.05", "--pieces", "by-error", "--map", map});
  CHECK(let_go.code == 0);
  CHECK_THAT(let_go.out, Contains("60 of 61 pieces have vanished, with 480 faces of the input"));
  CHECK(measure::facts(files::read_mesh(out).mesh).components == 1);
  const std::string lines = files::read_file(map);
  CHECK(std::count(lines.begin(), lines.end(), '-') == 360);

  CHECK(simplify({in, out, "--module", "fad", "--pieces", "1%"}).code == 0);
  CHECK(measure::facts(files::read_mesh(out).mesh).components == 1);
  // Alone, a length takes small pieces away and leaves the rest as it is.
  const auto only = simplify({in, out, "--pieces", "1%", "--json", folder / "json"});
  CHECK(only.code == 0);
  CHECK_THAT(only.out, Contains("60 of 61 pieces have vanished, with 480 faces of the input"));
  IndexedMesh torus = files::read_mesh(in).mesh;
  torus.triangles.resize(2688);
  CHECK(meshes::canonical(files::read_mesh(out).mesh) == meshes::canonical(torus));
  CHECK(Json::parse(files::read_file(folder / "json"))["stages"].empty());
  for (const std::string rule : {"keep", "by-error"}) CHECK(simplify({in, out, "--pieces", rule}).code == 2);
  for (const std::string rule : {"some", "0", "-1", "3x"})
    CHECK(simplify({in, out, "--ratio", "0.5", "--pieces", rule}).code == 2);
  CHECK(simplify({in, out, "--module", "fad", "--pieces", "by-error"}).code == 2);
}
