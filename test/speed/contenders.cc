#include <set>

#include "catch.hh"
#include "meshes.hh"
#include "peers/precision.hh"
#include "speed/rounds.hh"

using namespace whittle;

namespace {

const speed::Subject& torus() {
  static const speed::Subject subject = speed::make_subject("torus", peers::in_float(meshes::torus(24, 16)));
  return subject;
}

speed::Arrays run(const speed::Entry& entry) {
  const auto contender = entry.make();
  speed::Phases phases;
  contender->load(torus());
  contender->decimate(phases);
  return contender->unload();
}

const speed::Entry& find(const std::vector<speed::Entry>& entries, const std::string& name) {
  for (const auto& entry : entries)
    if (entry.name() == name) return entry;
  FAIL("no contender is called " << name);
  return entries.front();
}

}  // namespace

TEST_CASE("contenders have unique names, and --only filters by them") {
  const auto all = speed::lineup(speed::Suite::figures, torus(), std::nullopt);
  std::set<std::string> names;
  for (const auto& entry : all) CHECK(names.insert(entry.name()).second);
  const auto some = speed::lineup(speed::Suite::figures, torus(), std::regex("^bulk|10 %$"));
  for (const auto& entry : some) CHECK((entry.method == "bulk" || entry.target == "10 %"));
  CHECK(some.size() >= 6 + 7);
  CHECK(some.size() < all.size());
}

TEST_CASE("all executors of a planned module give the same mesh") {
  const auto entries = speed::lineup(speed::Suite::figures, torus(), std::nullopt);
  for (const std::string module : {"vt", "fad", "ivdd", "ss", "vtd", "fass"}) {
    const auto bulk = run(find(entries, "bulk " + module));
    CHECK(bulk.triangles.size() < torus().n_faces());
    for (const std::string method : {"sweep ", "lazy ", "DecimaterT "})
      CHECK(speed::checksum(run(find(entries, method + module))) == speed::checksum(bulk));
  }
}

TEST_CASE("every contender with a target comes near it") {
  for (const auto& entry : speed::lineup(speed::Suite::figures, torus(), std::regex("50 %|as "))) {
    INFO(entry.name());
    const auto faces = static_cast<double>(run(entry).triangles.size());
    // The clusterings go by steps of their grids, large ones on so small a mesh; vtkDecimatePro keeps what it
    // takes for features, and McDecimaterT gives up by chance.
    const bool rough = entry.method == "vtkQuadricClustering" || entry.method == "meshopt_simplifySloppy" ||
                       entry.method == "vtkDecimatePro" || entry.method == "McDecimaterT";
    CHECK(faces == Approx(static_cast<double>(entry.target_faces)).epsilon(rough ? 0.3 : 0.02));
  }
}

TEST_CASE("compaction and garbage collection keep the same faces") {
  const auto entries = speed::lineup(speed::Suite::figures, torus(), std::regex("after ivdd"));
  REQUIRE(entries.size() == 2);
  const auto compacted = run(entries[0]), collected = run(entries[1]);
  CHECK(meshes::canonical(compacted) == meshes::canonical(collected));
  CHECK(compacted.triangles.size() < torus().n_faces());
}

TEST_CASE("every contender is timed in every round, scored and counted") {
  std::ostringstream quiet;
  terminal::Progress progress(quiet, terminal::ProgressStyle::silent);
  std::vector<speed::Subject> subjects(1, torus());
  const auto models = speed::run_rounds({speed::Suite::figures, 2, std::nullopt, 500}, subjects, progress);
  REQUIRE(models.size() == 1);
  const auto array_bytes = static_cast<std::int64_t>(torus().array_bytes());
  for (const auto& result : models[0].results) {
    INFO(result.entry.name());
    CHECK(result.seconds.size() == 2);
    CHECK(result.load_seconds.size() == 2);
    CHECK(result.memory.has_value() == result.entry.countable);
    if (result.memory) {
      CHECK(result.memory->peak >= result.memory->loaded);
      if (result.entry.in_place) CHECK(result.memory->loaded == array_bytes);
      if (!result.entry.in_place) CHECK(result.memory->loaded > array_bytes / 2);
    }
    if (result.entry.method == "bulk") {
      if (result.entry.module != "mq") {
        REQUIRE(result.phase_seconds.size() == 3);
        CHECK(result.phase_seconds[1].first == "plan");
        CHECK(result.phase_seconds[1].second.size() == 2);
      }
      REQUIRE(result.score);
      CHECK(result.score->nonmanifold_edges == 0);
      CHECK(result.score->distance->two_sided.max > 0);
    }
  }
}
