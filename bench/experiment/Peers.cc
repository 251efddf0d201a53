#include "experiment/Peers.hh"

#include <optional>
#include <utility>

#include "peers/peers.hh"
#include "peers/precision.hh"
#include "recipe/Recipe.hh"
#include "recipe/Stopwatch.hh"

namespace whittle::bench {

namespace {

PeerResult simplify_by_recipe(const IndexedMesh& mesh, std::size_t triangles, const char* module,
                              recipe::Driver driver, std::optional<bool> refit = {}) {
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(module)};
  recipe.target.faces = triangles;
  recipe.driver = driver;
  recipe.refit = refit;
  auto result = recipe::run(mesh, recipe);
  const double seconds = result.seconds();
  return {std::move(result.mesh), 1e3 * seconds};
}

PeerResult simplify_openmesh(const IndexedMesh& mesh, std::size_t triangles) {
  // ModQuadricT as OpenMesh ships it: without Whittle's guards.
  return simplify_by_recipe(mesh, triangles, "quadric:boundary-weight=0,guard=-1", recipe::Driver::decimater);
}

PeerResult simplify_quadric_refitted(const IndexedMesh& mesh, std::size_t triangles) {
  return simplify_by_recipe(mesh, triangles, "quadric", recipe::Driver::automatic, true);
}

PeerResult simplify_mq(const IndexedMesh& mesh, std::size_t triangles) {
  return simplify_by_recipe(mesh, triangles, "mq", recipe::Driver::bulk);
}

template <peers::Simplifier (*kPeer)()>
PeerResult simplify_by_peer(const IndexedMesh& mesh, std::size_t triangles) {
  const peers::Arrays arrays = peers::in_float(mesh);
  const auto run = kPeer().start();
  run->load(arrays);
  recipe::Stopwatch watch;
  run->simplify(triangles);
  const double seconds = watch.lap();
  return {peers::in_double(run->result()), 1e3 * seconds};
}

}  // namespace

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all = {
      {"openmesh", "OpenMesh ModQuadricT", simplify_openmesh},
      {"meshopt", "meshopt_simplify", simplify_by_peer<peers::meshopt>},
      {"quadric-refitted", "quadric, refitted", simplify_quadric_refitted},
      {"mq", "Whittle mq", simplify_mq},
#ifdef WHITTLE_WITH_CGAL
      {"cgal", "CGAL edge_collapse", simplify_by_peer<peers::cgal_lindstrom_turk>},
#endif
  };
  return all;
}

}  // namespace whittle::bench
