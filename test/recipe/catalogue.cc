#include "recipe/Catalogue.hh"

#include "catch.hh"
#include "meshes.hh"
#include "recipe/Recipe.hh"
#include "text/number.hh"

using namespace whittle;
using namespace whittle::recipe;

namespace {

/// Values that a key takes, from one end to the other.
std::vector<std::string> values(const Key& key) {
  if (key.kind == KeyKind::choice) return key.choices;
  if (key.kind == KeyKind::length) return {"0", "0.001", "0.8e", "0.5%"};
  return {text::shortest(key.min), text::shortest(std::min(key.max, 1e6))};
}

Recipe recipe_with(const Module& module, double ratio) {
  Recipe recipe;
  if (module.role == Role::constraint) recipe.modules.push_back(parse_spec("vt"));
  recipe.modules.push_back(parse_spec(module.name));
  recipe.target.ratio = ratio;
  return recipe;
}

}  // namespace

TEST_CASE("catalogue: every entry has words, and names only keys that it has") {
  for (const Module& module : catalogue()) {
    INFO(module.name);
    CHECK_FALSE(module.meaning.empty());
    CHECK(&find_module(module.name) == &module);
    CHECK((module.role == Role::planned) == bool(module.make_planner));
    CHECK((module.role != Role::planned) == bool(module.add));
    if (!module.threshold.empty()) CHECK(module.find(module.threshold) != nullptr);
    if (!module.bound.empty()) CHECK(module.find(module.bound)->kind == KeyKind::length);
    for (const Key& key : module.keys) {
      INFO(key.name);
      CHECK_FALSE(key.meaning.empty());
      CHECK_FALSE(key.fallback.empty());
      CHECK(module.find(key.name) == &key);
      if (!key.instead_of.empty()) CHECK(module.find(key.instead_of) != nullptr);
      if (key.kind == KeyKind::choice)
        CHECK(key.choices.size() >= 2);
      else
        CHECK(key.min < key.max);
    }
  }
}

TEST_CASE("catalogue: every key of every module parses and reaches the module") {
  for (const Module& module : catalogue())
    for (const Key& key : module.keys)
      for (const std::string& value : values(key)) {
        const std::string text = module.name + ":" + key.name + "=" + value;
        INFO(text);
        const Spec spec = parse_spec(text);
        CHECK(spec.text() == text);
        if (module.make_planner && text != module.name + ":area=0")
          CHECK_NOTHROW(module.make_planner(spec, {0.5, 20}, {}));
      }
}

TEST_CASE("catalogue: every module runs to a target, and planned ones show their plan before") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.003, 1);
  for (const Module& module : catalogue()) {
    INFO(module.name);
    const Recipe recipe = recipe_with(module, 0.8);
    const std::size_t left = run(mesh, recipe).mesh.triangles.size();
    CHECK(left <= mesh.triangles.size());
    if (module.role != Role::constraint) CHECK(left < mesh.triangles.size());  // these may forbid everything
    CHECK(plan(mesh, recipe).collapses.empty() == (module.role == Role::priority));
  }
}

TEST_CASE("catalogue: a module that has no end by itself is refused without a target") {
  for (const Module& module : catalogue()) {
    INFO(module.name);
    Recipe recipe = recipe_with(module, 0.5);
    recipe.target = {};
    if (module.ends_by_itself || module.role == Role::constraint) {
      CHECK_NOTHROW(check(recipe));
      continue;
    }
    CHECK_THROWS_AS(check(recipe), RecipeError);
    if (module.threshold.empty()) continue;
    recipe.modules = {with_threshold(recipe.modules.front(), 1)};
    CHECK(has_threshold(recipe.modules.front()));
    CHECK_NOTHROW(check(recipe));
  }
}

TEST_CASE("catalogue: another key can say the same as the threshold") {
  CHECK(has_threshold(parse_spec("fad:included=150")));
  CHECK_FALSE(has_threshold(parse_spec("fad:pairs=all")));
  CHECK_FALSE(has_threshold(parse_spec("fass:included=150")));  // its threshold is the radius
  CHECK_FALSE(has_threshold(parse_spec("mq:feature=40")));
}

TEST_CASE("catalogue: its help names every module and key with the default") {
  const std::string help = catalogue_help();
  for (const Module& module : catalogue()) {
    CHECK(help.find("  " + module.name + ": " + module.meaning) != std::string::npos);
    for (const Key& key : module.keys) CHECK(help.find(key.help()) != std::string::npos);
  }
  CHECK(help.find("angle=NUMBER  largest angle between face normals, degrees; 30\n") != std::string::npos);
}
