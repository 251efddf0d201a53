#include "peers/cgal_mesh.hh"  // first: the policies need the kernel

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "speed/peers/peers.hh"

namespace whittle::speed {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Kernel = bench::CgalKernel;
using Mesh = bench::CgalMesh;

/// CGAL stops by edges; of a closed mesh there are three for two faces.
sms::Count_stop_predicate<Mesh> stop_at(std::size_t faces) {
  return sms::Count_stop_predicate<Mesh>(faces + faces / 2 + 1);
}

/// CGAL's defaults.
void lindstrom_turk(Mesh& mesh, std::size_t faces) {
  sms::edge_collapse(mesh, stop_at(faces));
}

/// As in CGAL's own example: plane quadrics, and no placement that turns a normal too far.
void garland_heckbert(Mesh& mesh, std::size_t faces) {
  using Policies = sms::GarlandHeckbert_plane_policies<Mesh, Kernel>;
  const Policies policies(mesh);
  const sms::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  sms::edge_collapse(mesh, stop_at(faces),
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
}

class CgalContender : public Contender {
 public:
  using Simplify = void (*)(Mesh&, std::size_t);
  CgalContender(Simplify simplify, std::size_t faces) : simplify_(simplify), faces_(faces) {}

  void load(const Subject& subject) override { bench::fill(mesh_, subject.arrays); }
  void decimate(Phases&) override { simplify_(mesh_, faces_); }

  Arrays unload() override { return bench::taken<float>(mesh_); }

 private:
  Simplify simplify_;
  std::size_t faces_;
  Mesh mesh_;
};

}  // namespace

std::vector<Entry> cgal_entries(const std::vector<Target>& targets) {
  std::vector<Entry> entries;
  for (const Target& target : targets) {
    const auto add = [&](const char* method, CgalContender::Simplify simplify) {
      Entry e;
      e.method = method;
      e.target = target.name;
      e.target_faces = target.faces;
      e.heavy = true;
      e.make = [simplify, faces = target.faces] { return std::make_unique<CgalContender>(simplify, faces); };
      entries.push_back(e);
    };
    add("CGAL Lindstrom-Turk", lindstrom_turk);
    add("CGAL Garland-Heckbert", garland_heckbert);
  }
  return entries;
}

std::size_t cgal_self_intersections(const Arrays& arrays) {
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Exact::Point_3> mesh;
  for (const auto& p : arrays.points) mesh.add_vertex({double(p[0]), double(p[1]), double(p[2])});
  for (const auto& [a, b, c] : arrays.triangles)
    mesh.add_face(decltype(mesh)::Vertex_index(a), decltype(mesh)::Vertex_index(b),
                  decltype(mesh)::Vertex_index(c));
  std::vector<std::pair<decltype(mesh)::Face_index, decltype(mesh)::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

}  // namespace whittle::speed
