#include "recipe/Planner.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/planners/VertexDistance.hh"

using namespace whittle;
using whittle::recipe::Planner;

namespace {

bool never(std::size_t, std::size_t) {
  return false;
}

/// mq, with its plans counted.
struct Counted {
  int *on_mesh, *on_surface;
  MemorylessQuadric mq;

  CollapsePlan plan(const IndexedMesh& mesh, SurfaceExtras extras, std::size_t n_threads) const {
    ++*on_mesh;
    return mq.plan(mesh, std::move(extras), n_threads);
  }
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const {
    ++*on_surface;
    return mq.plan(surface);
  }
};

bool equal(const CollapsePlan& a, const CollapsePlan& b) {
  return std::equal(a.collapses.begin(), a.collapses.end(), b.collapses.begin(), b.collapses.end(),
                    [](const Collapse& x, const Collapse& y) {
                      return x.from == y.from && x.to == y.to && x.target == y.target;
                    });
}

}  // namespace

TEST_CASE("planner: a first pass that falls short of the target is not planned again") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.003, 1);
  int on_mesh = 0, on_surface = 0;
  MemorylessQuadric mq;
  mq.target_faces = 100;
  const auto counted = Planner(Counted{&on_mesh, &on_surface, mq}).plan(mesh, {}, 10, never);
  CHECK(on_mesh == 1);
  CHECK(on_surface == 1);  // finds nothing more
  CHECK(counted.passes == 2);
  const auto on_surfaces = plan_passes(mq, SurfaceT<double>(mesh), 10, [](const auto&) { return false; });
  CHECK(on_surfaces.passes == 2);
  CHECK(equal(counted.plan, on_surfaces.plan));
}

TEST_CASE("planner: passes end where it is enough, and at their number") {
  const IndexedMesh mesh = meshes::shaken(meshes::torus(24, 14), 0.003, 1);
  VertexDistance ivdd;
  ivdd.max_distance = 0.3;
  const Planner planner(ivdd);
  CHECK(planner.as<VertexDistance>().max_distance == 0.3);
  CHECK(planner.plan(mesh, {}, 1, never).passes == 1);
  CHECK(planner.plan(mesh, {}, 3, never).passes == 3);
  CHECK(planner.plan(mesh, {}, 3, [](std::size_t, std::size_t) { return true; }).passes == 1);
}
