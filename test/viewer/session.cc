#include "model/Session.hh"

#include "../programs/Process.hh"
#include "catch.hh"
#include "meshes.hh"
#include "model/RecipeText.hh"
#include "model/numbers.hh"
#include "model/perform.hh"

using namespace whittle;
using namespace whittle::viewer;
using Catch::Matchers::Contains;

namespace {

template <typename Condition>
void poll_while(Session& session, Condition condition) {
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    session.poll();
  } while (condition());
}

void settle(Session& session) {
  poll_while(session, [&] { return !session.settled(); });
}

/// A session with a torus open.
struct Opened {
  Opened() {
    files::write_mesh(folder / "torus.obj", meshes::torus(40, 24));
    session.open(folder / "torus.obj");
    settle(session);
  }
  programs::Folder folder;
  Session session;
};

}  // namespace

TEST_CASE("a model is opened, decimated and measured") {
  Opened opened;
  REQUIRE(opened.session.model());
  REQUIRE(opened.session.outcome());
  REQUIRE(opened.session.comparison());
  CHECK(opened.session.outcome_is_current());
  const auto json = numbers(opened.session);
  CHECK(json["original"]["mesh"]["faces"] == 1920);
  CHECK(json["simplified"]["faces"] == opened.session.outcome()->mesh().triangles.size());
  CHECK(json["distance"]["two_sided"]["max_units"] > 0);
}

TEST_CASE("all levels of mq come out of one plan, as whittle lods makes them") {
  Opened opened;
  Session& session = opened.session;
  session.set_levels(true);
  CHECK_FALSE(session.levels());  // the first recipe is not mq
  session.change(parse_options("mq --ratio 0.5"));
  CHECK(session.levels());
  settle(session);
  const recipe::Progression progression(session.model()->mesh());
  for (const double ratio : {0.5, 0.3, 0.05, 0.8}) {
    session.change(parse_options("mq --ratio " + std::to_string(ratio)), "slider");
    settle(session);
    REQUIRE(session.outcome_is_current());
    const auto faces = static_cast<std::size_t>(ratio * 1920);
    CHECK(session.outcome()->mesh().triangles == progression.at(faces).mesh.triangles);
    CHECK(session.outcome()->from_levels);
    if (ratio != 0.5) CHECK(session.outcome()->result.stages[0].plan_seconds == 0);
  }
  CHECK_THAT(session.command("a b.ply"),
             Contains("whittle lods") && Contains("--out 'a b.ply'") && Contains("--levels 2 --ratio 0.8"));
  session.set_levels(false);
  CHECK_FALSE(session.outcome_is_current());
  settle(session);
  CHECK_FALSE(session.outcome()->from_levels);
  CHECK_THAT(session.command("a.ply"), Contains("whittle simplify"));
  session.set_levels(true);
  session.change(parse_options("mq --ratio 0.5 --delaunay 20"));
  CHECK_FALSE(session.levels());
}

TEST_CASE("the last of many quick changes wins") {
  Opened opened;
  for (int i = 1; i <= 30; ++i)
    opened.session.change(parse_options("ivdd:distance=" + std::to_string(0.05 * i) + "e"), "slider");
  settle(opened.session);
  CHECK(opened.session.outcome_is_current());
  const auto wanted = recipe::run(opened.session.model()->mesh(), opened.session.recipe());
  CHECK(opened.session.outcome()->mesh().triangles == wanted.mesh.triangles);
  opened.session.undo();
  settle(opened.session);
  CHECK(options_text(opened.session.recipe()) == "--module fass:radius=0.8e");
  CHECK(opened.session.outcome_is_current());
}

TEST_CASE("a recipe that cannot run says why and leaves the result") {
  Opened opened;
  const Outcome* before = opened.session.outcome();
  opened.session.change(parse_options("ivdd"));
  settle(opened.session);
  CHECK_THAT(opened.session.problem(), Contains("needs distance"));
  CHECK(opened.session.outcome() == before);
  CHECK_FALSE(opened.session.outcome_is_current());
  opened.session.change({});
  CHECK_THAT(opened.session.problem(), Contains("no module"));
}

TEST_CASE("a session that is not live shows the plan first and runs on request") {
  Opened opened;
  opened.session.set_live(false);
  opened.session.set_plan_wanted(true);
  const Outcome* before = opened.session.outcome();
  opened.session.change(parse_options("ivdd:distance=1.2e"));
  settle(opened.session);
  REQUIRE(opened.session.plan());
  CHECK(opened.session.plan()->vertices_gone > 0);
  CHECK(opened.session.outcome() == before);
  opened.session.run();
  settle(opened.session);
  CHECK(opened.session.outcome_is_current());
  CHECK(opened.session.model()->mesh().points.size() - opened.session.plan()->vertices_gone ==
        opened.session.outcome()->mesh().points.size());
  opened.session.set_plan_wanted(false);
  CHECK_FALSE(opened.session.plan());
}

TEST_CASE("a broken file is an error, and the old model stays") {
  Opened opened;
  files::write_file(opened.folder / "broken.ply", "ply\nnonsense\n");
  opened.session.open(opened.folder / "broken.ply");
  settle(opened.session);
  REQUIRE(opened.session.errors.size() == 1);
  CHECK_THAT(opened.session.errors.front(), Contains("broken.ply"));
  CHECK_THAT(opened.session.model()->path, Contains("torus.obj"));
  CHECK(opened.session.outcome());
}

TEST_CASE("a session may end in the middle of its work") {
  const programs::Folder folder;
  files::write_mesh(folder / "torus.obj", meshes::torus(200, 100));
  Session session;
  session.open(folder / "torus.obj");
  while (!session.model()) session.poll();
  session.change(parse_options("quadric --ratio 0.1 --driver decimater"));
}

TEST_CASE("the exported mesh is the measured one") {
  Opened opened;
  for (const std::string& extension : files::writable_extensions()) {
    const std::string path = opened.folder / ("a" + extension);
    opened.session.export_result(path, false);
    const auto file = files::read_mesh(path);
    CHECK(file.mesh.triangles.size() == opened.session.outcome()->mesh().triangles.size());
  }
  CHECK_THROWS_AS(opened.session.export_result(opened.folder / "a.xyz", false), files::FileError);
}

TEST_CASE(
    "attributes come through a session's recipe as on the command line, and those left out are reported") {
  const programs::Folder folder;
  const IndexedMesh torus = meshes::torus(40, 24);
  attributes::Attribute colours;
  colours.kind = attributes::Kind::colour;
  colours.components = 3;
  for (const auto& p : torus.points)
    for (const float x : {p.x() > 0 ? 1.0f : 0.0f, 0.5f, 0.25f}) colours.values.push_back(x);
  files::write_mesh(folder / "torus.ply", torus, {}, {colours});
  Session session;
  session.open(folder / "torus.ply");
  settle(session);

  session.begin_export(folder / "a.ply", false);
  settle(session);
  const auto read = files::read_mesh(folder / "torus.ply");
  const auto wanted = recipe::run(read.mesh, session.recipe(), {}, {{}, {}, &read.attributes});
  const auto file = files::read_mesh(folder / "a.ply");
  REQUIRE(file.attributes.size() == 1);
  REQUIRE(wanted.attributes.size() == 1);
  CHECK(file.attributes[0].values == wanted.attributes[0].values);

  session.begin_export(folder / "a.stl", false);
  std::vector<std::string> left_out;
  while (!session.settled()) {
    const News news = session.poll();
    if (!news.written.empty()) left_out = news.left_out;
  }
  CHECK(std::any_of(left_out.begin(), left_out.end(),
                    [](const std::string& line) { return line.find("colour") != std::string::npos; }));
}

TEST_CASE("a result is exported by a worker, which says when it is done and what went wrong") {
  Opened opened;
  opened.session.begin_export(opened.folder / "a.obj", false);
  std::string written;
  while (!opened.session.settled()) {
    const News news = opened.session.poll();
    if (!news.written.empty()) written = news.written;
  }
  CHECK(written == opened.folder / "a.obj");
  CHECK(files::read_mesh(written).mesh.triangles.size() == opened.session.outcome()->mesh().triangles.size());
  opened.session.begin_export("/none/a.ply", false);
  settle(opened.session);
  REQUIRE(opened.session.errors.size() == 1);
  CHECK_THAT(opened.session.errors.front(), Contains("/none"));
}

TEST_CASE("a newer change ends the measurement of the result before it") {
  const programs::Folder folder;
  files::write_mesh(folder / "torus.ply", meshes::torus(180, 100));
  Session session;
  session.open(folder / "torus.ply");
  poll_while(session, [&] { return session.part_done().value_or(0) == 0 && !session.comparison(); });
  session.change(
      parse_options("quadric --ratio 0.1 --driver decimater"));  // takes much longer than measuring
  poll_while(session, [&] { return session.measuring(); });
  CHECK(session.decimating());
  CHECK_FALSE(session.comparison());
  session.change(parse_options("vt"));
  settle(session);
  CHECK(options_text(session.comparison()->outcome->recipe) == "--module vt");
  CHECK(session.outcome_is_current());
}

TEST_CASE("a change to a recipe that cannot run leaves the result, and measures it after all") {
  Opened opened;
  opened.session.change(parse_options("ivdd:distance=1.3e"));
  poll_while(opened.session, [&] { return !opened.session.measuring(); });
  opened.session.change(parse_options("vt"));  // ends the measurement
  opened.session.change(parse_options("ivdd"));
  CHECK_THAT(opened.session.problem(), Contains("needs distance"));
  settle(opened.session);
  REQUIRE(opened.session.comparison());
  CHECK(opened.session.comparison()->outcome.get() == opened.session.outcome());
}

TEST_CASE("a large model and a large result get stand-ins, small ones need none") {
  const programs::Folder folder;
  files::write_mesh(folder / "large.ply", meshes::torus(300, 150));  // 90,000 triangles
  files::write_mesh(folder / "small.ply", meshes::torus(40, 24));
  Session session;
  session.change(parse_options("ivdd:distance=0"));
  session.open(folder / "large.ply");
  settle(session);
  REQUIRE(session.model_stand_in());
  REQUIRE(session.outcome_stand_in());
  CHECK(session.model_stand_in()->triangles.size() <= kStandInTriangles);
  session.change(parse_options("mq --faces 1000"));
  settle(session);
  CHECK(session.model_stand_in());
  CHECK_FALSE(session.outcome_stand_in());
  session.open(folder / "small.ply");
  settle(session);
  CHECK_FALSE(session.model_stand_in());
}

TEST_CASE("commands change session and view") {
  Opened opened;
  View view;
  const auto perform_all = [&](const std::string& text) {
    for (const Command& command : parse_script(text, "s")) CHECK(perform(command, opened.session, view, 1));
  };
  perform_all(
      "module vt\nadd fad:angle=30\nmove 2 1\nset 1 angle 40\ntarget ratio 0.5\ndriver sweep\ndelaunay "
      "20\nbound 0.5%\n");
  CHECK(options_text(opened.session.recipe()) ==
        "--module fad:angle=40 --module vt --ratio 0.5 --max-distance 0.5% --delaunay 20 --driver sweep");
  perform_all("remove 2\ntarget none\ndelaunay off\nbound off\ndriver auto\nundo\nredo\n");
  CHECK(options_text(opened.session.recipe()) == "--module fad:angle=40");
  perform_all(
      "layout split\nshading flat\nheat on\nheat-top 0.5\nedges feature on\nfeature-angle 50\nsplit "
      "0.1\nplan on\n");
  CHECK(view.layout == Layout::split);
  CHECK(view.shading == Shading::flat);
  CHECK(view.heat);
  CHECK(view.heat_top == 0.5);
  CHECK(view.shows(EdgeSet::feature));
  CHECK(view.feature_angle == 50);
  CHECK(view.split == 0.1);
  CHECK(view.plan);
  perform_all("save-recipe '" + opened.folder / "a.recipe" + "'\nmodule vt\nrecipe '" +
              opened.folder / "a.recipe" + "'\n");
  CHECK(options_text(opened.session.recipe()) == "--module fad:angle=40");
  for (const char* bad :
       {"layout x", "shading x", "edges x on", "set 9 angle 3", "set 1 angle 300", "module x", "target half",
        "target ratio x", "driver x", "recipe /none", "export /none/a.ply"})
    CHECK_THROWS_AS(perform(parse_script(bad, "s")[0], opened.session, view, 1), ScriptError);
  CHECK_FALSE(perform(parse_script("close", "s")[0], opened.session, view, 1));
}
