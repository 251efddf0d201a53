#include "whittle/openmesh/attributes.hh"

#include "OpenMeshFixture.hh"
#include "whittle/ModCircumcenterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModFassT.hh"
#include "whittle/ModSphereScanT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/ModVtdT.hh"

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

/// Runs a module in DecimaterT and hands the mesh over while its status is there.
template <template <typename> class Module, typename Setup, typename Look>
void decimate(RichMesh mesh, Setup setup, Look look) {
  mesh.request_vertex_status();
  mesh.request_halfedge_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  OpenMesh::Decimater::DecimaterT<RichMesh> decimater(mesh);
  typename Module<RichMesh>::Handle handle;
  decimater.add(handle);
  setup(decimater.module(handle));
  REQUIRE(decimater.initialize());
  REQUIRE(decimater.decimate() > 0);
  look(mesh);
}

/// Every module that moves or removes vertices, on one mesh.
template <typename Look>
void with_every_module(const RichMesh& mesh, Look look) {
  decimate<ModCircumcenterT>(
      mesh, [](auto&) {}, look);
  decimate<ModFaceAngleT>(
      mesh, [](auto& m) { m.set_max_normal_angle(60); }, look);
  decimate<ModVertexDistanceT>(
      mesh, [](auto& m) { m.set_max_distance(1.2); }, look);
  decimate<ModSphereScanT>(
      mesh, [](auto& m) { m.set_radius(1.2); }, look);
  decimate<ModVtdT>(
      mesh, [](auto& m) { m.set_max_distance(1.6); }, look);
  decimate<ModFassT>(
      mesh, [](auto& m) { m.set_radius(1.5); }, look);
}

}  // namespace

TEST_CASE("blending") {
  CHECK(blend(2.0, 4.0, 0.25) == 2.5);
  CHECK(blend<unsigned char>(10, 21, 0.5) == 16);  // to the nearest
  CHECK(blend(OpenMesh::Vec2f(0, 1), OpenMesh::Vec2f(1, 3), 0.5) == OpenMesh::Vec2f(0.5f, 2));
  CHECK(blend(OpenMesh::Vec4uc(0, 100, 200, 255), OpenMesh::Vec4uc(255, 0, 0, 255), 0) ==
        OpenMesh::Vec4uc(0, 100, 200, 255));
}

TEST_CASE("what depends linearly on the place still does after every module") {
  const RichMesh mesh = painted(meshes::shaken(meshes::flat_grid(14), 0, 1));
  with_every_module(mesh, [](RichMesh& out) {
    for (const auto v : out.vertices()) {
      const auto p = out.point(v);
      CHECK(out.texcoord2D(v)[0] == Approx(p[0]).margin(1e-5));
      CHECK(out.texcoord2D(v)[1] == Approx(p[1]).margin(1e-5));
      CHECK(std::abs(double(out.color(v)[0]) - 10 * p[0]) <= 2.0);  // rounded at each step
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

TEST_CASE("vertices on a texture seam stay, and both of its sides keep their coordinates") {
  const RichMesh mesh = painted(meshes::flat_grid(14), 6, 100);
  with_every_module(mesh, [](RichMesh& out) {
    std::size_t on_seam = 0;
    for (const auto v : out.vertices()) on_seam += out.point(v)[0] == 6 && is_on_seam(out, v);
    CHECK(on_seam == 14);
    for (const auto f : out.faces())
      for (const auto h : out.fh_range(f)) {
        const double x = out.point(out.to_vertex_handle(h))[0];
        const double add = out.calc_face_centroid(f)[0] < 6 ? 100 : 0;
        CHECK(out.texcoord2D(h)[0] == Approx(x + add).margin(1e-4));
      }
  });
}

TEST_CASE("normals are blended and keep their length") {
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
