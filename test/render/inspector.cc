#include "experiment/Inspector.hh"

#include "Folder.hh"
#include "egl/EglContext.hh"
#include "experiment/GeneratedMesh.hh"

using namespace whittle;
namespace fs = std::filesystem;

namespace {

/// A small ball, an experiment on it, and an inspector.
struct Example {
  egl::EglContext context;
  scratch::Folder folder;
  IndexedMesh ball = bench::generated_mesh(8);
  bench::Settings settings{64, 32, 14, 500};
  bench::ExperimentResult experiment;

  Example() {
    experiment.name = "paper1";
    experiment.model.label = "a ball";
    experiment.heat_scale = 1e-4;
  }
  bench::SetResult inspect(const bench::SetDefinition& definition, const bench::MadeSet& made) {
    bench::SetResult set;
    set.definition = definition;
    bench::Inspector(ball, settings, experiment, folder.path()).inspect(set, made);
    return set;
  }
};

const bench::SetDefinition kVt = {"vt", "VT", "VT", "", "vt", "", bench::Role::paper};

}  // namespace

TEST_CASE("a set that is the original itself has no error in any view") {
  Example example;
  const auto set = example.inspect(kVt, {example.ball, 1.5, 2});
  CHECK(set.made);
  CHECK(set.triangles == example.ball.triangles.size());
  CHECK(set.flipped_faces == 2);
  CHECK(set.decimation_ms == 1.5);
  REQUIRE(set.fidelity);
  CHECK(set.fidelity->max == Approx(0).margin(1e-9));
  CHECK(set.fidelity->psnr_worst_db == 99);
  CHECK(set.fidelity->ssim_worst == Approx(1));
  for (const auto& name : {set.pictures.whole, set.pictures.detail, set.pictures.heat})
    CHECK(fs::file_size(example.folder.path() / name) > 100);
}

TEST_CASE("the original has pictures but nothing to be compared with") {
  Example example;
  const auto set =
      example.inspect({"original", "Original", "", "", "", "", bench::Role::paper}, {example.ball, 0, 0});
  CHECK_FALSE(set.fidelity);
  CHECK(set.pictures.whole == "pictures/paper1-original-whole.png");
  CHECK(set.pictures.heat.empty());
}

TEST_CASE("a mesh without triangles, or without area, is noted and not measured") {
  Example example;
  CHECK(example.inspect(kVt, {}).note == "nothing is left to draw");
  const auto set = example.inspect(kVt, {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, 0, 0});
  CHECK(set.note == "only triangles without area are left");
  CHECK(set.made);
  CHECK_FALSE(set.fidelity);
}

TEST_CASE("an order for the cache is neither measured nor pictured again") {
  Example example;
  const auto set =
      example.inspect({"vt-cached", "vt", "", "", "", "vt", bench::Role::cache}, {example.ball, 0, 0});
  CHECK_FALSE(set.fidelity);
  CHECK(set.pictures.whole.empty());
  CHECK(set.cache_misses_per_triangle > 0.5);
}

TEST_CASE("all fourteen views see the model whole and from different sides") {
  const auto ball = bench::generated_mesh(4);
  const auto cameras = bench::views_around(ball, bench::kMostViews);
  REQUIRE(cameras.size() == 14);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    CHECK(cameras[i].view.allFinite());
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(cameras[i].view.isApprox(cameras[k].view, 1e-6));
    for (const auto& point : ball.points) {
      const Eigen::Vector3d p = (cameras[i].projection * cameras[i].view * point.homogeneous()).hnormalized();
      REQUIRE(p.cwiseAbs().maxCoeff() <= 1);
    }
  }
}
