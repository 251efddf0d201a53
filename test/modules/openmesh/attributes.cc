#include "whittle/openmesh/attributes.hh"

#include "OpenMeshFixture.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModCircumcenterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModFassT.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/ModSphereScanT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/ModVtdT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/surface/triangle.hh"

using namespace whittle;

namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  using Color = OpenMesh::Vec3uc;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color |
                   OpenMesh::Attributes::TexCoord2D);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
};
using RichMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// Attributes that depend linearly on the place: colour 10 x, texture coordinate (x, y), corner coordinate
/// likewise, with `offset` added left of `seam`.
RichMesh painted(const IndexedMesh& in, double seam = -1, float offset = 0) {
  auto mesh = fixture::to_openmesh<RichMesh>(in);
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    mesh.set_normal(v, {0, 0, 1});
    mesh.set_color(v, OpenMesh::Vec3uc(static_cast<unsigned char>(std::lround(10 * p[0])), 0, 255));
    mesh.set_texcoord2D(v, {static_cast<float>(p[0]), static_cast<float>(p[1])});
  }
  for (const auto f : mesh.faces()) {
    const float add = mesh.calc_face_centroid(f)[0] < seam ? offset : 0;
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(mesh.to_vertex_handle(h));
      mesh.set_texcoord2D(h, {static_cast<float>(p[0]) + add, static_cast<float>(p[1])});
    }
  }
  return mesh;
}

/// Runs a module in a decimater of type D and hands the mesh over while its status is there.
template <template <typename> class D, template <typename> class Module, typename M, typename Setup,
          typename Look>
void decimate_with(M mesh, Setup setup, Look look) {
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  D<M> decimater(mesh);
  typename Module<M>::Handle handle;
  decimater.add(handle);
  setup(decimater.module(handle));
  REQUIRE(decimater.initialize());
  REQUIRE(decimater.decimate() > 0);
  decimater.module(handle).finish();
  look(mesh);
}
template <template <typename> class Module, typename Setup, typename Look>
void decimate(const RichMesh& mesh, Setup setup, Look look) {
  decimate_with<OpenMesh::Decimater::DecimaterT, Module>(mesh, setup, look);
}

/// Every module of the papers, on one mesh whose edges have about length `unit`; they leave seams where they are.
template <template <typename> class D, typename M, typename Look>
void with_papers_modules_in(const M& mesh, double unit, Look look) {
  decimate_with<D, ModCircumcenterT>(
      mesh, [](auto&) {}, look);
  decimate_with<D, ModFaceAngleT>(
      mesh, [](auto& m) { m.set_max_normal_angle(60); }, look);
  decimate_with<D, ModVertexDistanceT>(
      mesh, [&](auto& m) { m.set_max_distance(1.2 * unit); }, look);
  decimate_with<D, ModSphereScanT>(
      mesh, [&](auto& m) { m.set_radius(1.2 * unit); }, look);
  decimate_with<D, ModVtdT>(
      mesh, [&](auto& m) { m.set_max_distance(1.6 * unit); }, look);
  decimate_with<D, ModFassT>(
      mesh, [&](auto& m) { m.set_radius(1.5 * unit); }, look);
}
/// And mq.
template <template <typename> class D, typename M, typename Look>
void with_every_module_in(const M& mesh, double unit, Look look) {
  with_papers_modules_in<D>(mesh, unit, look);
  decimate_with<D, ModMemorylessQuadricT>(
      mesh, [&](auto& m) { m.set_target_faces(mesh.n_faces() / 4); }, look);
}
template <typename Look>
void with_every_module(const RichMesh& mesh, Look look) {
  with_every_module_in<OpenMesh::Decimater::DecimaterT>(mesh, 1, look);
}

template <typename Look>
void with_papers_modules(const RichMesh& mesh, Look look) {
  with_papers_modules_in<OpenMesh::Decimater::DecimaterT>(mesh, 1, look);
}

struct FloatTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::TexCoord3D);
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord3D);
};
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<FloatTraits>;

/// A float mesh whose texture coordinates, of vertices and of half-edges, are the places themselves.
FloatMesh placed(const IndexedMesh& in) {
  auto mesh = fixture::to_openmesh<FloatMesh>(in);
  for (const auto v : mesh.vertices()) mesh.set_texcoord3D(v, mesh.point(v));
  for (const auto h : mesh.halfedges())
    if (!h.is_boundary()) mesh.set_texcoord3D(h, mesh.point(h.to()));
  return mesh;
}

Eigen::Vector3d nearest_point(const IndexedMeshT<float>& mesh, const Eigen::Vector3d& p) {
  Eigen::Vector3d nearest(HUGE_VAL, 0, 0);
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d q =
        detail::closest_point<double>(p, mesh.points[t[0]].cast<double>(), mesh.points[t[1]].cast<double>(),
                                      mesh.points[t[2]].cast<double>());
    if ((q - p).norm() < (nearest - p).norm()) nearest = q;
  }
  return nearest;
}

}  // namespace

TEST_CASE("three values are interpolated component by component") {
  const auto interpolate = [](const auto& a, const auto& b, const auto& c, double share_b, double share_c) {
    return detail::interpolated(std::array{&a, &b, &c}, {1 - share_b - share_c, share_b, share_c});
  };
  CHECK(interpolate(2.0, 4.0, 10.0, 0.25, 0.5) == 6.5);
  using Byte = unsigned char;
  CHECK(int(interpolate(Byte(10), Byte(21), Byte(0), 0.5, 0)) == 16);  // to the nearest
  using OpenMesh::Vec2f, OpenMesh::Vec4uc;
  CHECK(interpolate(Vec2f(0, 1), Vec2f(1, 3), Vec2f(4, 0), 0.5, 0.25) == Vec2f(1.5f, 1.75f));
  CHECK(interpolate(Vec4uc(0, 100, 200, 255), Vec4uc(255, 0, 0, 255), Vec4uc(9, 9, 9, 255), 0, 0) ==
        Vec4uc(0, 100, 200, 255));
}

TEST_CASE("survivors take the values at the nearest point of the input, on flat and on curved meshes") {
  const double unit = GENERATE(1.0, 0.18);
  const IndexedMesh in = unit == 1 ? meshes::shaken(meshes::flat_grid(14), 0.2, 3)
                                   : meshes::shaken(meshes::torus(32, 16), 0.01, 3);
  const FloatMesh mesh = placed(in);
  const IndexedMeshT<float> before = to_indexed(mesh);
  double range = 0;
  for (const auto& p : before.points) range = std::max(range, 2 * p.cast<double>().cwiseAbs().maxCoeff());
  with_every_module_in<SweepDecimaterT>(mesh, unit, [&](FloatMesh& out) {
    const auto check = [&](const auto& value, const Eigen::Vector3d& nearest) {
      CHECK((Eigen::Vector3d(value[0], value[1], value[2]) - nearest).norm() < 1e-6 * range);
    };
    for (const auto v : out.vertices()) {
      const auto p = out.point(v);
      const Eigen::Vector3d nearest = nearest_point(before, {p[0], p[1], p[2]});
      check(out.texcoord3D(v), nearest);
      for (const auto h : out.vih_range(v))
        if (!h.is_boundary()) check(out.texcoord3D(h), nearest);
    }
  });
}

TEST_CASE("attributes do not depend on the decimater") {
  const RichMesh mesh = painted(meshes::shaken(meshes::flat_grid(14), 0.2, 5), 6.5, 100);
  std::vector<RichMesh> by_heap;
  with_every_module_in<OpenMesh::Decimater::DecimaterT>(mesh, 1, [&](RichMesh& m) { by_heap.push_back(m); });
  const auto check_same = [&](std::vector<RichMesh>& expected, auto run) {
    std::size_t i = 0;
    run([&](RichMesh& m) {
      const RichMesh& other = expected[i++];
      for (const auto v : m.all_vertices()) {
        REQUIRE(m.status(v).deleted() == other.status(v).deleted());
        if (m.status(v).deleted()) continue;
        CHECK(m.normal(v) == other.normal(v));
        CHECK(m.color(v) == other.color(v));
        CHECK(m.texcoord2D(v) == other.texcoord2D(v));
      }
      for (const auto h : m.all_halfedges())
        if (!m.status(h).deleted() && !m.is_boundary(h)) CHECK(m.texcoord2D(h) == other.texcoord2D(h));
    });
    CHECK(i == 7);
  };
  check_same(by_heap, [&](auto look) { with_every_module_in<SweepDecimaterT>(mesh, 1, look); });
  check_same(by_heap, [&](auto look) { with_every_module_in<LazyDecimaterT>(mesh, 1, look); });
}

TEST_CASE("a seam that ends inside the mesh keeps its end, and both sides their coordinates") {
  RichMesh mesh = painted(meshes::flat_grid(14));
  const auto is_left_of_slit = [](const RichMesh& m, auto h) {  // of the line x = 6, where y > 6
    const auto p = m.point(m.to_vertex_handle(h));
    return p[0] == 6 && p[1] > 6 && m.calc_face_centroid(m.face_handle(h))[0] < 6;
  };
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f))
      if (is_left_of_slit(mesh, h)) mesh.set_texcoord2D(h, {50, 0});
  with_papers_modules(mesh, [&](RichMesh& out) {
    std::size_t on_slit = 0;
    for (const auto v : out.vertices()) on_slit += out.point(v)[0] == 6 && out.point(v)[1] >= 6;
    CHECK(on_slit == 8);
    for (const auto f : out.faces())
      for (const auto h : out.fh_range(f)) {
        const auto p = out.point(out.to_vertex_handle(h));
        if (p[0] == 6 && p[1] > 6) CHECK(out.texcoord2D(h)[0] == (is_left_of_slit(out, h) ? 50 : 6));
      }
  });
}

TEST_CASE("what depends linearly on the place still does after every module") {
  const RichMesh mesh = painted(meshes::shaken(meshes::flat_grid(14), 0, 1));
  with_every_module(mesh, [](RichMesh& out) {
    for (const auto v : out.vertices()) {
      const auto p = out.point(v);
      CHECK(out.texcoord2D(v)[0] == Approx(p[0]).margin(1e-5));
      CHECK(out.texcoord2D(v)[1] == Approx(p[1]).margin(1e-5));
      CHECK(std::abs(double(out.color(v)[0]) - 10 * p[0]) <= 0.501);  // rounded once
      CHECK(int(out.color(v)[2]) == 255);
      CHECK((out.normal(v) - OpenMesh::Vec3d(0, 0, 1)).norm() < 1e-12);
    }
    for (const auto f : out.faces())
      for (const auto h : out.fh_range(f)) {
        const auto p = out.point(out.to_vertex_handle(h));
        CHECK(out.texcoord2D(h)[0] == Approx(p[0]).margin(1e-5));
        CHECK(out.texcoord2D(h)[1] == Approx(p[1]).margin(1e-5));
      }
  });
}

TEST_CASE("the papers' modules leave vertices on a texture seam, and both sides keep their coordinates") {
  const RichMesh mesh = painted(meshes::flat_grid(14), 6, 100);
  with_papers_modules(mesh, [](RichMesh& out) {
    std::size_t on_seam = 0;
    for (const auto v : out.vertices()) on_seam += out.point(v)[0] == 6 && detail::is_on_seam(out, v);
    CHECK(on_seam == 14);
    for (const auto f : out.faces())
      for (const auto h : out.fh_range(f)) {
        const double x = out.point(out.to_vertex_handle(h))[0], center = out.calc_face_centroid(f)[0];
        const double add = center < 6 ? 100 : 0;
        CHECK(out.texcoord2D(h)[0] == Approx(x + add).margin(1e-4));
      }
  });
}

TEST_CASE("normals are interpolated and keep their length") {
  RichMesh mesh = painted(meshes::triangle_in_hexagon({0, 0, 0}, {0.2, 0, 0}, {0.1, 0.3, 0}, 1));
  mesh.set_normal(RichMesh::VertexHandle(0), {1, 0, 0});
  mesh.set_normal(RichMesh::VertexHandle(1), {0, 1, 0});
  decimate<ModVertexDistanceT>(
      mesh, [](auto& m) { m.set_max_distance(0.25); },
      [](const RichMesh& out) {
        const auto n = out.normal(RichMesh::VertexHandle(0));
        CHECK((n - OpenMesh::Vec3d(1, 1, 0).normalized()).norm() < 1e-12);
      });
}

TEST_CASE("FAD leaves the apex of a fan as it was") {
  RichMesh mesh = painted(meshes::cone(6, 0.05));
  mesh.set_color(RichMesh::VertexHandle(0), {200, 200, 200});
  const RichMesh before = mesh;
  decimate<ModFaceAngleT>(
      mesh, [](auto&) {},
      [&](const RichMesh& out) {
        for (const auto v : out.vertices()) {
          CHECK(out.color(v) == before.color(v));
          CHECK(out.point(v) == before.point(v));
        }
      });
}

TEST_CASE("a user's own properties stay, and none of ours is left") {
  RichMesh mesh = painted(meshes::flat_grid(8));
  OpenMesh::VPropHandleT<int> number;
  mesh.add_property(number, "number");
  for (const auto v : mesh.vertices()) mesh.property(number, v) = v.idx();
  with_every_module(mesh, [&](RichMesh& out) {
    for (const auto v : out.vertices()) CHECK(out.property(number, v) == v.idx());
  });
  const auto alive = [](const RichMesh& m) {
    return std::count_if(m.vprops_begin(), m.vprops_end(), [](auto* p) { return p != nullptr; });
  };
  const auto before = alive(mesh);
  {
    OpenMesh::Decimater::DecimaterT<RichMesh> decimater(mesh);
    ModFassT<RichMesh>::Handle fass;
    decimater.add(fass);
    decimater.module(fass).set_radius(1.2);
    decimater.initialize();
    decimater.decimate();
  }
  CHECK(alive(mesh) == before);
}
