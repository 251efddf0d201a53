/// \file
/// The code of docs/write-your-own-planner.md, taken from the page, does what the page says.
#include "planner_struct.inc"

#include "planner_module.inc"

#include "planner_stock.inc"

#include "planner_sweep.inc"

#include "planner_chain.inc"

#include "planner_arrays.inc"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/planners/Chain.hh"
#include "written.hh"

namespace {

/// The mesh with a vertex over every third face, `height(i)` above its centroid.
template <typename Height>
whittle::IndexedMesh with_tents(const whittle::IndexedMesh& in, Height height) {
  whittle::IndexedMesh mesh = in;
  mesh.triangles.clear();
  for (std::size_t f = 0; f < in.triangles.size(); ++f) {
    const auto& t = in.triangles[f];
    if (f % 3 != 0) {
      mesh.triangles.push_back(t);
      continue;
    }
    const Eigen::Vector3d a = in.points[t[0]], b = in.points[t[1]], c = in.points[t[2]];
    const auto tip = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back((a + b + c) / 3 + height(f / 3) * (b - a).cross(c - a).normalized());
    for (int i = 0; i < 3; ++i) mesh.triangles.push_back({t[i], t[(i + 1) % 3], tip});
  }
  return mesh;
}

const whittle::IndexedMesh kTorus = meshes::torus(24, 12);
const auto kLow = [](std::size_t) { return 0.01; };

Mesh to_openmesh(const whittle::IndexedMesh& in) {
  Mesh mesh;
  const auto handle = [](std::uint32_t v) { return Mesh::VertexHandle(static_cast<int>(v)); };
  for (const auto& p : in.points)
    mesh.add_vertex({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  for (const auto& t : in.triangles) mesh.add_face(handle(t[0]), handle(t[1]), handle(t[2]));
  return mesh;
}

whittle::IndexedMeshT<float> to_float(const whittle::IndexedMesh& in) {
  whittle::IndexedMeshT<float> out;
  for (const auto& p : in.points) out.points.push_back(p.cast<float>());
  out.triangles = in.triangles;
  return out;
}

}  // namespace

TEST_CASE("planner page: tents that are low are removed, and the surface below comes back exactly") {
  CHECK(meshes::canonical(on_arrays(with_tents(kTorus, kLow), 0.02)) == meshes::canonical(kTorus));

  // Every second tent is too high.
  const auto mixed = with_tents(kTorus, [](std::size_t i) { return i % 2 ? 0.01 : 0.03; });
  const auto left = on_arrays(mixed, 0.02);
  CHECK(left.triangles.size() == kTorus.triangles.size() + kTorus.triangles.size() / 3 / 2 * 2);
  CHECK(meshes::nonmanifold_edges(left) == 0);
}

TEST_CASE(
    "planner page: nothing is removed by default, at the threshold itself, or where the link condition "
    "forbids it") {
  const auto tents = with_tents(kTorus, kLow);
  CHECK(on_arrays(tents, 0).triangles == tents.triangles);
  CHECK(on_arrays(meshes::tetrahedron(), 10).triangles.size() == 4);
  whittle::IndexedMesh tent;  // of exact coordinates: the tip 0 over the triangle 1 2 3, and a band around it
  tent.points = {{1, 1, 0.25}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-8, -8, 0}, {16, -8, 0}, {-8, 16, 0}};
  tent.triangles = {{1, 2, 0}, {2, 3, 0}, {3, 1, 0}, {1, 4, 5}, {1, 5, 2},
                    {2, 5, 6}, {2, 6, 3}, {3, 6, 4}, {3, 4, 1}};
  CHECK(on_arrays(tent, 0.25).triangles.size() == 9);
  CHECK(on_arrays(tent, 0.26).triangles.size() == 7);
}

TEST_CASE("planner page: the planner's parameters are checked and scaled") {
  CHECK_THROWS_AS((ValenceThree{-1, {}}.validate()), whittle::InvalidParameter);
  CHECK_THROWS_AS((ValenceThree{NAN, {}}.validate()), whittle::InvalidParameter);
  CHECK(ValenceThree{2, {}}.scaled(0.25).max_height == 0.5);
}

TEST_CASE("planner page: DecimaterT and the sweep leave the surface that the arrays have") {
  const auto tents = with_tents(kTorus, kLow);
  const std::size_t n_tents = tents.points.size() - kTorus.points.size();
  const auto torus = meshes::canonical(to_float(kTorus));
  Mesh stock = to_openmesh(tents), sweep = to_openmesh(tents);
  CHECK(with_openmesh(stock, 0.02) == n_tents);
  CHECK(meshes::canonical(whittle::to_indexed(stock)) == torus);
  written::check_faces(stock, kTorus.triangles.size());
  CHECK(with_sweep(sweep, 0.02) == n_tents);
  CHECK(meshes::canonical(whittle::to_indexed(sweep)) == torus);
  written::check_faces(sweep, kTorus.triangles.size());
}

TEST_CASE("planner page: passes until rest take tents that stand on tents") {
  const auto twice = with_tents(with_tents(kTorus, kLow), [](std::size_t) { return 0.001; });
  Mesh once = to_openmesh(twice), often = to_openmesh(twice);
  with_openmesh(once, 0.02);
  with_sweep(often, 0.02);
  CHECK(once.n_faces() > kTorus.triangles.size());
  CHECK(meshes::canonical(whittle::to_indexed(often)) == meshes::canonical(to_float(kTorus)));
}

TEST_CASE("planner page: the chain runs both planners, the second on what the first leaves") {
  // FAD takes the flat ones at 10 degrees, the other planner the steeper ones.
  const auto tents = with_tents(kTorus, [](std::size_t i) { return i % 2 ? 0.001 : 0.015; });
  Mesh mesh = to_openmesh(tents);
  const std::size_t removed = after_face_angle(mesh, 0.02);
  CHECK(removed == tents.points.size() - mesh.n_vertices());
  written::check_faces(mesh, mesh.n_faces());

  const auto single = to_float(tents);
  whittle::Chain<whittle::FaceAngle, ValenceThree> chain;
  std::get<0>(chain.planners).max_normal_angle = 10;
  std::get<1>(chain.planners).max_height = 0.02;
  const auto plan = chain.plan(whittle::SurfaceT<float>(single));
  CHECK(plan.stages.size() == 2);
  CHECK(meshes::canonical(whittle::execute(plan, single).mesh) ==
        meshes::canonical(whittle::to_indexed(mesh)));
}
