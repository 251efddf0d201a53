#include "experiment/Experiment.hh"

#include <sstream>

#include "catch.hh"
#include "egl/EglContext.hh"
#include "experiment/GeneratedMesh.hh"
#include "experiment/Protocol.hh"
#include "experiment/Views.hh"

using namespace whittle;

namespace {

/// So many sets of one small ball, in an experiment of so many repetitions of two frames.
struct Example {
  IndexedMesh mesh = bench::generated_mesh(4);
  bench::ExperimentResult experiment;
  std::vector<const IndexedMesh*> meshes;
  std::ostringstream log;
  terminal::Progress progress{log, terminal::ProgressStyle::lines};
  std::size_t saved = 0;

  Example(std::size_t sets, std::size_t repetitions) : meshes(sets, &mesh) {
    experiment.name = "paper1";
    experiment.timing = {1, 3, repetitions};
    experiment.sets.resize(sets);
    for (auto& set : experiment.sets) set.triangles = mesh.triangles.size();
  }
  void time(
      std::size_t start = 1, const std::function<bool()>& stop = [] { return false; }) {
    const egl::EglContext context;
    const render::Renderer renderer;
    bench::Settings settings;
    settings.width = settings.height = 32;
    bench::time_sets(renderer, bench::views(mesh, 1).whole, settings, meshes, start, experiment,
                     {progress, [&] { ++saved; }, stop});
  }
};

}  // namespace

TEST_CASE("each repetition begins with another set and visits all") {
  CHECK(bench::visiting_order(3, 0) == std::vector<std::size_t>{0, 1, 2});
  CHECK(bench::visiting_order(3, 1) == std::vector<std::size_t>{1, 2, 0});
  CHECK(bench::visiting_order(3, 5) == std::vector<std::size_t>{2, 0, 1});
}

TEST_CASE("all sets are timed in every repetition, in rotated order, and saved after each visit") {
  Example example(3, 2);
  example.time();
  const std::size_t places[3][2] = {{1, 3}, {2, 1}, {3, 2}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& visits = example.experiment.sets[i].visits;
    REQUIRE(visits.size() == 2);
    for (std::size_t r = 0; r < 2; ++r) {
      CHECK(visits[r].repetition == r + 1);
      CHECK(visits[r].start == 1);
      CHECK(visits[r].visited_as == places[i][r]);
      CHECK(visits[r].wall_ms > 0);
    }
  }
  CHECK(example.saved == 6);
  CHECK(example.log.str().find("[6/6] paper1, repetition 2 of 2") != std::string::npos);

  example.time(2);
  CHECK(example.saved == 6);  // nothing is missing
}

TEST_CASE("time_sets keeps its visits when it is stopped") {
  Example example(2, 1);
  CHECK_THROWS_AS(example.time(1, [&] { return example.saved == 1; }), bench::Stopped);
  CHECK(example.experiment.sets[0].visits.size() == 1);
  CHECK(example.experiment.sets[1].visits.empty());
}

TEST_CASE("an unfinished repetition goes on with the original once more") {
  Example example(3, 2);
  auto& sets = example.experiment.sets;
  sets[0].visits = {{1, 1, 1, 5, {}}};
  sets[1].visits = {{1, 1, 2, 5, {}}};
  CHECK(bench::missing_visits(example.experiment, 1) == std::vector<std::size_t>{0, 2});
  CHECK(bench::missing_visits(example.experiment, 2) == std::vector<std::size_t>{1, 2, 0});
  example.time(2);
  CHECK(sets[0].visits.size() == 3);
  CHECK(sets[0].visits[1].start == 2);
  CHECK(sets[1].visits.size() == 2);
  CHECK(sets[2].visits[0].start == 2);
  CHECK(bench::missing_visits(example.experiment, 1).empty());
}

TEST_CASE("a set without triangles is not timed") {
  Example example(2, 1);
  const IndexedMesh nothing;
  example.meshes[1] = &nothing;
  example.experiment.sets[1].triangles = 0;
  example.time();
  CHECK(example.experiment.sets[0].visits.size() == 1);
  CHECK(example.experiment.sets[1].visits.empty());
}

TEST_CASE("the papers' protocol has the papers' frames and repetitions") {
  auto paper = bench::paper_protocol();
  CHECK(paper.timing("paper1").frames_from == 100);
  CHECK(paper.timing("paper1").frames_timed() == 1000);
  CHECK(paper.timing("paper1").repetitions == 10);
  CHECK(paper.timing("paper2").frames_from == 100);
  CHECK(paper.timing("paper2").frames_timed() == 100);
  CHECK(paper.timing("paper2").repetitions == 10);
}
