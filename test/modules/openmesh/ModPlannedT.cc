#include "whittle/openmesh/ModPlannedT.hh"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "OpenMeshFixture.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/plan/PlanDraft.hh"

// Specialises what the mesh headers declare, so it must come after them.
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

using namespace whittle;
using fixture::Mesh;

namespace {

struct EigenTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  VertexAttributes(OpenMesh::Attributes::Status);
};
using EigenMesh = OpenMesh::TriMesh_ArrayKernelT<EigenTraits>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

/// How many properties a mesh has; a removed one leaves an empty place behind.
template <typename M>
std::ptrdiff_t properties(const M& mesh) {
  const auto count = [](auto begin, auto end) {
    return std::count_if(begin, end, [](auto* p) { return p; });
  };
  return count(mesh.vprops_begin(), mesh.vprops_end()) + count(mesh.hprops_begin(), mesh.hprops_end()) +
         count(mesh.eprops_begin(), mesh.eprops_end()) + count(mesh.fprops_begin(), mesh.fprops_end()) +
         count(mesh.mprops_begin(), mesh.mprops_end());
}

/// One pass of IVDD in OpenMesh's own DecimaterT; the living mesh afterwards.
template <typename M>
IndexedMeshT<typename M::Scalar> decimated(M& mesh, double distance, double factor = 1) {
  OpenMesh::Decimater::DecimaterT<M> decimater(mesh);
  typename ModVertexDistanceT<M>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(distance);
  if (factor < 1) decimater.module(ivdd).set_error_tolerance_factor(factor);
  REQUIRE(decimater.initialize());
  decimater.decimate();
  return to_indexed(mesh);
}

/// A planner of one cluster.
struct OneCluster {
  std::vector<std::uint32_t> members{0, 1, 2};
  Eigen::Vector3d target{0.1, 0.1, 0};
  void validate() const {}
  OneCluster scaled(double) const { return *this; }
  template <typename Real>
  CollapsePlan plan(const SurfaceT<Real>& surface) const {
    PlanDraftT<Real> draft(surface, FlipGuard());
    REQUIRE(draft.merge(members, target) == PlanDraftT<Real>::Verdict::accepted);
    return draft.take();
  }
};
template <typename M>
struct ModOneClusterT : ModPlannedT<M, OneCluster> {
  DECIMATING_MODULE(ModOneClusterT, M, OneCluster);
  explicit ModOneClusterT(M& mesh) : ModPlannedT<M, OneCluster>(mesh) {}
};

/// A binary module that forbids some vertices to vanish.
template <typename M>
struct ModForbidT : OpenMesh::Decimater::ModBaseT<M> {
  DECIMATING_MODULE(ModForbidT, M, Forbid);
  explicit ModForbidT(M& mesh) : OpenMesh::Decimater::ModBaseT<M>(mesh, true) {}
  float collapse_priority(const CollapseInfo& ci) override {
    const bool is_forbidden = std::find(vertices.begin(), vertices.end(), ci.v0.idx()) != vertices.end();
    return is_forbidden ? float(Base::ILLEGAL_COLLAPSE) : float(Base::LEGAL_COLLAPSE);
  }
  std::vector<int> vertices;
};

/// Where the survivor lies after a cluster was executed but for what is forbidden.
template <template <typename> class D>
Mesh::Point survivor(Mesh mesh, const OneCluster& cluster, const std::vector<int>& forbidden,
                     std::size_t most = 0) {
  D<Mesh> decimater(mesh);
  typename ModOneClusterT<Mesh>::Handle one;
  typename ModForbidT<Mesh>::Handle forbid;
  decimater.add(one);
  decimater.add(forbid);
  decimater.module(one).set_planner(cluster);
  decimater.module(forbid).vertices = forbidden;
  REQUIRE(decimater.initialize());
  const std::size_t all = cluster.members.size() - 1 - forbidden.size();
  REQUIRE(decimater.decimate(most) == (most ? most : all));
  return mesh.point(Mesh::VertexHandle(static_cast<int>(cluster.members[0])));
}

}  // namespace

TEMPLATE_TEST_CASE("a module works on every kind of points and does what the bulk executor does", "", Mesh,
                   DoubleMesh, EigenMesh) {
  using Real = typename TestType::Scalar;
  TestType mesh = fixture::to_openmesh<TestType>(meshes::torus(20, 12));
  const IndexedMeshT<Real> before = to_indexed(mesh);
  VertexDistance planner;
  planner.max_distance = 0.15;
  const auto expected = execute(planner.plan(SurfaceT<Real>(before)), before);
  REQUIRE(expected.mesh.triangles.size() < before.triangles.size());
  const auto had = properties(mesh);
  CHECK(meshes::canonical(decimated(mesh, 0.15)) == meshes::canonical(expected.mesh));
  CHECK(properties(mesh) == had);
}

TEST_CASE("a module's result repeats bit for bit") {
  Mesh a = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(20, 12), 0.01, 3)), b = a;
  const auto first = decimated(a, 0.15), second = decimated(b, 0.15);
  CHECK(first.points == second.points);
  CHECK(first.triangles == second.triangles);
}

TEST_CASE("the error tolerance factor scales the threshold") {
  Mesh a = fixture::to_openmesh<Mesh>(meshes::torus(20, 12)), b = a;
  CHECK(meshes::canonical(decimated(a, 0.2, 0.75)) == meshes::canonical(decimated(b, 0.15)));
}

TEST_CASE("locked and feature vertices stay where they are") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(20, 12));
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  for (int v = 0; v < 240; v += 3) mesh.status(Mesh::VertexHandle(v)).set_locked(v % 2 == 0);
  for (int v = 0; v < 240; v += 3) mesh.status(Mesh::VertexHandle(v)).set_feature(v % 2 != 0);
  const Mesh before = mesh;
  decimated(mesh, 0.3);
  std::size_t deleted = 0;
  for (const auto v : mesh.all_vertices()) deleted += mesh.status(v).deleted();
  CHECK(deleted > 20);
  for (int i = 0; i < 240; i += 3) {
    const Mesh::VertexHandle v(i);
    CHECK_FALSE(mesh.status(v).deleted());
    CHECK(mesh.point(v) == before.point(v));
  }
}

TEST_CASE("face normals follow a moved vertex") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(20, 12));
  mesh.request_face_normals();
  mesh.update_face_normals();
  mesh.request_face_status();
  decimated(mesh, 0.15);
  for (const auto f : mesh.all_faces())
    if (!mesh.status(f).deleted()) CHECK((mesh.normal(f) - mesh.calc_face_normal(f)).norm() == 0);
}

TEST_CASE("in binary mode a module forbids what is not planned") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(20, 12));
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(ivdd);
  decimater.add(quadric);
  decimater.module(ivdd).set_max_distance(0.15);
  decimater.module(ivdd).set_binary(true);
  REQUIRE(decimater.initialize());
  const std::size_t planned = decimater.module(ivdd).plan().collapses.size();
  const std::size_t done = decimater.decimate();
  CHECK(done > 0);
  CHECK(done <= planned);
}

TEST_CASE("another pass: initialize the module again, or collect the garbage") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(20, 12));
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.25);
  REQUIRE(decimater.initialize());
  REQUIRE(decimater.decimate() > 0);
  CHECK(decimater.decimate() == 0);  // the plan is used up
  SECTION("initialize") {
    decimater.module(ivdd).initialize();
  }
  SECTION("garbage collection") {
    mesh.garbage_collection();
  }
  CHECK(decimater.decimate() > 0);
}

TEST_CASE("observers stop a module early, targets stop it in time") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::torus(20, 12));
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  ModVertexDistanceT<Mesh>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.25);
  REQUIRE(decimater.initialize());
  SECTION("observer") {
    fixture::StopAfter stop(10, 5);
    decimater.set_observer(&stop);
    CHECK(decimater.decimate() == 10);
  }
  SECTION("number of vertices") {
    CHECK(decimater.decimate_to(233) == 7);
  }
  SECTION("number of faces") {
    CHECK(decimater.decimate_to_faces(0, 470) == 5);
  }
}

TEST_CASE("what cannot be planned on is refused by name") {
  SECTION("a face with four corners") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    std::vector<OpenMesh::VertexHandle> corners;
    for (int i = 0; i < 4; ++i)
      corners.push_back(mesh.add_vertex({float(i % 2), float(i / 2), float(i * i)}));
    std::swap(corners[2], corners[3]);
    mesh.add_face(corners);
    CHECK_THROWS_WITH(to_indexed(mesh), "face 0 is not a triangle");
  }
  SECTION("not a number") {
    Mesh mesh = fixture::to_openmesh<Mesh>(meshes::tetrahedron());
    mesh.set_point(Mesh::VertexHandle(1), {0, std::nanf(""), 0});
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    ModVertexDistanceT<Mesh>::Handle ivdd;
    decimater.add(ivdd);
    CHECK_THROWS_AS(decimater.initialize(), InvalidMesh);
  }
}

TEST_CASE("meshes without anything to do are left alone") {
  IndexedMesh triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  IndexedMesh isolated = meshes::tetrahedron();
  isolated.points.emplace_back(9, 9, 9);
  for (const IndexedMesh& in : {IndexedMesh(), triangle, isolated}) {
    Mesh mesh = fixture::to_openmesh<Mesh>(in);
    const auto out = decimated(mesh, 100);
    CHECK(out.triangles.size() == in.triangles.size());
    CHECK(out.points.size() == in.points.size());
  }
}

TEMPLATE_TEST_CASE("a cluster of which a part is forbidden leaves its survivor among those that merged", "",
                   OpenMesh::Decimater::DecimaterT<Mesh>, SweepDecimaterT<Mesh>, LazyDecimaterT<Mesh>) {
  const auto at = [](const Mesh& mesh, const OneCluster& cluster, const std::vector<int>& forbidden,
                     std::size_t most = 0) {
    if constexpr (std::is_same_v<TestType, SweepDecimaterT<Mesh>>)
      return survivor<SweepDecimaterT>(mesh, cluster, forbidden, most);
    else if constexpr (std::is_same_v<TestType, LazyDecimaterT<Mesh>>)
      return survivor<LazyDecimaterT>(mesh, cluster, forbidden, most);
    else
      return survivor<OpenMesh::Decimater::DecimaterT>(mesh, cluster, forbidden, most);
  };
  using Point = Mesh::Point;
  Mesh mesh =
      fixture::to_openmesh<Mesh>(meshes::triangle_in_hexagon({0, 0, 0}, {0.5, 0, 0}, {0, 0.25, 0}, 1));
  SECTION("three vertices") {
    const OneCluster cluster;
    CHECK(at(mesh, cluster, {}) == Point(0.1f, 0.1f, 0));
    CHECK(at(mesh, cluster, {1}) == Point(0, 0.125f, 0));
    CHECK(at(mesh, cluster, {2}) == Point(0.25f, 0, 0));
  }
  SECTION("four vertices") {
    mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(4));
    const OneCluster cluster{{5, 6, 10, 9}, {1.25, 1.25, 0}};
    CHECK(at(mesh, cluster, {}) == Point(1.25f, 1.25f, 0));
    const Point centroid = at(mesh, cluster, {9});  // of (1, 1), (2, 1) and (2, 2)
    CHECK((centroid - Point(5 / 3.f, 4 / 3.f, 0)).norm() < 1e-6f);
    CHECK(at(mesh, cluster, {6, 9}) == Point(1.5f, 1.5f, 0));
  }
  SECTION("a survivor that the whole cluster leaves in place") {
    const OneCluster cluster{{0, 1, 2}, {0, 0, 0}};
    CHECK(at(mesh, cluster, {}) == Point(0, 0, 0));
    CHECK(at(mesh, cluster, {1}) == Point(0, 0, 0));
  }
  SECTION("a decimater that stops in the middle, as execute() does") {
    const OneCluster cluster;
    const auto flat = to_indexed(mesh);
    const auto executed = execute(cluster.plan(SurfaceT<float>(flat)), flat, 1);
    const auto& p = executed.mesh.points[executed.vertex_map[0]];
    CHECK(at(mesh, cluster, {}, 1) == Point(0.25f, 0, 0));
    CHECK(Point(p[0], p[1], p[2]) == Point(0.25f, 0, 0));
  }
}

TEST_CASE("what is in the middle of a cluster lies where earlier collapses have left it") {
  // (0, 1) merge at 1's place first, then 2 and 3 into 0; the second of these is cut off.
  CollapsePlan plan;
  plan.collapses = {
      {1, 0, 2, 0, {1, 0, 0}}, {4, 2, 2, 0, {2, 4, 0}}, {2, 0, 2, 1, {9, 9, 9}}, {3, 0, 2, 0, {9, 9, 9}}};
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  CHECK(execute(plan, mesh, 3).mesh.points[0] == Eigen::Vector3d(1.5, 2, 0));
  CHECK(execute(plan, mesh, 4).mesh.points[0] == Eigen::Vector3d(9, 9, 9));
}

TEST_CASE("a plan is the same on any number of threads") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(160, 80), 0.001, 5));
  const auto points = [&](std::size_t threads) {
    ModVertexDistanceT<Mesh> ivdd(mesh);
    ivdd.set_max_distance(0.05);
    ivdd.set_threads(threads);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (const Collapse& c : ivdd.plan().collapses) out.emplace_back(c.from, c.to);
    return out;
  };
  const auto one = points(1);
  CHECK(one.size() > 1000);
  CHECK(points(3) == one);
  CHECK(points(0) == one);
}

TEST_CASE("only points with three coordinates will do") {
  struct FlatMesh {
    using Point = OpenMesh::Vec2f;
  };
  CHECK(detail::has_points_in_space<Mesh>);
  CHECK(detail::has_points_in_space<EigenMesh>);
  CHECK_FALSE(detail::has_points_in_space<FlatMesh>);
}
