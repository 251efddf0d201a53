#include "whittle/planners/Chain.hh"

#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/FaceAngle.hh"
#include "whittle/planners/Fass.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

using namespace whittle;
using meshes::IndexedMesh;
using Surface = SurfaceT<double>;
using FadThenSs = Chain<FaceAngle, SphereScan>;

namespace {

FadThenSs fass(double degrees, double radius) {
  FadThenSs chain;
  std::get<0>(chain.planners).max_normal_angle = degrees;
  std::get<1>(chain.planners).radius = radius;
  return chain;
}

/// Calls `visit(name, planner)` for every planner, in every way of placing and folding.
template <typename Visit>
void for_each_planner(double length, double min_cos, Boundary boundary, Visit visit) {
  Circumcenter vt;
  vt.guard.min_cos = min_cos;
  visit("VT", vt);
  vt.placement = Circumcenter::Placement::circumcenter;
  visit("VT, literal", vt);

  VertexDistance ivdd;
  ivdd.max_distance = length;
  ivdd.guard.min_cos = min_cos;
  ivdd.boundary = boundary;
  visit("IVDD", ivdd);

  SphereScan ss;
  ss.radius = length;
  ss.guard.min_cos = min_cos;
  ss.boundary = boundary;
  visit("SS", ss);
  ss.placement = SphereScan::Placement::quadric;
  visit("SS, quadric", ss);

  Vtd vtd;
  vtd.max_distance = length;
  vtd.guard.min_cos = min_cos;
  vtd.boundary = boundary;
  visit("VTD", vtd);
  vtd.fold = Vtd::Fold::literal;
  visit("VTD, literal", vtd);

  FaceAngle fad;
  fad.guard.min_cos = min_cos;
  fad.boundary = boundary;
  visit("FAD", fad);
  visit("FASS", FadThenSs{{fad, ss}});
}

std::vector<IndexedMesh> random_meshes() {
  return {meshes::shaken(meshes::torus(14, 9), 0.02, 1),
          meshes::riddled(meshes::shaken(meshes::torus(14, 9), 0.02, 2), 12, 7),
          meshes::shaken(meshes::flat_grid(11), 0.2, 3),
          meshes::riddled(meshes::shaken(meshes::flat_grid(11), 0.2, 4), 15, 5)};
}

}  // namespace

TEST_CASE("FASS runs SS on what FAD leaves") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.005, 4);
  const Surface surface(mesh);
  const FadThenSs chain = fass(20, 0.15);
  const CollapsePlan plan = chain.plan(surface);

  const auto& [fad, ss] = chain.planners;
  const CollapsePlan first = fad.plan(surface);
  const auto middle = execute(first, mesh);
  SurfaceExtras extras;
  for (const std::uint32_t f : middle.face_origin) extras.reference_normals.push_back(surface.normal(f));
  const CollapsePlan second = ss.plan(Surface(middle.mesh, extras));
  REQUIRE(first.collapses.size() > 5);
  REQUIRE(second.collapses.size() > 5);

  CHECK(plan.stages == std::vector<std::size_t>{0, first.collapses.size()});
  CHECK(plan.collapses.size() == first.collapses.size() + second.collapses.size());
  CHECK(plan.record.planned == first.record.planned + second.record.planned);
  const auto expected = execute(second, middle.mesh), out = execute(plan, mesh);
  CHECK(out.mesh.points == expected.mesh.points);
  CHECK(out.mesh.triangles == expected.mesh.triangles);
}

TEST_CASE("a chain is its planners as stages, and chains nest") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.005, 4);
  const Surface surface(mesh);
  VertexDistance ivdd;
  ivdd.max_distance = 0.3;
  StagesT<double> stages(surface);
  const FadThenSs inner = fass(20, 0.15);
  stages.add(std::get<0>(inner.planners));
  stages.add(std::get<1>(inner.planners));
  stages.add(ivdd);
  const CollapsePlan expected = stages.take();
  REQUIRE(expected.stages.size() == 3);

  const Chain<FaceAngle, SphereScan, VertexDistance> flat{
      {std::get<0>(inner.planners), std::get<1>(inner.planners), ivdd}};
  const Chain<FadThenSs, VertexDistance> nested{{inner, ivdd}};
  for (const CollapsePlan& plan : {flat.plan(surface), nested.plan(surface)}) {
    CHECK(meshes::merges(plan) == meshes::merges(expected));
    CHECK(plan.stages == expected.stages);
    CHECK(execute(plan, mesh).mesh.points == execute(expected, mesh).mesh.points);
  }
}

TEST_CASE("a chain in passes begins again with its first planner") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.005, 4);
  const Surface surface(mesh);
  const FadThenSs chain = fass(20, 0.15);
  const CollapsePlan plan = plan_passes(chain, surface, 2, [](const auto&) { return false; }).plan;
  StagesT<double> stages(surface);
  for (int pass = 0; pass < 2; ++pass) {
    stages.add(std::get<0>(chain.planners));
    stages.add(std::get<1>(chain.planners));
  }
  const CollapsePlan expected = stages.take();
  CHECK(meshes::merges(plan) == meshes::merges(expected));
  CHECK(plan.stages == expected.stages);
}

TEST_CASE("a chain of which one part finds nothing is the other part") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.005, 4);
  const Surface surface(mesh);
  const FadThenSs only_fad = fass(20, 0), only_ss = fass(0, 0.15);
  CHECK(meshes::merges(only_fad.plan(surface)) ==
        meshes::merges(std::get<0>(only_fad.planners).plan(surface)));
  CHECK(only_fad.plan(surface).stages == std::vector<std::size_t>{0});
  CHECK(meshes::merges(only_ss.plan(surface)) == meshes::merges(std::get<1>(only_ss.planners).plan(surface)));
  CHECK(only_ss.plan(surface).stages == std::vector<std::size_t>{0});
  CHECK(fass(0, 0).plan(surface).collapses.empty());
}

TEST_CASE("a chain scales all its thresholds") {
  const FadThenSs half = fass(40, 0.5).scaled(0.5);
  CHECK(std::get<0>(half.planners).max_normal_angle == 20);
  CHECK(std::get<1>(half.planners).radius == 0.25);
}

TEST_CASE("a chain merges along seams if one of its planners does") {
  FadThenSs chain = fass(30, 0.1);
  CHECK_FALSE(chain.moves_seams());
  std::get<1>(chain.planners).seams = Seams::merge;
  CHECK(chain.moves_seams());
  std::get<0>(chain.planners).seams = Seams::merge;
  CHECK(chain.moves_seams());
}

TEST_CASE("a chain refuses what one of its planners refuses, before it plans") {
  const IndexedMesh mesh = meshes::torus(12, 9);
  for (const FadThenSs& chain :
       {fass(-1, 0.1), fass(30, -0.1), fass(30, std::nan("")), fass(std::nan(""), 0.1)}) {
    CHECK_THROWS_AS(chain.validate(), InvalidParameter);
    CHECK_THROWS_AS(chain.plan(Surface(mesh)), InvalidParameter);
  }
  CHECK_NOTHROW(fass(30, 0.1).validate());
}

TEST_CASE("a chain leaves a mesh alone that has nothing to merge") {
  for (const IndexedMesh& mesh : {IndexedMesh(), meshes::lone_triangle(), meshes::isolated_points(3)})
    CHECK(fass(180, 10).plan(Surface(mesh)).collapses.empty());
}

TEST_CASE("every beginning of every planner's plan is a manifold of the same kind") {
  for (const Boundary boundary : {Boundary::keep, Boundary::merge})
    for (const double min_cos : {0.2, -1.0})
      for (const IndexedMesh& mesh : random_meshes()) {
        const auto before = measure::facts(mesh);
        // A length near the mean edge, so that all kinds of clusters occur.
        for_each_planner(
            1.1 * before.mean_edge, min_cos, boundary, [&](const char* name, const auto& planner) {
              INFO(name << ", " << before.faces << " faces, guard " << min_cos);
              const CollapsePlan plan = planner.plan(Surface(mesh));
              CHECK(plan.collapses.size() >= 3);
              std::size_t faces = mesh.triangles.size();
              bool ok = true;
              for (std::size_t n = 0; n <= plan.collapses.size() && ok; ++n) {
                const auto after = measure::facts(execute(plan, mesh, n).mesh);
                ok = after.faces == faces && after.vertices == before.vertices - n &&
                     after.nonmanifold_edges == before.nonmanifold_edges &&
                     after.nonmanifold_vertices <= before.nonmanifold_vertices &&
                     after.duplicate_faces == 0 &&
                     after.euler_characteristic == before.euler_characteristic &&
                     after.boundary_loops == before.boundary_loops && after.components == before.components &&
                     (boundary == Boundary::merge || after.boundary_edges == before.boundary_edges);
                CHECKED_ELSE(ok) {
                  FAIL("after collapse " << n);
                }
                if (n < plan.collapses.size()) faces -= plan.collapses[n].faces;
              }
            });
      }
}

TEST_CASE("no planner turns a face further than its guard allows") {
  for (const IndexedMesh& mesh : random_meshes()) {
    const Surface surface(mesh);
    for_each_planner(0.5 * measure::facts(mesh).diagonal, 0.5, Boundary::merge,
                     [&](const char* name, const auto& planner) {
                       INFO(name);
                       const auto out = execute(planner.plan(surface), mesh);
                       const Surface after(out.mesh);
                       double least = 1;
                       for (std::uint32_t f = 0; f < after.n_faces(); ++f)
                         least = std::min(least, after.normal(f).normalized().dot(
                                                     surface.normal(out.face_origin[f]).normalized()));
                       CHECK(least > 0.5 - 1e-12);
                     });
  }
}

TEST_CASE("IVDD and VTD move no vertex by as much as their distance, SS the scanned one by its radius") {
  for (const IndexedMesh& mesh : random_meshes()) {
    const double length = 1.2 * measure::facts(mesh).mean_edge;
    double furthest = 0, scanned = 0, others = 0;
    VertexDistance ivdd;
    ivdd.max_distance = length;
    ivdd.guard.min_cos = -1;
    Vtd vtd;
    vtd.max_distance = length;
    vtd.guard.min_cos = -1;
    for (const CollapsePlan& plan : {ivdd.plan(Surface(mesh)), vtd.plan(Surface(mesh))})
      for (const Collapse& c : plan.collapses)
        for (const std::uint32_t v : {c.from, c.to})
          furthest = std::max(furthest, (c.target - mesh.points[v]).norm());
    CHECK(furthest < length);

    SphereScan ss;
    ss.radius = length;
    ss.guard.min_cos = -1;
    const CollapsePlan plan = ss.plan(Surface(mesh));
    for (const Collapse& c : plan.collapses) {
      scanned = std::max(scanned, (c.target - mesh.points[c.to]).norm());
      others = std::max(others, (c.target - mesh.points[c.from]).norm());
      CHECK((mesh.points[c.from] - mesh.points[c.to]).norm() < length);
    }
    CHECK(scanned < length);
    CHECK(others < 2 * length);  // both lie in the sphere, on opposite sides at worst
  }
}

TEST_CASE("all planners and all lengths keep locked vertices in place") {
  for (const IndexedMesh& mesh : random_meshes()) {
    SurfaceExtras extras;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      extras.flags.push_back(v % 3 == 0 ? kLocked : v % 7 == 0 ? kFeature : 0);
    const Surface surface(mesh, extras);
    for_each_planner(10, -1, Boundary::merge, [&](const char* name, const auto& planner) {
      INFO(name);
      const auto out = execute(planner.plan(surface), mesh);
      std::size_t changed = 0;
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        if (extras.flags[v] || surface.is_complex(static_cast<std::uint32_t>(v)))
          changed += !out.survives[v] || out.mesh.points[out.vertex_map[v]] != mesh.points[v];
      CHECK(changed == 0);
    });
  }
}

TEST_CASE("FASS scales both of its thresholds") {
  Fass planner;
  planner.face_angle.max_normal_angle = 40;
  planner.sphere_scan.radius = 3;
  const Fass half = planner.scaled(0.5);
  CHECK(half.face_angle.max_normal_angle == 20);
  CHECK(half.sphere_scan.radius == 1.5);
}
