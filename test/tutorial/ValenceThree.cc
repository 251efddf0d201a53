/// \file
/// The code of docs/write-your-own-planner.md. What stands between "// [name]" and "// [/name]" is a code
/// block of that page, word for word; page.cc checks it.

// [planner]
#include <cmath>
#include <cstdint>
#include <vector>

#include <whittle/plan/PlanDraft.hh>
#include <whittle/surface/Surface.hh>

/// Removes interior vertices with three faces that are lower than `max_height` above the triangle of their
/// neighbours.
struct ValenceThree {
  double max_height = 0;  ///< model units, >= 0; 0 removes nothing
  whittle::FlipGuard guard;

  /// \throw whittle::InvalidParameter
  void validate() const {
    if (!(max_height >= 0 && std::isfinite(max_height)))
      throw whittle::InvalidParameter("ValenceThree: the height must be a finite length of at least 0");
    guard.validate();
  }

  /// The planner with its threshold multiplied by `factor`, in [0, 1].
  ValenceThree scaled(double factor) const { return {max_height * factor, guard}; }

  template <typename Real>
  whittle::CollapsePlan plan(const whittle::SurfaceT<Real>& surface) const {
    validate();
    whittle::PlanDraftT<Real> draft(surface, guard);
    std::vector<bool> kept(surface.n_vertices(), false);

    for (std::uint32_t v = 0; v < surface.n_vertices(); ++v) {
      if (kept[v] || !surface.is_free(v)) continue;
      const whittle::Ring ring = surface.ring(v);
      if (ring.size() != 3) continue;
      const Eigen::Vector3d a = surface.point(ring[0]), b = surface.point(ring[1]),
                            c = surface.point(ring[2]);
      const double height = std::abs((b - a).cross(c - a).normalized().dot(surface.point(v) - a));
      if (!(height < max_height * surface.tolerance(v))) continue;

      const auto verdict = draft.merge({ring[0], v}, a);  // ring[0] survives, and stays where it is
      draft.count_refusal(verdict);
      if (verdict != whittle::PlanDraftT<Real>::Verdict::accepted) continue;
      for (const std::uint32_t w : ring) kept[w] = true;
    }
    return draft.take();
  }
};
// [/planner]

// [module]
#include <whittle/openmesh/ModPlannedT.hh>

template <typename MeshT>
class ModValenceThreeT : public whittle::ModPlannedT<MeshT, ValenceThree> {
 public:
  DECIMATING_MODULE(ModValenceThreeT, MeshT, ValenceThree);

  explicit ModValenceThreeT(MeshT& mesh) : whittle::ModPlannedT<MeshT, ValenceThree>(mesh) {}

  /// Lower vertices go, in model units. >= 0; the default 0 removes nothing. \throw whittle::InvalidParameter
  void set_max_height(double height) {
    this->change([&](ValenceThree& planner) { planner.max_height = height; });
  }
};
// [/module]

// [stock]
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

std::size_t with_openmesh(Mesh& mesh, double max_height) {
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  ModValenceThreeT<Mesh>::Handle handle;
  decimater.add(handle);
  decimater.module(handle).set_max_height(max_height);
  decimater.initialize();
  const std::size_t removed = decimater.decimate();
  mesh.garbage_collection();
  return removed;
}
// [/stock]

// [sweep]
#include <whittle/SweepDecimaterT.hh>

std::size_t with_sweep(Mesh& mesh, double max_height) {
  whittle::SweepDecimaterT<Mesh> decimater(mesh);
  ModValenceThreeT<Mesh>::Handle handle;
  decimater.add(handle);
  decimater.module(handle).set_max_height(max_height);
  decimater.module(handle).set_passes(ModValenceThreeT<Mesh>::kUntilRest);
  decimater.initialize();
  const std::size_t removed = decimater.decimate();
  mesh.garbage_collection();
  return removed;
}
// [/sweep]

// [chain]
#include <whittle/ModChainT.hh>
#include <whittle/planners/FaceAngle.hh>

std::size_t after_face_angle(Mesh& mesh, double max_height) {
  whittle::SweepDecimaterT<Mesh> decimater(mesh);
  whittle::ModChainT<Mesh, whittle::FaceAngle, ValenceThree>::Handle handle;
  decimater.add(handle);
  decimater.module(handle).change_planner<0>([](auto& fad) { fad.max_normal_angle = 10; });
  decimater.module(handle).change_planner<1>([&](auto& three) { three.max_height = max_height; });
  decimater.initialize();
  const std::size_t removed = decimater.decimate();
  mesh.garbage_collection();
  return removed;
}
// [/chain]

// [arrays]
#include <whittle/plan/execute.hh>
#include <whittle/surface/IndexedMesh.hh>

whittle::IndexedMesh on_arrays(const whittle::IndexedMesh& mesh, double max_height) {
  const whittle::SurfaceT<double> surface(mesh);
  const whittle::CollapsePlan plan = ValenceThree{max_height, {}}.plan(surface);
  return whittle::execute(plan, mesh).mesh;
}
// [/arrays]

#include "catch.hh"
#include "meshes.hh"
#include "whittle/planners/Chain.hh"

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

TEST_CASE("tents that are low are removed, and the surface below comes back exactly") {
  CHECK(meshes::canonical(on_arrays(with_tents(kTorus, kLow), 0.02)) == meshes::canonical(kTorus));

  // Every second tent is too high.
  const auto mixed = with_tents(kTorus, [](std::size_t i) { return i % 2 ? 0.01 : 0.03; });
  const auto left = on_arrays(mixed, 0.02);
  CHECK(left.triangles.size() == kTorus.triangles.size() + kTorus.triangles.size() / 3 / 2 * 2);
  CHECK(meshes::nonmanifold_edges(left) == 0);
}

TEST_CASE("nothing is removed by default, at the threshold itself, or where the link condition forbids it") {
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

TEST_CASE("the planner's parameters are checked and scaled") {
  CHECK_THROWS_AS((ValenceThree{-1, {}}.validate()), whittle::InvalidParameter);
  CHECK_THROWS_AS((ValenceThree{NAN, {}}.validate()), whittle::InvalidParameter);
  CHECK(ValenceThree{2, {}}.scaled(0.25).max_height == 0.5);
}

TEST_CASE("DecimaterT and the sweep leave the surface that the arrays have") {
  const auto tents = with_tents(kTorus, kLow);
  const std::size_t n_tents = tents.points.size() - kTorus.points.size();
  const auto torus = meshes::canonical(to_float(kTorus));
  Mesh stock = to_openmesh(tents), sweep = to_openmesh(tents);
  CHECK(with_openmesh(stock, 0.02) == n_tents);
  CHECK(meshes::canonical(whittle::to_indexed(stock)) == torus);
  CHECK(with_sweep(sweep, 0.02) == n_tents);
  CHECK(meshes::canonical(whittle::to_indexed(sweep)) == torus);
}

TEST_CASE("passes until rest take tents that stand on tents") {
  const auto twice = with_tents(with_tents(kTorus, kLow), [](std::size_t) { return 0.001; });
  Mesh once = to_openmesh(twice), often = to_openmesh(twice);
  with_openmesh(once, 0.02);
  with_sweep(often, 0.02);
  CHECK(once.n_faces() > kTorus.triangles.size());
  CHECK(meshes::canonical(whittle::to_indexed(often)) == meshes::canonical(to_float(kTorus)));
}

TEST_CASE("the chain runs both planners, the second on what the first leaves") {
  // FAD takes the flat ones at 10 degrees, the other planner the steeper ones.
  const auto tents = with_tents(kTorus, [](std::size_t i) { return i % 2 ? 0.001 : 0.015; });
  Mesh mesh = to_openmesh(tents);
  const std::size_t removed = after_face_angle(mesh, 0.02);
  CHECK(removed == tents.points.size() - mesh.n_vertices());

  const auto single = to_float(tents);
  whittle::Chain<whittle::FaceAngle, ValenceThree> chain;
  std::get<0>(chain.planners).max_normal_angle = 10;
  std::get<1>(chain.planners).max_height = 0.02;
  const auto plan = chain.plan(whittle::SurfaceT<float>(single));
  CHECK(plan.stages.size() == 2);
  CHECK(meshes::canonical(whittle::execute(plan, single).mesh) ==
        meshes::canonical(whittle::to_indexed(mesh)));
}
