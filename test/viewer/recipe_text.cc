#include "model/RecipeText.hh"

#include "../programs/Process.hh"
#include "catch.hh"
#include "files/MeshFile.hh"

using namespace whittle;
using namespace whittle::viewer;
using Catch::Matchers::Contains;

TEST_CASE("a recipe is written as options and read back") {
  const std::string text =
      "--module fad:angle=30 --module ivdd:distance=0.8e --module normal-flipping:angle=45 --ratio 0.5 "
      "--delaunay 20 --driver sweep";
  CHECK(options_text(parse_options(text)) == text);
  CHECK(options_text(parse_options("--module vt --faces 100")) == "--module vt --faces 100");
  CHECK(options_text(parse_options("--module vt --vertices 7")) == "--module vt --vertices 7");
  for (const std::string more : {"", " --refit", " --no-refit"})
    CHECK(options_text(parse_options("--module mq --ratio 0.5" + more)) == "--module mq --ratio 0.5" + more);
}

TEST_CASE("bare specifications, comments and whole commands are understood") {
  CHECK(options_text(parse_options("fass:radius=0.8e")) == "--module fass:radius=0.8e");
  CHECK(options_text(parse_options("# why\nvt # this\nfad:angle=20")) == "--module vt --module fad:angle=20");
  CHECK(options_text(parse_options(
            "whittle simplify 'my model.obj' out.ply --module vt --json - --quiet --ratio=0.5")) ==
        "--module vt --ratio 0.5");
}

TEST_CASE("the command names both files, quoted for a shell") {
  CHECK(command_text(parse_options("ivdd:distance=0.5%"), "my model.obj", "out.ply") ==
        "whittle simplify 'my model.obj' out.ply --module ivdd:distance=0.5%");
}

TEST_CASE("text that is no recipe is refused with a reason") {
  CHECK_THROWS_WITH(parse_options("--modul vt"), Contains("unknown option '--modul'"));
  CHECK_THROWS_WITH(parse_options("--module"), Contains("needs a value"));
  CHECK_THROWS_WITH(parse_options("nonsense"), Contains("unknown module 'nonsense'"));
  CHECK_THROWS_WITH(parse_options("--faces 1.5"), Contains("whole number"));
  CHECK_THROWS_WITH(parse_options("--faces 0"), Contains("at least 1"));
  CHECK_THROWS_WITH(parse_options("--ratio x"), Contains("not a number"));
  CHECK_THROWS_AS(parse_options("'vt"), recipe::RecipeError);
}

TEST_CASE("a recipe file is saved and loaded") {
  const programs::Folder folder;
  const auto recipe = parse_options("fad:angle=30 ivdd:distance=0.8e --ratio 0.25");
  save_recipe(folder / "a.recipe", recipe);
  CHECK(options_text(load_recipe(folder / "a.recipe")) == options_text(recipe));
  CHECK_THROWS_AS(load_recipe(folder / "none.recipe"), files::FileError);
  files::write_file(folder / "bad.recipe", "nonsense\n");
  CHECK_THROWS_WITH(load_recipe(folder / "bad.recipe"), Contains("bad.recipe: unknown module"));
}
