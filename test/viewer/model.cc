#include "model/Model.hh"

#include "../programs/Process.hh"
#include "catch.hh"
#include "meshes.hh"
#include "model/Comparer.hh"
#include "model/RecipeText.hh"

using namespace whittle;
using namespace whittle::viewer;
using Catch::Matchers::Contains;

namespace {

std::shared_ptr<const Model> torus_model(const programs::Folder& folder) {
  files::write_mesh(folder / "torus.obj", meshes::torus(40, 24));
  return load_model(folder / "torus.obj");
}

const auto kAlways = [](double) { return true; };

}  // namespace

TEST_CASE("a model without faces is refused, as is a broken one") {
  const programs::Folder folder;
  files::write_file(folder / "points.obj", "v 0 0 0\nv 1 0 0\n");
  files::write_file(folder / "broken.obj", "f 1 2 3\n");
  CHECK_THROWS_WITH(load_model(folder / "points.obj"), Contains("no faces"));
  CHECK_THROWS_AS(load_model(folder / "broken.obj"), files::FileError);
  CHECK_THROWS_AS(load_model(folder / "missing.obj"), files::FileError);
}

TEST_CASE("an outcome is what the recipe gives") {
  const programs::Folder folder;
  const auto model = torus_model(folder);
  const auto recipe = parse_options("ivdd:distance=1.1e");
  const auto outcome = make_outcome(model, recipe);
  const auto result = recipe::run(model->mesh(), recipe);
  CHECK(outcome->mesh().triangles == result.mesh.triangles);
  CHECK(outcome->faces_removed() > 0);
  CHECK(outcome->faces_removed() < 1);
}

TEST_CASE("distances and heat agree") {
  const programs::Folder folder;
  const auto model = torus_model(folder);
  Comparer comparer;
  for (const char* text : {"ivdd:distance=1.1e", "fad:angle=25"}) {
    INFO(text);
    const auto comparison = comparer.compare(make_outcome(model, parse_options(text)), kAlways);
    REQUIRE(comparison);
    REQUIRE(comparison->distance);
    CHECK(comparison->original_heat.size() == model->mesh().points.size());
    CHECK(comparison->result_heat.size() == comparison->outcome->mesh().points.size());
    const float hottest = *std::max_element(comparison->result_heat.begin(), comparison->result_heat.end());
    CHECK(hottest > 0);
    CHECK(double(hottest) <= comparison->distance->two_sided.max * 1.000001);
    CHECK(comparison->heat_top > 0);
    CHECK(comparison->heat_top <= double(hottest));
  }
}

TEST_CASE("a result of an empty plan has no distance to its model") {
  const programs::Folder folder;
  const auto model = torus_model(folder);
  Comparer comparer;
  const auto comparison = comparer.compare(make_outcome(model, parse_options("ivdd:distance=0")), kAlways);
  REQUIRE(comparison->distance);
  CHECK(comparison->distance->two_sided.max < 1e-9);
  CHECK(comparison->heat_top < 1e-9);
}

TEST_CASE("a comparison gives up when it is not wanted") {
  const programs::Folder folder;
  Comparer comparer;
  const auto outcome = make_outcome(torus_model(folder), parse_options("vt"));
  int in_all = 0;
  double last = 0;
  bool rising = true;
  REQUIRE(comparer.compare(outcome, [&](double part) {
    ++in_all;
    rising = rising && part >= last;
    last = part;
    return true;
  }));
  CHECK(rising);
  CHECK(last == Approx(1));
  CHECK(in_all > 100);  // the distance alone has so many blocks: nothing goes on for long
  for (int patience = 0; patience < in_all * 9 / 10; patience += 1 + in_all / 8) {
    int asked = 0;
    CHECK_FALSE(comparer.compare(outcome, [&](double) { return ++asked <= patience; }));
    CHECK(asked == patience + 1);
  }
}

TEST_CASE("meshes without area have numbers but no distance") {
  const programs::Folder folder;
  files::write_file(folder / "line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const auto model = load_model(folder / "line.obj");
  Comparer comparer;
  const auto comparison = comparer.compare(make_outcome(model, parse_options("vt")), kAlways);
  REQUIRE(comparison);
  CHECK_FALSE(comparison->distance);
  CHECK(comparison->inspection.facts.faces == 1);
}
