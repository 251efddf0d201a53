#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "TorusFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using programs::TorusFile;
using programs::whittle_program;

namespace {

Json simplified(const TorusFile& in, std::vector<std::string> more, int code = 0) {
  std::vector<std::string> arguments{"simplify", in.path, in.folder / "out.ply", "--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto done = whittle_program(arguments);
  INFO(done.err);
  REQUIRE(done.code == code);
  return Json::parse(done.out);
}

IndexedMesh result(const TorusFile& in) {
  return files::read_mesh(in.folder / "out.ply").mesh;
}

}  // namespace

TEST_CASE("a bound by --max-distance is kept and reported, with and without a target") {
  const TorusFile in;
  for (const std::string module : {"mq", "vt"}) {
    INFO(module);
    const Json json = simplified(in, {"--max-distance", "0.5%", "--samples", "9000", "--module", module});
    const double bound = json["max_distance"]["bound_units"];
    CHECK(double(json["max_distance"]["reached_units"]) <= bound);
    CHECK(measure::distance(in.mesh, result(in), {9000, 0}).two_sided.max <= bound * (1 + 1e-6));
  }
  const Json missed = simplified(in, {"--max-distance", "0.1%", "--samples", "9000", "--faces", "10"}, 1);
  CHECK(missed["target_reached"] == false);
  CHECK(missed["target_missed_because"][0] == "the bound on the distance allows no more");
}

TEST_CASE("a lock keeps a selection, and names what is wrong with one") {
  const TorusFile in;
  const std::string list = in.folder / "keep.txt";
  std::ofstream(list) << "# first hundred\n";
  for (int v = 0; v < 100; ++v) std::ofstream(list, std::ios::app) << v << (v % 10 == 9 ? "\n" : " ");
  const Json json =
      simplified(in, {"--ratio", "0.2", "--lock", "selection:" + list, "--map", in.folder / "map"});
  CHECK(json["vertices_locked"] == 100);
  std::istringstream map(programs::contents(in.folder / "map"));
  std::vector<std::size_t> became;
  for (std::size_t v; map >> v;) became.push_back(v);
  REQUIRE(became.size() == in.mesh.points.size());
  const auto out = result(in);
  for (std::size_t v = 0; v < 100; ++v) CHECK((out.points[became[v]] - in.mesh.points[v]).norm() < 1e-12);

  for (const std::string& bad : {"selection:" + list, std::string("selection:none.txt"),
                                 std::string("everything"), std::string("feature:200")}) {
    std::ofstream(list) << "1\n2 x\n";
    const auto done =
        whittle_program({"simplify", in.path, in.folder / "o.ply", "--ratio", "0.5", "--lock", bad});
    INFO(bad << done.err);
    CHECK(done.code == 2);
    CHECK(done.error_lines() == 1);
  }
  CHECK_THAT(whittle_program(
                 {"simplify", in.path, in.folder / "o.ply", "--ratio", "0.5", "--lock", "selection:" + list})
                 .err,
             Contains("keep.txt:2: 'x' is not the number of a vertex"));
}

TEST_CASE("a flat grid keeps all its area with every module, and a locked boundary stays") {
  programs::Folder folder;
  const IndexedMesh grid = meshes::flat_grid(60);
  files::write_mesh(folder / "grid.ply", grid);
  const double whole = measure::facts(grid).area;
  for (const std::string module : {"mq", "quadric", "fad:boundary=merge", "ivdd:boundary=merge",
                                   "ss:boundary=merge", "vtd:boundary=merge", "fass:boundary=merge", "vt"}) {
    const auto done = whittle_program({"simplify", folder / "grid.ply", folder / "out.ply", "--module",
                                       module, "--faces", "200", "--json", folder / "out.json"});
    const Json json = Json::parse(programs::contents(folder / "out.json"));
    const auto out = files::read_mesh(folder / "out.ply").mesh;
    INFO(module << " " << out.triangles.size() << done.err);
    CHECK(json["flipped_faces"] == 0);
    if (module.find("merge") == std::string::npos) {
      CHECK(measure::facts(out).area == Approx(whole).epsilon(1e-6));
      CHECK((out.triangles.size() <= 200 || module == "vt"));
    }
  }
  REQUIRE(whittle_program(
              {"simplify", folder / "grid.ply", folder / "out.ply", "--ratio", "0.3", "--lock", "boundary"})
              .code == 0);
  CHECK(measure::facts(files::read_mesh(folder / "out.ply").mesh).boundary_edges == 4 * 59);
}

TEST_CASE("attributes come through simplify, and those that a format cannot hold are reported") {
  programs::Folder folder;
  std::ofstream obj(folder / "grid.obj");
  constexpr int n = 20;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      obj << "v " << i << " " << j << " 0\n";
      obj << "vt " << i / double(n - 1) << " " << j / double(n - 1) << "\n";
    }
  obj << "vn 0 0 1\n";
  const auto corner = [](int v) { return std::to_string(v) + "/" + std::to_string(v) + "/1 "; };
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int v = j * n + i + 1;
      obj << "f " << corner(v) << corner(v + 1) << corner(v + n + 1) << corner(v + n) << "\n";
    }
  obj.close();
  const auto done = whittle_program({"simplify", folder / "grid.obj", folder / "out.obj", "--ratio", "0.3"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto out = files::read_mesh(folder / "out.obj");
  REQUIRE(out.attributes.size() == 2);
  for (const auto& attribute : out.attributes)
    for (std::size_t f = 0; f < out.mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const float* value = attribute.value(attribute.at(out.mesh, f, k));
        const auto& p = out.mesh.points[out.mesh.triangles[f][k]];
        if (attribute.kind == attributes::Kind::normal)
          CHECK(value[2] == Approx(1));
        else
          CHECK(value[0] == Approx(p.x() / (n - 1)).margin(1e-4));
      }
  const auto stl = whittle_program({"simplify", folder / "grid.obj", folder / "out.stl", "--ratio", "0.3"});
  CHECK(stl.code == 0);
  CHECK_THAT(stl.err, Contains("texture coordinates"));
}

TEST_CASE("the option --weights keeps detail, and a missing property is refused") {
  programs::Folder folder;
  const IndexedMesh mesh = meshes::shaken(meshes::torus(48, 28), 0.003, 1);
  attributes::Attribute importance{attributes::Kind::scalar, "importance", 1, false, false, {}, {}};
  for (const auto& p : mesh.points) importance.values.push_back(p.x() < 0 ? 10.0f : 1.0f);
  files::write_mesh(folder / "in.ply", mesh, {}, {importance});
  const auto left = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simplify", folder / "in.ply", folder / "out.ply"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto done = whittle_program(arguments);
    INFO(done.err);
    REQUIRE(done.code == 0);
    const auto out = files::read_mesh(folder / "out.ply");
    CHECK(out.attributes.size() == 1);
    return std::count_if(out.mesh.points.begin(), out.mesh.points.end(),
                         [](const auto& p) { return p.x() < 0; });
  };
  for (const std::string module : {"ivdd", "ss", "quadric", "mq"}) {
    INFO(module);
    CHECK(double(left({"--module", module, "--faces", "900", "--weights", "importance"})) >
          1.2 * double(left({"--module", module, "--faces", "900"})));
  }
  const auto none =
      whittle_program({"simplify", folder / "in.ply", folder / "o.ply", "--ratio", "0.5", "--weights", "x"});
  CHECK(none.code == 2);
  CHECK_THAT(none.err, Contains("no vertex property 'x'; there are importance"));
}

TEST_CASE("whittle reads standard input and writes standard output") {
  const TorusFile in;
  const std::string command = "'" WHITTLE_PROGRAM "' simplify - - --format ply --ratio 0.5 <'" + in.path +
                              "' >'" + in.folder / "out.ply" + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(result(in).triangles.size() == 1344);
}

TEST_CASE("the program describes itself") {
  const auto version = whittle_program({"--version"});
  CHECK_THAT(version.out, Contains("commit") && Contains("OpenMesh 9") && Contains("Eigen 3"));
  const auto manual = whittle_program({"manual"});
  CHECK(manual.code == 0);
  for (const char* word :
       {".TH WHITTLE 1", "whittle simplify", "whittle batch", "max\\-distance", ".SH EXIT STATUS"})
    CHECK_THAT(manual.out, Contains(word));
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const auto completion = whittle_program({"completion", shell});
    CHECK(completion.code == 0);
    CHECK_THAT(completion.out, Contains("max-distance") && Contains("simplify") && Contains("ivdd"));
  }
  CHECK(whittle_program({"completion", "cmd"}).code == 2);
  const TorusFile in;
  std::ofstream(in.folder / "try.sh")
      << "source <('" WHITTLE_PROGRAM
         "' completion bash)\n"
         "COMP_WORDS=(whittle sim); COMP_CWORD=1; _whittle; echo \"${COMPREPLY[@]}\"\n"
         "COMP_WORDS=(whittle simplify --max); COMP_CWORD=2; _whittle; echo \"${COMPREPLY[@]}\"\n"
         "COMP_WORDS=(whittle simplify --module f); COMP_CWORD=3; _whittle; echo \"${COMPREPLY[@]}\"\n";
  const auto tried = programs::run("/bin/bash", {in.folder / "try.sh"});
  CHECK(tried.out == "simplify\n--max-distance\nfad fass\n");
}
