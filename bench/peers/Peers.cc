#include "peers/Peers.hh"

#include "recipe/Recipe.hh"

namespace whittle::bench {

namespace {

PeerResult simplify_by_recipe(const IndexedMesh& mesh, std::size_t triangles, const char* module,
                              recipe::Driver driver) {
  recipe::Recipe recipe;
  recipe.modules = {recipe::parse_spec(module)};
  recipe.target.faces = triangles;
  recipe.driver = driver;
  auto result = recipe::run(mesh, recipe);
  double seconds = 0;
  for (const auto& stage : result.stages) seconds += stage.plan_seconds + stage.execute_seconds;
  return {std::move(result.mesh), 1e3 * seconds};
}

}  // namespace

PeerResult simplify_openmesh(const IndexedMesh& mesh, std::size_t triangles) {
  // What is stock: without the guards of ours.
  return simplify_by_recipe(mesh, triangles, "quadric:boundary-weight=0,guard=-1", recipe::Driver::decimater);
}

PeerResult simplify_mq(const IndexedMesh& mesh, std::size_t triangles) {
  return simplify_by_recipe(mesh, triangles, "mq", recipe::Driver::bulk);
}

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all = {
      {"openmesh", "OpenMesh ModQuadricT", simplify_openmesh},
      {"meshopt", "meshopt_simplify", simplify_meshopt},
      {"mq", "Whittle mq", simplify_mq},
#ifdef WHITTLE_HAVE_CGAL
      {"cgal", "CGAL edge_collapse", simplify_cgal},
#endif
  };
  return all;
}

}  // namespace whittle::bench
