/// \file
/// The viewer's figures equal the command line's.
#include "Display.hh"
#include "meshes.hh"

using namespace whittle;
using viewing::read_json;

namespace {

/// Compares the numbers that the viewer wrote with those of `whittle simplify` and `whittle measure`.
void check_against_command_line(const viewing::Display& display, const std::string& model,
                                const std::vector<std::string>& options) {
  const auto seen = read_json(display.folder / "numbers.json");
  const std::string out = display.folder / "cli.ply";
  std::vector<std::string> simplify{"simplify", model, out, "--json", display.folder / "simplify.json"};
  simplify.insert(simplify.end(), options.begin(), options.end());
  REQUIRE(programs::run(WHITTLE_PROGRAM, simplify).code == 0);
  REQUIRE(programs::run(WHITTLE_PROGRAM, {"measure", model, out, "--json", display.folder / "measure.json"})
              .code == 0);
  const auto done = read_json(display.folder / "simplify.json"),
             measured = read_json(display.folder / "measure.json");

  CHECK(seen["original"]["mesh"] == measured["original"]["mesh"]);
  CHECK(seen["simplified"]["mesh"] == measured["simplified"]["mesh"]);
  CHECK(seen["distance"] == measured["distance"]);
  CHECK(seen["flipped_faces"] == done["flipped_faces"]);
  CHECK(seen["target_reached"] == done["target_reached"]);
  REQUIRE(seen["stages"].size() == done["stages"].size());
  for (std::size_t i = 0; i < seen["stages"].size(); ++i) {
    auto a = seen["stages"][i], b = done["stages"][i];
    for (const char* time : {"plan_ms", "execute_ms"}) {
      a.erase(time);
      b.erase(time);
    }
    CHECK(a == b);
  }
}

void choose_fass_and_move_a_slider(const std::string& model) {
  const viewing::Display display;
  const auto outcome = display.view(model,
                                    "wait\nmodule fass:radius=0.5e\nwait\nslide 1 radius 0.6 1.1 6\nwait\n"
                                    "numbers '" +
                                        display.folder / "numbers.json" + "'\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(read_json(display.folder / "numbers.json")["recipe"] == "--module fass:radius=1.1e");
  check_against_command_line(display, model, {"--module", "fass:radius=1.1e"});
}

}  // namespace

TEST_CASE("the viewer's numbers of the bunny, FASS and a slider are the command line's") {
  const std::string bunny = WHITTLE_ASSETS "/cache/bunny.obj";
  if (!std::filesystem::exists(bunny)) {
    tests::skip(bunny + " is missing, see assets/README.md");
    return;
  }
  choose_fass_and_move_a_slider(bunny);
}

TEST_CASE("the viewer's numbers of a torus, FASS and a slider are the command line's") {
  const programs::Folder folder;
  files::write_mesh(folder / "torus.ply", meshes::torus(60, 40));
  choose_fass_and_move_a_slider(folder / "torus.ply");
}

TEST_CASE("the viewer's numbers of a chain with a target and a constraint are the command line's") {
  const viewing::Display display;
  const std::string model = display.folder / "torus.obj";
  files::write_mesh(model, meshes::torus(60, 40));
  files::write_file(
      display.folder / "chain.recipe",
      "# a chain\n--module fad:angle=12 --module ivdd --module normal-flipping:angle=60\n--ratio 0.4\n");
  const auto outcome = display.view(model,
                                    "wait\nnumbers '" + display.folder / "numbers.json" +
                                        "'\ncopy-command '" + display.folder / "command.txt" + "'\nclose\n",
                                    {"--recipe", display.folder / "chain.recipe"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  check_against_command_line(display, model,
                             {"--module", "fad:angle=12", "--module", "ivdd", "--module",
                              "normal-flipping:angle=60", "--ratio", "0.4"});

  // The copied command, given to a shell, makes the same mesh.
  std::string command = programs::contents(display.folder / "command.txt");
  REQUIRE(command.rfind("whittle simplify ", 0) == 0);
  command = "cd '" + display.folder / "." + "' && '" WHITTLE_PROGRAM "' " +
            command.substr(8, command.size() - 9) + " --quiet";
  INFO(command);
  REQUIRE(std::system(command.c_str()) == 0);
  CHECK(programs::contents(display.folder / "out.ply") == programs::contents(display.folder / "cli.ply"));
}
