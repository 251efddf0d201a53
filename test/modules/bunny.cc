/// \file
/// What must hold on the real bunny at the papers' settings.
#include "catch.hh"
#include "files/MeshFile.hh"
#include "measure/Distance.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "planners.hh"
#include "whittle/plan/execute.hh"
#include "whittle/planners/Chain.hh"
#include "whittle/planners/Circumcenter.hh"

using namespace whittle;
using planners::fad, planners::ivdd, planners::ss, planners::vtd;

namespace {

/// A result, how far its faces have turned from what they were in the bunny, and how far it lies off.
struct Outcome {
  Outcome(const IndexedMesh& bunny, const CollapsePlan& plan) : out(execute(plan, bunny)) {
    const SurfaceT<double> before(bunny), after(out.mesh);
    for (std::uint32_t f = 0; f < after.n_faces(); ++f) {
      const double cosine = after.normal(f).normalized().dot(before.normal(out.face_origin[f]).normalized());
      beyond_guard += !(cosine > FlipGuard().min_cos);
      flipped += !(cosine > 0);
    }
    percent_removed = 100 - 100 * double(out.mesh.triangles.size()) / double(bunny.triangles.size());
    distance = measure::distance(bunny, out.mesh, {50000, 0});
  }
  ExecutedT<double> out;
  std::size_t beyond_guard = 0, flipped = 0;
  double percent_removed = 0;
  measure::Distance distance;
};

void check_topology(const IndexedMesh& mesh) {
  const auto facts = measure::facts(mesh);
  CHECK(facts.nonmanifold_edges == 0);
  CHECK(facts.nonmanifold_vertices == 0);
  CHECK(facts.boundary_edges == 0);
  CHECK(facts.euler_characteristic == 2);
  CHECK(facts.duplicate_faces == 0);
}

IndexedMesh read_bunny() {
  try {
    IndexedMesh bunny = files::read_mesh(WHITTLE_ASSETS "/cache/bunny.obj").mesh;
    REQUIRE(bunny.points.size() == 34835);
    REQUIRE(bunny.triangles.size() == 69666);
    return bunny;
  } catch (const files::FileError&) {
    return {};
  }
}

/// Read once.
const IndexedMesh& bunny_or_nothing() {
  static const IndexedMesh bunny = read_bunny();
  if (bunny.points.empty()) tests::skip("assets/fetch.sh bunny has not been run");
  return bunny;
}

template <typename Planner>
void check_set(const Planner& planner, double percent_removed, double mean_error) {
  const IndexedMesh& bunny = bunny_or_nothing();
  if (bunny.points.empty()) return;
  const Outcome outcome(bunny, planner.plan(SurfaceT<double>(bunny)));
  CHECK(outcome.percent_removed == Approx(percent_removed).margin(0.15));
  check_topology(outcome.out.mesh);
  CHECK(measure::facts(outcome.out.mesh).degenerate_faces == 0);
  CHECK(outcome.beyond_guard == 0);
  CHECK(outcome.distance.two_sided.mean < mean_error);
  // Thin places confuse the nearest face.
  CHECK(double(outcome.distance.flipped_faces) <= 2e-4 * double(outcome.out.mesh.triangles.size()));
}

Chain<FaceAngle, SphereScan> fass(double radius, double degrees) {
  return {{fad(degrees), ss(radius)}};
}

}  // namespace

// The percentage of faces removed, and a little more than the mean distance in model units.

TEST_CASE("VT on the bunny", "[bunny]") {
  check_set(Circumcenter(), 55.8, 5.6e-5);
}

TEST_CASE("FAD on the bunny", "[bunny]") {
  check_set(fad(30), 24.7, 1.5e-5);
  check_set(fad(150), 25.3, 1.9e-5);
}

TEST_CASE("IVDD on the bunny", "[bunny]") {
  check_set(ivdd(0.0011), 36.8, 2.1e-5);
  check_set(ivdd(0.0013), 44.1, 2.7e-5);
}

TEST_CASE("SS on the bunny", "[bunny]") {
  check_set(ss(0.0012), 49.3, 3.6e-5);
  check_set(ss(0.0014), 54.7, 4.4e-5);
}

TEST_CASE("SS with quadric placement on the bunny halves the error", "[bunny]") {
  constexpr auto kQuadric = SphereScan::Placement::quadric;
  check_set(ss(0.0012, kQuadric), 49.3, 1.8e-5);
  check_set(ss(0.0014, kQuadric), 54.7, 2.1e-5);
}

TEST_CASE("VTD on the bunny", "[bunny]") {
  check_set(vtd(0.0011), 36.4, 2.1e-5);
  check_set(vtd(0.0013), 43.7, 2.7e-5);
}

TEST_CASE("FASS on the bunny", "[bunny]") {
  check_set(fass(0.0012, 30), 54.4, 3.7e-5);
  check_set(fass(0.0012, 150), 54.6, 4.0e-5);
  check_set(fass(0.0014, 30), 58.7, 4.5e-5);
  check_set(fass(0.0014, 150), 58.8, 4.8e-5);
}

TEST_CASE("VT to the letter without a guard throws vertices far off the bunny", "[bunny]") {
  const IndexedMesh& bunny = bunny_or_nothing();
  if (bunny.points.empty()) return;
  const SurfaceT<double> surface(bunny);
  Circumcenter planner;
  planner.placement = Circumcenter::Placement::circumcenter;
  const Outcome guarded(bunny, planner.plan(surface));
  CHECK(guarded.beyond_guard == 0);
  CHECK(guarded.distance.two_sided.max < 0.01);
  planner.guard.min_cos = -1;
  const Outcome outcome(bunny, planner.plan(surface));
  check_topology(outcome.out.mesh);  // of that, at least, there is no doubt
  CHECK(outcome.flipped == Approx(51).margin(3));
  CHECK(outcome.distance.two_sided.max > 1);  // several times the size of the bunny
}

TEST_CASE("VTD to the letter without a guard turns faces of the bunny over", "[bunny]") {
  const IndexedMesh& bunny = bunny_or_nothing();
  if (bunny.points.empty()) return;
  const SurfaceT<double> surface(bunny);
  Vtd planner = vtd(0.0013);
  planner.fold = Vtd::Fold::literal;
  const Outcome guarded(bunny, planner.plan(surface));
  CHECK(guarded.beyond_guard == 0);
  planner.guard.min_cos = -1;
  const Outcome outcome(bunny, planner.plan(surface));
  check_topology(outcome.out.mesh);
  CHECK(outcome.flipped == Approx(174).margin(5));
  CHECK(outcome.distance.two_sided.mean > 4.2e-5);  // 2.5e-5 by the shortest edge
  CHECK(outcome.distance.two_sided.mean < 4.7e-5);
}
