#include "model/RecipeEdit.hh"

#include "catch.hh"
#include "model/RecipeText.hh"

using namespace whittle;
using namespace whittle::viewer;

namespace {

const recipe::Scale kScale{0.01, 2};

std::string text(const recipe::Recipe& recipe) {
  return options_text(recipe);
}

}  // namespace

TEST_CASE("every module of the catalogue can be added and run") {
  for (const auto& module : recipe::catalogue()) {
    INFO(module.name);
    recipe::Recipe recipe;
    if (module.role == recipe::Role::constraint) recipe = first_recipe();
    recipe = with_added(recipe, fresh_module(module.name).text());
    CHECK_NOTHROW(recipe::check(recipe));
    CHECK(recipe.target.any() == (module.name == "mq"));  // which goes nowhere without one
  }
}

TEST_CASE("a recipe edit adds, replaces, moves and removes modules") {
  auto recipe = parse_options("vt fad:angle=30");
  recipe = with_added(recipe, "ss:radius=1e");
  CHECK(text(recipe) == "--module vt --module fad:angle=30 --module ss:radius=1e");
  CHECK(text(with_moved(recipe, 0, 2)) == "--module fad:angle=30 --module ss:radius=1e --module vt");
  CHECK(text(with_moved(recipe, 2, 0)) == "--module ss:radius=1e --module vt --module fad:angle=30");
  CHECK(text(with_moved(recipe, 1, 1)) == text(recipe));
  CHECK(text(without(recipe, 1)) == "--module vt --module ss:radius=1e");
  CHECK(text(with_module(recipe, 0, "vtd:distance=1")) ==
        "--module vtd:distance=1 --module fad:angle=30 --module ss:radius=1e");
  CHECK_THROWS_AS(without(recipe, 3), recipe::RecipeError);
  CHECK_THROWS_AS(with_moved(recipe, 0, 3), recipe::RecipeError);
  CHECK_THROWS_AS(with_added(recipe, "none"), recipe::RecipeError);
}

TEST_CASE("a recipe edit sets, changes and removes a value") {
  auto recipe = parse_options("fad:angle=30");
  recipe = with_value(recipe, 0, "pairs", "all");
  recipe = with_value(recipe, 0, "angle", "45");
  CHECK(text(recipe) == "--module fad:angle=45,pairs=all");
  CHECK(text(with_value(recipe, 0, "angle", "")) == "--module fad:pairs=all");
  CHECK_THROWS_AS(with_value(recipe, 0, "angle", "200"), recipe::RecipeError);
  CHECK_THROWS_AS(with_value(recipe, 0, "radius", "1"), recipe::RecipeError);
  CHECK_THROWS_AS(with_value(recipe, 1, "angle", "1"), recipe::RecipeError);
}

TEST_CASE("a length keeps its meaning in every unit") {
  const Length half = recipe::parse_length("0.5e");
  CHECK(half.unit == Unit::edges);
  CHECK(half.in(kScale) == Approx(0.005));
  CHECK(in_unit(half, Unit::model, kScale).text() == "0.005");
  CHECK(in_unit(half, Unit::percent, kScale).text() == "0.25%");
  CHECK(recipe::parse_length("0.25%").in(kScale) == Approx(0.005));
  CHECK(recipe::parse_length("0.005").in(kScale) == 0.005);
  CHECK(recipe::parse_length("1e-3").text() == "0.001");
}

TEST_CASE("every slider runs over values that the key allows") {
  for (const auto& module : recipe::catalogue())
    for (const auto& key : module.keys) {
      if (key.kind == recipe::KeyKind::choice) continue;
      INFO(module.name << " " << key.name);
      const recipe::Slider range = slider_of(key, Unit::model, kScale);
      CHECK(range.low < range.high);
      CHECK(range.low >= key.min);
      CHECK(range.high <= key.max);
      CHECK(range.start >= range.low);
      CHECK(range.start <= range.high);
    }
}

TEST_CASE("a histogram picks the threshold that the module has") {
  CHECK(picked_key(fresh_module("ivdd"), Quantity::edge_length) == "distance");
  CHECK(picked_key(fresh_module("fass"), Quantity::edge_length) == "radius");
  CHECK(picked_key(fresh_module("fass"), Quantity::face_angle) == "angle");
  CHECK(picked_key(fresh_module("edge-length"), Quantity::edge_length) == "length");
  CHECK(picked_key(fresh_module("vt"), Quantity::edge_length).empty());
  CHECK(picked_key(fresh_module("ivdd"), Quantity::face_angle).empty());
}
