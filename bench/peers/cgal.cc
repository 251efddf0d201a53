#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
// The policies need the kernel before them.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "peers/peers.hh"

namespace whittle::peers {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Faces that are not manifold are refused, as by OpenMesh.
template <typename Point>
void fill(CGAL::Surface_mesh<Point>& mesh, const Arrays& arrays) {
  using Vertex = typename CGAL::Surface_mesh<Point>::Vertex_index;
  const auto n = [](std::size_t count) { return static_cast<Mesh::size_type>(count); };
  mesh.reserve(n(arrays.points.size()), n(arrays.triangles.size() * 3 / 2), n(arrays.triangles.size()));
  for (const auto& p : arrays.points) mesh.add_vertex(Point(double(p[0]), double(p[1]), double(p[2])));
  for (const auto& [a, b, c] : arrays.triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
}

Arrays collected(Mesh& mesh) {
  mesh.collect_garbage();
  Arrays out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.points.push_back(Eigen::Vector3d(p.x(), p.y(), p.z()).cast<float>());
  }
  for (const auto f : mesh.faces()) {
    Arrays::Triangle t{};
    std::size_t corner = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[corner++] = static_cast<std::uint32_t>(v.idx());
    out.triangles.push_back(t);
  }
  return out;
}

/// CGAL counts edges. On a closed surface there are three for every two faces, and on any surface a collapse
/// inside takes three edges and two faces away.
sms::Count_stop_predicate<Mesh> stop_at(const Mesh& mesh, std::size_t target) {
  const std::size_t faces = mesh.number_of_faces(), edges = mesh.number_of_edges();
  const std::size_t excess = faces > target ? 3 * (faces - target) / 2 : 0;
  return sms::Count_stop_predicate<Mesh>(edges > excess ? edges - excess + 1 : 1);
}

void lindstrom_turk(Mesh& mesh, std::size_t faces) {
  sms::edge_collapse(mesh, stop_at(mesh, faces));
}

void garland_heckbert(Mesh& mesh, std::size_t faces) {
  using Policies = sms::GarlandHeckbert_plane_policies<Mesh, Kernel>;
  const Policies policies(mesh);
  const sms::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  sms::edge_collapse(mesh, stop_at(mesh, faces),
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
}

template <void (*kSimplify)(Mesh&, std::size_t)>
class CgalRun : public Run {
 public:
  void load(const Arrays& mesh) override { fill(mesh_, mesh); }
  void simplify(std::size_t request) override { kSimplify(mesh_, request); }
  Arrays result() override { return collected(mesh_); }

 private:
  Mesh mesh_;
};

template <void (*kSimplify)(Mesh&, std::size_t)>
Simplifier simplifier(const char* name) {
  Simplifier s;
  s.name = name;
  s.start = []() -> std::unique_ptr<Run> { return std::make_unique<CgalRun<kSimplify>>(); };
  s.slow = true;
  return s;
}

}  // namespace

Simplifier cgal_lindstrom_turk() {
  return simplifier<lindstrom_turk>("CGAL Lindstrom-Turk");
}

Simplifier cgal_garland_heckbert() {
  return simplifier<garland_heckbert>("CGAL Garland-Heckbert");
}

std::size_t cgal_self_intersections(const Arrays& arrays) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Exact::Point_3> mesh;
  fill(mesh, arrays);
  using Face = decltype(mesh)::Face_index;
  std::vector<std::pair<Face, Face>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

}  // namespace whittle::peers
