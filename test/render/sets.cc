#include "experiment/Sets.hh"

#include <algorithm>
#include <set>

#include "catch.hh"
#include "experiment/GeneratedMesh.hh"
#include "experiment/Peers.hh"
#include "experiment/SetMaker.hh"
#include "recipe/Recipe.hh"

using namespace whittle;

TEST_CASE("the original is always among the chosen sets, and they keep the paper's order") {
  const auto all = bench::choose_sets({});
  CHECK(all.size() == 14);
  CHECK(all.front().original());
  CHECK(bench::choose_sets({"vt", "all"}).size() == 14);

  const auto some = bench::choose_sets({"fass-0.0014-150", "ivdd-0.0011", "fad-30"});
  REQUIRE(some.size() == 4);
  CHECK(some[0].name == "original");
  CHECK(some[1].recipe == "fad:angle=30");
  CHECK(some[2].recipe == "ivdd:distance=0.0011");
  CHECK(some[3].recipe == "fass:radius=0.0014,angle=150");
  CHECK(bench::choose_sets({"original"}).size() == 1);
}

TEST_CASE("the fourteen sets of Paper 1 have names of their own, which say the recipe") {
  for (const auto& set : bench::paper1_sets()) {
    INFO(set.name);
    CHECK(bench::choose_sets({set.name}).back().name == set.name);
    // "fass-0.0012-30": the module, then its values in order.
    std::string values = set.recipe.substr(0, set.recipe.find(':'));
    for (auto equals = set.recipe.find('='); equals != std::string::npos;
         equals = set.recipe.find('=', equals + 1))
      values += "-" + set.recipe.substr(equals + 1, set.recipe.find(',', equals) - equals - 1);
    CHECK(values == (set.original() ? "" : set.name));
  }
}

TEST_CASE("an unknown set is an error that lists those there are") {
  CHECK_THROWS_WITH(bench::choose_sets({"fad-31"}),
                    Catch::Contains("\"fad-31\"") && Catch::Contains("fad-30, "));
}

TEST_CASE("in every experiment names are unique, recipes mean something and comparisons lead somewhere") {
  for (const auto& sets :
       {bench::paper1_sets(), bench::paper2_sets(), bench::beyond_sets({{"meshopt", "m"}})}) {
    std::set<std::string> names;
    for (const auto& set : sets) names.insert(set.name);
    CHECK(names.size() == sets.size());
    CHECK(sets.front().original());
    for (const auto& set : sets) {
      INFO(set.name);
      CHECK((set.compared_with.empty() || names.count(set.compared_with) == 1));
      if (set.role == bench::Role::peer || set.recipe.empty()) continue;
      CHECK_NOTHROW(recipe::check(bench::recipe_of(set)));
      CHECK(bench::recipe_of(set).refit.has_value() == (set.algorithm.find("refitted") != std::string::npos));
    }
  }
}

TEST_CASE("every paper's set decimates the stand-in") {
  const auto mesh = bench::generated_mesh(20);
  bench::SetMaker maker(mesh);
  for (const auto& definition : bench::paper1_sets()) {
    INFO(definition.name);
    const auto& made = maker.make(definition, {});
    if (definition.original()) {
      CHECK(made.mesh.points == mesh.points);
      CHECK(made.mesh.triangles == mesh.triangles);
    } else {
      CHECK(made.mesh.triangles.size() < mesh.triangles.size());
      CHECK_FALSE(made.mesh.triangles.empty());
      CHECK(made.flipped_faces == 0);
    }
  }
}

TEST_CASE("a peer's set has the triangles of the set that it is compared with, a cache set its triangles") {
  const auto mesh = bench::generated_mesh(20);
  bench::SetMaker maker(mesh);
  std::vector<bench::PeerName> names;
  for (const auto& peer : bench::peers()) names.push_back({peer.name, peer.label});
  const auto all = bench::beyond_sets(names);
  const auto find = [&](const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const auto& set) { return set.name == name; });
  };
  const std::size_t triangles = maker.make(find("vt"), all).mesh.triangles.size();
  for (const auto& peer : bench::peers()) {
    INFO(peer.name);
    CHECK(maker.make(find(peer.name + "-as-vt"), all).mesh.triangles.size() == triangles);
  }
  CHECK(maker.make(find("vt-cached"), all).mesh.triangles.size() == triangles);
  CHECK(maker.make(find("original-cached"), all).mesh.triangles.size() == mesh.triangles.size());

  auto lost = find("vt-cached");
  lost.compared_with = "nothing";
  CHECK_THROWS_WITH(maker.make(lost, all), "there is no set \"nothing\" to compare with");
  auto unknown = find("meshopt-as-vt");
  unknown.recipe = "peer:nobody";
  CHECK_THROWS_WITH(maker.make(unknown, all), Catch::Contains("\"nobody\""));
}
