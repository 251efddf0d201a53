#include "peers/Peers.hh"

#include "recipe/Recipe.hh"

namespace whittle::bench {

PeerResult simplify_openmesh(const IndexedMesh& mesh, std::size_t triangles) {
  recipe::Recipe recipe;
  // What is stock: without the guards of ours.
  recipe.modules = {recipe::parse_spec("quadric:boundary-weight=0,guard=-1")};
  recipe.target.faces = triangles;
  recipe.driver = recipe::Driver::decimater;
  auto result = recipe::run(mesh, recipe);
  double seconds = 0;
  for (const auto& stage : result.stages) seconds += stage.plan_seconds + stage.execute_seconds;
  return {std::move(result.mesh), 1e3 * seconds};
}

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all = {
      {"openmesh", "OpenMesh ModQuadricT", simplify_openmesh},
      {"meshopt", "meshopt_simplify", simplify_meshopt},
#ifdef WHITTLE_HAVE_CGAL
      {"cgal", "CGAL edge_collapse", simplify_cgal},
#endif
  };
  return all;
}

}  // namespace whittle::bench
