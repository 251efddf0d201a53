#include "whittle/bulk.hh"

#include "OpenMeshFixture.hh"
#include "measure/MeshFacts.hh"
#include "planners.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/compact.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/MemorylessQuadric.hh"

using namespace whittle;
using meshes::IndexedMesh;
using planners::ivdd;

namespace {

template <typename Planner>
void check_any_number_of_threads(const Planner& planner, const IndexedMesh& mesh) {
  BulkOptions options;
  options.threads = 1;
  options.passes = 2;
  const auto one = bulk(planner, mesh, options);
  CHECK(one.mesh.triangles.size() < mesh.triangles.size());
  for (const std::size_t threads : {2u, 8u}) {
    options.threads = threads;
    const auto many = bulk(planner, mesh, options);
    CHECK(many.mesh.points == one.mesh.points);
    CHECK(many.mesh.triangles == one.mesh.triangles);
    CHECK(many.vertex_map == one.vertex_map);
    CHECK(many.collapses == one.collapses);
  }
}

}  // namespace

TEST_CASE("bulk plans and executes in one call") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.02, 3);
  const SurfaceT<double> surface(mesh);
  const CollapsePlan plan = ivdd(0.2).plan(surface);
  REQUIRE(plan.collapses.size() > 0);
  const auto by_hand = execute(plan, mesh);

  const auto out = bulk(ivdd(0.2), mesh);
  CHECK(out.mesh.points == by_hand.mesh.points);
  CHECK(out.mesh.triangles == by_hand.mesh.triangles);
  CHECK(out.vertex_map == by_hand.vertex_map);
  CHECK(out.face_origin == by_hand.face_origin);
  CHECK(out.collapses == plan.collapses.size());
  CHECK(out.record.planned == plan.record.planned);
  CHECK(out.passes == 1);
}

TEST_CASE("bulk stops at the least number of faces") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.02, 3);  // 672 faces
  BulkOptions options;
  options.passes = 100;
  for (const std::size_t faces : {671u, 600u, 401u, 300u}) {
    options.min_faces = faces;
    const auto out = bulk(ivdd(0.8), mesh, options);
    CHECK(out.mesh.triangles.size() <= faces);
    CHECK(out.mesh.triangles.size() + 2 > faces);
    CHECK(measure::facts(out.mesh).nonmanifold_edges == 0);
  }
  options.min_faces = 672;
  const auto same = bulk(ivdd(0.8), mesh, options);
  CHECK(same.collapses == 0);
  CHECK(same.mesh.triangles == mesh.triangles);
}

TEST_CASE("bulk heeds locks and refuses what it cannot use") {
  const IndexedMesh mesh = meshes::torus(12, 8);
  BulkOptions options;
  options.extras.flags.assign(mesh.points.size(), kLocked);
  CHECK(bulk(ivdd(9), mesh, options).collapses == 0);
  options.extras.flags.assign(3, kLocked);
  CHECK_THROWS_AS(bulk(ivdd(9), mesh, options), InvalidParameter);
  options = {};
  options.passes = 0;
  CHECK_THROWS_AS(bulk(ivdd(9), mesh, options), InvalidParameter);
  CHECK_THROWS_AS(bulk(ivdd(-1), mesh), InvalidParameter);
  IndexedMesh broken = mesh;
  broken.triangles[3][1] = 96;
  CHECK_THROWS_AS(bulk(ivdd(9), broken), InvalidMesh);
  CHECK(bulk(ivdd(9), IndexedMesh()).mesh.triangles.empty());
  CHECK_THROWS_AS(bulk(VertexDistance(), mesh), NotReady);
  CHECK_THROWS_AS(bulk(MemorylessQuadric(), mesh), NotReady);
}

TEST_CASE("the result does not depend on the number of threads") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(150, 90), 0.001, 5);
  SphereScan ss;
  ss.radius = 0.03;
  Vtd vtd;
  vtd.max_distance = 0.03;
  check_any_number_of_threads(Circumcenter(), mesh);
  check_any_number_of_threads(FaceAngle(), mesh);
  check_any_number_of_threads(ivdd(0.03), mesh);
  check_any_number_of_threads(ss, mesh);
  check_any_number_of_threads(vtd, mesh);
}

TEST_CASE("bulk makes of an OpenMesh mesh what the sweep and compaction make of it") {
  using Mesh = fixture::Mesh;
  const Mesh input = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(24, 14), 0.02, 3));
  Mesh rebuilt;
  CHECK(to_openmesh(bulk(ivdd(0.2), to_indexed(input)).mesh, rebuilt) == 0);

  Mesh swept = input;
  swept.request_vertex_status();
  swept.request_edge_status();
  swept.request_face_status();
  SweepDecimaterT<Mesh> decimater(swept);
  ModVertexDistanceT<Mesh>::Handle handle;
  decimater.add(handle);
  decimater.module(handle).set_max_distance(0.2);
  REQUIRE(decimater.initialize());
  decimater.decimate();
  compact(swept);
  const auto a = to_indexed(rebuilt), b = to_indexed(swept);
  CHECK(a.points == b.points);
  CHECK(meshes::canonical(a) == meshes::canonical(b));
}

TEST_CASE("triangles that OpenMesh cannot take are counted") {
  fixture::Mesh mesh;
  IndexedMeshT<float> indexed;
  indexed.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  indexed.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 2, 3}};
  omerr().disable();
  CHECK(to_openmesh(indexed, mesh) == 2);
  omerr().enable();
  CHECK(mesh.n_vertices() == 5);
  CHECK(mesh.n_faces() == 2);
}
