#include "whittle/openmesh/PlanExecutionT.hh"

#include <vector>

#include "OpenMeshFixture.hh"

using namespace whittle;
using fixture::Mesh;

TEST_CASE("a survivor lies where the latest of its stages puts it, whichever is executed first") {
  const Mesh input = fixture::to_openmesh<Mesh>(meshes::flat_grid(4));
  CollapsePlan plan;
  plan.collapses = {{6, 5, 2, 0, {1.5, 1, 0}}, {9, 5, 2, 0, {1, 1.5, 0.5}}};
  plan.stages = {0, 1};
  for (const bool in_order : {true, false}) {
    Mesh mesh = input;
    detail::PlanExecutionT<Mesh> execution(plan, mesh.n_vertices());
    CHECK(execution.settle(mesh, in_order ? 0 : 1, false));
    CHECK(execution.settle(mesh, in_order ? 1 : 0, false) == in_order);
    CHECK(mesh.point(Mesh::VertexHandle(5)) == Mesh::Point(1, 1.5f, 0.5f));
    CHECK(execution.vertex_map()[6] == 5);
    CHECK(execution.vertex_map()[9] == 5);
  }
}

TEST_CASE("a survivor that a seam holds leaves its place by a tenth of the edge at most") {
  for (const float there : {1.09f, 1.11f}) {
    Mesh mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(4));
    CollapsePlan plan;
    plan.collapses = {{6, 5, 2, 0, {there, 1, 0}}};
    plan.stages = {0};
    detail::PlanExecutionT<Mesh> execution(plan, mesh.n_vertices());
    CHECK(execution.settle(mesh, 0, true) == (there < 1.1f));
    CHECK(mesh.point(Mesh::VertexHandle(5))[0] == (there < 1.1f ? there : 1.0f));
  }
}
