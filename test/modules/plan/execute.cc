#include "whittle/plan/execute.hh"

#include "catch.hh"
#include "measure/MeshFacts.hh"
#include "meshes.hh"
#include "whittle/planners/VertexDistance.hh"

using namespace whittle;
using meshes::IndexedMesh;

TEST_CASE("execute() of an empty plan changes nothing") {
  const IndexedMesh mesh = meshes::torus(8, 6);
  const auto out = execute(CollapsePlan(), mesh);
  CHECK(out.mesh.points == mesh.points);
  CHECK(out.mesh.triangles == mesh.triangles);
}

TEST_CASE("vertices and faces keep their order, and the maps tell where they went") {
  const IndexedMesh mesh = meshes::cone(4, 1);
  CollapsePlan plan;
  plan.collapses.push_back({0, 2, 2, 0, {5, 6, 7}});
  const auto out = execute(plan, mesh);
  REQUIRE(out.mesh.points.size() == 4);
  CHECK(out.vertex_map == std::vector<std::uint32_t>{1, 0, 1, 2, 3});
  CHECK(out.mesh.points[1] == Eigen::Vector3d(5, 6, 7));
  CHECK(out.mesh.points[0] == mesh.points[1]);
  CHECK(out.face_origin == std::vector<std::uint32_t>{2, 3});
  CHECK(out.mesh.triangles == std::vector<IndexedMesh::Triangle>{{1, 2, 3}, {1, 3, 0}});
}

TEST_CASE("a survivor may go later itself") {
  const IndexedMesh mesh = meshes::flat_grid(4);
  CollapsePlan plan;
  plan.collapses.push_back({5, 6, 2, 0, {1.5, 1, 0}});
  plan.collapses.push_back({6, 10, 2, 0, {2, 2, 0}});
  const auto out = execute(plan, mesh);
  CHECK(out.vertex_map[5] == out.vertex_map[10]);
  CHECK(out.vertex_map[6] == out.vertex_map[10]);
  CHECK(out.mesh.points[out.vertex_map[5]] == Eigen::Vector3d(2, 2, 0));
  CHECK(out.mesh.triangles.size() == mesh.triangles.size() - 4);
}

TEST_CASE("faces that were degenerate before stay, for they are not the plan's business") {
  IndexedMesh mesh = meshes::cone(4, 1);
  mesh.triangles.push_back({1, 1, 2});
  CHECK(execute(CollapsePlan(), mesh).mesh.triangles.size() == 5);
}

TEST_CASE(
    "every beginning of a plan is a coarser mesh of the same kind, with as many faces as the plan says") {
  VertexDistance planner;
  planner.max_distance = 0.3;
  for (const bool open : {false, true}) {
    const IndexedMesh mesh = open ? meshes::riddled(meshes::torus(14, 9), 12, 7) : meshes::torus(14, 9);
    const auto before = measure::facts(mesh);
    const CollapsePlan plan = planner.plan(SurfaceT<double>(mesh));
    REQUIRE(plan.collapses.size() > 20);
    std::size_t faces = mesh.triangles.size();
    for (std::size_t n = 0; n <= plan.collapses.size(); ++n) {
      const auto out = execute(plan, mesh, n);
      CHECK(out.mesh.points.size() == mesh.points.size() - n);
      CHECK(out.mesh.triangles.size() == faces);
      const auto after = measure::facts(out.mesh);
      CHECK(after.nonmanifold_edges == 0);
      CHECK(after.duplicate_faces == 0);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_edges == before.boundary_edges);
      if (n < plan.collapses.size()) faces -= plan.collapses[n].faces;
    }
  }
}

TEST_CASE("a survivor lies at the centroid of those that have merged, as long as its cluster is not whole") {
  const IndexedMesh mesh = meshes::flat_grid(4);
  CollapsePlan plan;
  plan.stages = {0};
  const Eigen::Vector3d target(9, 9, 9);
  plan.collapses = {{6, 5, 2, 2, target}, {10, 5, 2, 1, target}, {9, 5, 2, 0, target}};
  const auto place = [&](std::size_t n) { return execute(plan, mesh, n).mesh.points[5]; };
  CHECK(place(0) == Eigen::Vector3d(1, 1, 0));
  CHECK(place(1) == Eigen::Vector3d(1.5, 1, 0));
  CHECK(place(2).isApprox(Eigen::Vector3d(5.0 / 3, 4.0 / 3, 0), 1e-15));
  CHECK(place(3) == target);
}

TEST_CASE("a survivor that its whole cluster leaves in place does not move for a part of it") {
  const IndexedMesh mesh = meshes::flat_grid(4);
  CollapsePlan plan;
  plan.stages = {0};
  plan.collapses = {{6, 5, 2, 1, mesh.points[5]}, {10, 5, 2, 0, mesh.points[5]}};
  for (const std::size_t n : {1u, 2u}) CHECK(execute(plan, mesh, n).mesh.points[5] == mesh.points[5]);
}

TEST_CASE("a cluster that is cut begins where the last one before it has left its survivor") {
  const IndexedMesh mesh = [] {
    IndexedMesh points;
    for (int i = 0; i < 6; ++i) points.points.emplace_back(i, 0, 0);
    return points;
  }();
  CollapsePlan plan;
  plan.collapses = {
      {1, 0, 0, 0, {5, 5, 5}}, {2, 0, 0, 0, {7, 1, 0}}, {3, 0, 0, 1, {9, 9, 9}}, {4, 0, 0, 0, {9, 9, 9}}};
  CHECK(execute(plan, mesh, 3).mesh.points[0] ==
        Eigen::Vector3d(5, 0.5, 0));  // between (7, 1, 0) and (3, 0, 0)
  CHECK(execute(plan, mesh).mesh.points[0] == Eigen::Vector3d(9, 9, 9));
}
