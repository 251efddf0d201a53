#include "experiment/Store.hh"

#include <fstream>

#include "../report/example.hh"
#include "Folder.hh"
#include "results/json.hh"

using namespace whittle;
namespace fs = std::filesystem;

TEST_CASE("a store loads what it saved") {
  const scratch::Folder folder;
  const bench::Store store(folder.path() / "new");
  CHECK_FALSE(store.load());
  store.save(example::results());
  const auto loaded = store.load();
  REQUIRE(loaded);
  CHECK(bench::json_text(*loaded) == bench::json_text(example::results()));
}

TEST_CASE("a store renames older results to free names") {
  const scratch::Folder folder;
  const bench::Store store(folder.path());
  CHECK_FALSE(store.set_aside());
  store.save(example::results());
  CHECK(store.set_aside() == folder.path() / "results.1.json");
  store.save(example::results());
  CHECK(store.set_aside() == folder.path() / "results.2.json");
  CHECK_FALSE(fs::exists(folder.path() / "results.json"));
}

TEST_CASE("a results file that is cut off is an error that names it") {
  const scratch::Folder folder;
  const bench::Store store(folder.path());
  std::ofstream(folder.path() / "results.json") << "{\"schema\":";
  CHECK_THROWS_WITH(store.load(), Catch::Contains("results.json: not JSON, or cut off"));
  CHECK_THROWS_WITH(bench::read_text(folder.path() / "missing"), Catch::Contains("missing: No such file"));
}

TEST_CASE("a store in an impossible folder is an error at once") {
  CHECK_THROWS(bench::Store("/dev/null/folder"));
}

TEST_CASE("a store resumes only with the same model, protocol, machine and sets") {
  const auto earlier = example::results();
  CHECK(bench::difference(earlier, earlier).empty());
  auto wanted = earlier;
  wanted.environment.date_utc = "later";
  CHECK(bench::difference(earlier, wanted).empty());

  wanted.protocol = "paper";
  CHECK(bench::difference(earlier, wanted) == "the protocol was quick and is now paper");
  wanted = earlier;
  wanted.settings.width = 100;
  CHECK(bench::difference(earlier, wanted) == "the image size was 640x480 and is now 100x480");
  wanted = earlier;
  wanted.environment.gl_renderer = "a card";
  CHECK(bench::difference(earlier, wanted) == "the renderer was llvmpipe and is now a card");
  wanted = earlier;
  wanted.experiments[0].model.triangles = 5;
  CHECK(bench::difference(earlier, wanted) == "in paper1 the model was another");
  wanted = earlier;
  wanted.experiments[1].timing.repetitions = 5;
  CHECK(bench::difference(earlier, wanted) == "in beyond the frames or repetitions were others");
  wanted = earlier;
  wanted.experiments[1].sets[1].definition.recipe = "other";
  CHECK(bench::difference(earlier, wanted) == "in beyond the sets were others");
  wanted = earlier;
  wanted.experiments.pop_back();
  CHECK(bench::difference(earlier, wanted) == "the experiments were others");
}
