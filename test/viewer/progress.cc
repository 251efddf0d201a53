#include "model/progress.hh"

#include <algorithm>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "model/RecipeText.hh"

using namespace whittle;
using namespace whittle::viewer;

namespace {

std::optional<double> part(const std::string& recipe, std::size_t faces) {
  return part_done(parse_options(recipe), {0, 1, faces}, 1000);
}

}  // namespace

TEST_CASE("the progress of a run with a target is known") {
  CHECK(*part("quadric --faces 200", 1000) == 0);
  CHECK(*part("quadric --faces 200", 600) == Approx(0.5));
  CHECK(*part("quadric --ratio 0.5", 500) == 1);
  CHECK(*part("quadric --ratio 0.5", 100) == 1);
  CHECK(*part("quadric --vertices 100", 600) == Approx(0.5));
  CHECK(*part("ivdd:distance=0.5 --ratio 0.5 --module normal-flipping:angle=60", 750) == Approx(0.5));
}

TEST_CASE("the progress of a run without a target, or with a search for a threshold, is unknown") {
  for (const char* recipe :
       {"quadric:max-err=0.1", "ivdd:distance=0.5", "ivdd --ratio 0.5", "mq --ratio 0.5",
        "fad:angle=30 --module ivdd:distance=1 --ratio 0.5", "quadric --faces 2000", ""}) {
    INFO(recipe);
    CHECK_FALSE(part(recipe, 800));
  }
}

TEST_CASE("a run goes from its beginning to its end, never back") {
  const IndexedMesh mesh = meshes::torus(80, 50);
  for (const char* text : {"quadric --ratio 0.2", "quadric --ratio 0.2 --driver decimater"}) {
    const recipe::Recipe recipe = parse_options(text);
    std::vector<double> parts;
    recipe::run(mesh, recipe, [&](const recipe::Progress& now) {
      parts.push_back(*part_done(recipe, now, mesh.triangles.size()));
      return true;
    });
    REQUIRE(parts.size() > 1);
    CHECK(std::is_sorted(parts.begin(), parts.end()));
    CHECK(parts.back() > 0.5);
  }
}
