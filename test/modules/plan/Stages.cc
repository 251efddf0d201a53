#include "whittle/plan/Stages.hh"

#include <numeric>
#include <random>

#include "catch.hh"
#include "meshes.hh"
#include "planners.hh"
#include "stages.hh"
#include "whittle/planners/Circumcenter.hh"

using namespace whittle;
using Eigen::Vector3d;
using meshes::IndexedMesh;
using meshes::Merges;
using Surface = SurfaceT<double>;
using Stages = StagesT<double>;
using planners::fad, planners::ivdd, planners::ss;
using stages::check_same, stages::kNever, stages::some_extras, stages::some_mesh;

namespace {

/// A planner that merges two vertices at a place, whatever they are called in its surface.
struct MergeAt {
  std::uint32_t to, from;
  Vector3d target;
  double min_cos;

  CollapsePlan plan(const Surface& surface) const {
    PlanDraftT<double> draft(surface, {min_cos});
    draft.count_refusal(draft.merge({to, from}, target));
    return draft.take();
  }
};

/// Stages carried out one by one, each on a mesh of its own.
struct ByHand {
  explicit ByHand(const IndexedMesh& input, SurfaceExtras given) : mesh(input), extras(std::move(given)) {
    vertex.resize(mesh.points.size());
    std::iota(vertex.begin(), vertex.end(), 0u);
    const Surface surface(mesh);
    for (std::uint32_t f = 0; f < surface.n_faces(); ++f)
      extras.reference_normals.push_back(surface.normal(f));
  }

  template <typename Planner>
  void add(const Planner& planner) {
    const CollapsePlan plan = planner.plan(Surface(mesh, extras));
    for (Collapse c : plan.collapses) {
      c.from = vertex[c.from];
      c.to = vertex[c.to];
      collapses.push_back(c);
    }
    const auto out = execute(plan, mesh);
    SurfaceExtras next;
    std::vector<std::uint32_t> standing;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (!out.survives[v]) continue;
      standing.push_back(vertex[v]);
      if (!extras.flags.empty()) next.flags.push_back(extras.flags[v]);
      if (!extras.tolerance.empty()) next.tolerance.push_back(extras.tolerance[v]);
    }
    for (const std::uint32_t f : out.face_origin)
      next.reference_normals.push_back(extras.reference_normals[f]);
    extras = std::move(next);
    vertex = std::move(standing);
    mesh = out.mesh;
  }

  IndexedMesh mesh;
  SurfaceExtras extras;
  std::vector<std::uint32_t> vertex;
  std::vector<Collapse> collapses;
};

}  // namespace

TEST_CASE("stages are planned each on the outcome of the one before, in the input's indices") {
  const IndexedMesh mesh = some_mesh();
  for (const bool with_extras : {false, true}) {
    const SurfaceExtras extras = with_extras ? some_extras(mesh) : SurfaceExtras();
    ByHand hand(mesh, extras);
    const Surface surface(mesh, extras);
    Stages stages(surface);
    std::vector<std::size_t> begins;
    const auto add = [&](const auto& planner) {
      begins.push_back(hand.collapses.size());
      hand.add(planner);
      CHECK(stages.add(planner) == hand.collapses.size() - begins.back());
      REQUIRE(hand.collapses.size() > begins.back());
      CHECK(stages.n_faces() == hand.mesh.triangles.size());
      CHECK(stages.n_vertices() == hand.mesh.points.size());
    };
    add(fad(20));
    add(ss(0.12));
    add(ivdd(0.25));
    add(Circumcenter());

    const CollapsePlan plan = stages.take();
    check_same(plan.collapses, hand.collapses);
    CHECK(plan.stages == begins);
    const auto out = execute(plan, mesh);
    CHECK(out.mesh.points == hand.mesh.points);
    CHECK(out.mesh.triangles == hand.mesh.triangles);
  }
}

TEST_CASE("a second stage names vertices as the input does") {
  // FAD takes the tip 0 of the first cone, so that the second one's tip, 7, is 6 for the next stage.
  IndexedMesh mesh = meshes::cone(6, 0.1);
  const IndexedMesh steep = meshes::cone(6, 1);
  for (const Vector3d& p : steep.points) mesh.points.emplace_back(p + Vector3d(5, 0, 0));
  for (const auto& t : steep.triangles) mesh.triangles.push_back({t[0] + 7, t[1] + 7, t[2] + 7});
  const Surface surface(mesh);
  Stages stages(surface);
  REQUIRE(stages.add(fad(30)) == 1);
  CHECK(stages.n_faces() == 10);
  CHECK(stages.n_vertices() == 13);
  REQUIRE(stages.add(fad(60)) == 1);
  CHECK(stages.n_faces() == 8);
  CHECK(stages.n_vertices() == 12);
  const CollapsePlan plan = stages.take();
  CHECK(plan.collapses[0].from == 0);
  CHECK(plan.collapses[0].to <= 6);
  CHECK(plan.collapses[1].from == 7);
  CHECK(plan.collapses[1].to >= 8);
  CHECK(plan.stages == std::vector<std::size_t>{0, 1});
  CHECK(plan.record.planned == 2);
}

TEST_CASE("a stage without a collapse adds no stage") {
  const IndexedMesh mesh = meshes::torus(12, 9);
  const Surface surface(mesh);
  Stages stages(surface);
  const std::size_t first = stages.add(ivdd(0.2));
  REQUIRE(first > 0);
  CHECK(stages.add(ivdd(0)) == 0);
  const std::size_t third = stages.add(ivdd(0.4));
  REQUIRE(third > 0);
  CHECK(stages.add(ss(0)) == 0);
  const CollapsePlan plan = stages.take();
  CHECK(plan.stages == std::vector<std::size_t>{0, first});
  CHECK(plan.collapses.size() == first + third);
}

TEST_CASE("a plan of one stage is the planner's own") {
  const IndexedMesh mesh = some_mesh();
  const Surface surface(mesh);
  Stages stages(surface);
  stages.add(ivdd(0.2));
  const CollapsePlan own = ivdd(0.2).plan(surface), staged = stages.take();
  check_same(staged.collapses, own.collapses);
  CHECK(staged.stages == own.stages);
  CHECK(staged.record.planned == own.record.planned);
  CHECK(staged.record.fell_back == own.record.fell_back);
}

TEST_CASE("the counts of refused collapses are summed over the stages") {
  const IndexedMesh mesh = meshes::tetrahedron();
  VertexDistance planner = ivdd(10);
  planner.guard.min_cos = -1;
  const Surface surface(mesh);
  Stages stages(surface);
  stages.add(planner);
  stages.add(planner);
  CHECK(stages.take().record.refused_by_link == 2 * planner.plan(surface).record.refused_by_link);
}

TEST_CASE("every stage is judged by the normals of the input") {
  // 12 is the middle of the flat 5 x 5 grid. The face on the edge 7 8, y = 1, turns by atan(0.4) = 21.8
  // degrees, then to atan(0.6 / 0.75) = 38.7. No other face turns by more than 31 degrees in the second
  // stage.
  const IndexedMesh mesh = meshes::flat_grid(5);
  const double limit = std::cos(35 * meshes::kPi / 180);
  const MergeAt first{12, 13, {2, 2, 0.4}, limit};
  const auto second = [](std::uint32_t from, double min_cos) {
    return MergeAt{12, from, {2, 1.75, 0.6}, min_cos};
  };
  const std::uint32_t below_in_input = 17, below_then = 16;  // without 13

  const Surface surface(mesh);
  Stages stages(surface);
  REQUIRE(stages.add(first) == 1);
  const IndexedMesh lifted = execute(first.plan(surface), mesh).mesh;
  REQUIRE(lifted.points[below_then] == mesh.points[below_in_input]);
  CHECK(second(below_then, limit).plan(Surface(lifted)).collapses.size() == 1);  // on its own
  CHECK(stages.add(second(below_then, limit)) == 0);
  CHECK(stages.add(second(below_then, std::cos(std::atan(0.8)) + 1e-9)) == 0);
  CHECK(stages.add(second(below_then, std::cos(std::atan(0.8)) - 1e-9)) == 1);

  const CollapsePlan plan = stages.take();
  CHECK(meshes::merges(plan) == Merges{{13, 12}, {below_in_input, 12}});
  CHECK(plan.record.refused_by_flip_guard == 2);
  CHECK(plan.stages == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a first stage without a collapse adds no stage to the next one's") {
  const IndexedMesh mesh = meshes::torus(12, 9);
  const Surface surface(mesh);
  Stages stages(surface);
  CHECK(stages.add(ivdd(0)) == 0);
  CHECK(stages.add(ivdd(0.2)) > 0);
  CHECK(stages.take().stages == std::vector<std::size_t>{0});
}

TEST_CASE("the user's reference normals hold for all stages") {
  const IndexedMesh mesh = meshes::torus(12, 9);
  const Surface plain(mesh);
  SurfaceExtras extras;
  for (std::uint32_t f = 0; f < plain.n_faces(); ++f) extras.reference_normals.push_back(-plain.normal(f));
  const Surface inverted(mesh, extras);
  VertexDistance unguarded = ivdd(0.2);
  unguarded.guard.min_cos = -1;
  Stages stages(inverted);
  CHECK(stages.add(ivdd(0.2)) == 0);  // every face is turned over already
  CHECK(stages.add(unguarded) > 0);
  CHECK(stages.add(ivdd(0.4)) == 0);
}

TEST_CASE("stages on an empty mesh plan nothing") {
  for (const IndexedMesh& mesh :
       {IndexedMesh(), meshes::lone_triangle(), meshes::isolated_points(3), meshes::tetrahedron()}) {
    const Surface surface(mesh);
    CHECK(plan_passes(ivdd(10), surface, 10, kNever).plan.collapses.empty());
    Stages stages(surface);
    CHECK(stages.add(ss(10)) == 0);
    CHECK(stages.add(Circumcenter()) == 0);
    CHECK(stages.n_faces() == mesh.triangles.size());
    CHECK(stages.n_vertices() == mesh.points.size());
  }
}

TEST_CASE("isolated vertices and degenerate faces come through all stages") {
  IndexedMesh mesh = meshes::torus(16, 10);
  const std::size_t n = mesh.points.size();
  mesh.points.emplace_back(9, 9, 9);
  mesh.points.emplace_back(9, 9, 8);
  mesh.triangles.insert(mesh.triangles.begin() + 7, {160, 161, 161});
  const Surface surface(mesh);
  Stages stages(surface);
  REQUIRE(stages.add(ivdd(0.3)) > 0);
  REQUIRE(stages.add(ivdd(0.5)) > 0);
  const std::size_t faces = stages.n_faces();
  const auto out = execute(stages.take(), mesh);
  CHECK(out.mesh.triangles.size() == faces);
  CHECK(out.survives[n]);
  CHECK(out.survives[n + 1]);
}

TEST_CASE("stages of a mesh of floats are planned on the rounded points") {
  const IndexedMesh source = some_mesh();
  IndexedMeshT<float> mesh;
  mesh.triangles = source.triangles;
  for (const Vector3d& p : source.points) mesh.points.push_back(p.cast<float>());
  const SurfaceT<float> surface(mesh);
  StagesT<float> stages(surface);
  REQUIRE(stages.add(ivdd(0.2)) > 0);
  REQUIRE(stages.add(ivdd(0.3)) > 0);
  const CollapsePlan plan = stages.take();

  const auto first = execute(plan, mesh, plan.stages[1]);
  SurfaceExtras extras;
  for (const std::uint32_t f : first.face_origin) extras.reference_normals.push_back(surface.normal(f));
  const CollapsePlan second = ivdd(0.3).plan(SurfaceT<float>(first.mesh, extras));
  CHECK(second.collapses.size() == plan.collapses.size() - plan.stages[1]);
  CHECK(execute(second, first.mesh).mesh.points == execute(plan, mesh).mesh.points);
}

TEST_CASE("what the user holds and tolerates, a second stage holds and tolerates") {
  const IndexedMesh mesh = meshes::flat_grid(6);
  for (const std::uint8_t flag : {kLocked, kFeature, kSeam}) {
    SurfaceExtras extras;
    extras.flags.assign(36, 0);
    extras.flags[28] = flag;
    extras.tolerance.assign(36, 1);
    extras.tolerance[22] = 0.5f;
    const Surface surface(mesh, extras);
    Stages stages(surface);
    REQUIRE(stages.add(MergeAt{7, 8, mesh.points[7], -1}) == 1);
    struct Look {
      std::uint8_t flag;
      CollapsePlan plan(const Surface& second) const {
        CHECK(second.n_vertices() == 35);
        CHECK(second.flags(27) == flag);  // 28, as 8 is gone
        CHECK(second.flags(26) == 0);
        CHECK(second.tolerance(21) == 0.5);
        CHECK(second.tolerance(22) == 1);
        return {};
      }
    };
    stages.add(Look{flag});
  }
}
