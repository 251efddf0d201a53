#include "recipe/StockDecimater.hh"

#include "catch.hh"
#include "meshes.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModGuardedQuadricT.hh"

using namespace whittle;
using Mesh = recipe::StockDecimater::Mesh;

namespace {

/// Counts how often it is asked for early priorities.
class CountedQuadric : public ModGuardedQuadricT<Mesh> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<CountedQuadric>;
  using ModGuardedQuadricT<Mesh>::ModGuardedQuadricT;

  float early_priority(const CollapseInfo& ci) override {
    ++n_asked;
    return ModGuardedQuadricT<Mesh>::early_priority(ci);
  }
  std::size_t n_asked = 0;
};

}  // namespace

TEST_CASE("a module of a recipe is known to Whittle's drivers for what it can do") {
  recipe::OpenMeshCopy copy(meshes::flat_grid(5));
  LazyDecimaterT<Mesh> decimater(copy.mesh);
  recipe::StockDecimater modules(decimater, recipe::StockDecimater::Weights());
  auto& quadric = modules.add<CountedQuadric>();
  // Without the driver's knowledge it is asked once for each collapse that is tested.
  REQUIRE(decimater.initialize());
  CHECK(decimater.decimate(1) == 1);
  CHECK(quadric.n_asked > 2 * copy.mesh.n_edges());
}
