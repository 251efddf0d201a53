/// \file
/// Errors are reported, and nothing crashes.
#include "Display.hh"
#include "meshes.hh"

using namespace whittle;
using Catch::Matchers::Contains;

namespace {

/// The viewer ended with 2 and one line.
void check_refusal(const programs::Outcome& outcome, const std::string& reason) {
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK_THAT(outcome.err, Catch::StartsWith("whittle-viewer: ") && Contains(reason));
}

}  // namespace

TEST_CASE("the viewer reports a broken file, one without faces and a missing one, and keeps its model") {
  const viewing::Display display;
  const auto at = [&](const char* name) { return "'" + display.folder / name + "'"; };
  files::write_mesh(display.folder / "torus.ply", meshes::torus(20, 12));
  files::write_file(display.folder / "broken.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  files::write_file(display.folder / "points.obj", "v 0 0 0\n");
  const auto outcome = display.view(
      display.folder / "torus.ply",
      "wait\ndrop " + at("broken.ply") + "\nwait\nscreenshot " + at("error.png") +
          "\nexpect-error broken.ply\ndrop " + at("points.obj") + "\nwait\nexpect-error 'no faces'\nopen " +
          at("missing.off") + "\nwait\nexpect-error missing.off\nresize 640 480\nwait\nnumbers " +
          at("n.json") + "\nclose\n");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(viewing::read_json(display.folder / "n.json")["original"]["mesh"]["faces"] == 480);
}

TEST_CASE("the viewer without a display names the benchmark") {
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  check_refusal(programs::run(WHITTLE_VIEWER_PROGRAM, {}), "whittle-bench");
  ::setenv("DISPLAY", ":nowhere", 1);
  check_refusal(programs::run(WHITTLE_VIEWER_PROGRAM, {}), "whittle-bench");
}

TEST_CASE("the viewer reports an OpenGL that is too old") {
  const viewing::Display display;
  ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
  const auto outcome = programs::run(WHITTLE_VIEWER_PROGRAM, {});
  ::unsetenv("MESA_GL_VERSION_OVERRIDE");
  check_refusal(outcome, "OpenGL");
}

TEST_CASE("bad usage and bad input end the viewer with 2 and one line") {
  const viewing::Display display;
  const std::string shot = display.folder / "a.png", none = display.folder / "none.obj";
  files::write_mesh(display.folder / "torus.ply", meshes::torus(20, 12));
  files::write_file(display.folder / "points.obj", "v 0 0 0\n");
  files::write_file(display.folder / "bad.txt", "wait\nflurb\n");
  const auto run = [](const std::vector<std::string>& arguments) {
    return programs::run(WHITTLE_VIEWER_PROGRAM, arguments);
  };
  check_refusal(run({"--nonsense"}), "--nonsense");
  check_refusal(run({"--screenshot", shot}), "needs a MODEL");
  check_refusal(run({none, "--screenshot", shot}), "none.obj");
  check_refusal(run({display.folder / "points.obj", "--screenshot", shot}), "no faces");
  check_refusal(run({display.folder / "torus.ply", "--screenshot", "/none/a.png"}), "/none");
  check_refusal(run({display.folder / "torus.ply", "--screenshot", shot, "--recipe", "nonsense"}),
                "nonsense");
  check_refusal(run({display.folder / "torus.ply", "--screenshot", shot, "--recipe", "ivdd"}),
                "needs distance");
  check_refusal(run({"--size", "10x", "--screenshot", shot}), "--size");
  check_refusal(run({"--script", display.folder / "bad.txt"}), "bad.txt:2: unknown command 'flurb'");
  check_refusal(display.view("", "open '" + none + "'\nwait\nclose\n"), "unexpected message");
  check_refusal(display.view("", "expect-error x\n"), "there is no message");
  CHECK_FALSE(std::filesystem::exists(shot));
}
