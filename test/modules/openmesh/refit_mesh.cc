#include "whittle/openmesh/refit_mesh.hh"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>

#include "OpenMeshFixture.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/bulk.hh"
#include "whittle/compact.hh"
#include "whittle/decimate.hh"
#include "whittle/surface/triangle.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

Mesh torus() {
  return fixture::to_openmesh<Mesh>(meshes::shaken(meshes::torus(32, 16), 0.01, 5));  // 1024 faces
}

DecimateOptions to_half() {
  DecimateOptions options;
  options.ratio = 0.5;
  return options;
}

MemorylessQuadric to_faces(std::size_t faces) {
  MemorylessQuadric mq;
  mq.target_faces = faces;
  return mq;
}

void request_status(Mesh& mesh) {
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
}

/// What mq makes of a torus in a decimater; `setup(mesh, module)` before it plans, `after(module)` after the last collapse.
template <template <typename> class D, typename Setup, typename After>
Mesh decimated(Setup setup, After after, bool only_selected = false) {
  Mesh mesh = torus();
  request_status(mesh);
  {
    D<Mesh> decimater(mesh);
    ModMemorylessQuadricT<Mesh>::Handle handle;
    decimater.add(handle);
    auto& mq = decimater.module(handle);
    mq.set_target_faces(512);
    setup(mesh, mq);
    decimater.initialize();
    decimater.decimate(0, only_selected);
    after(mq);
  }
  compact(mesh);
  return mesh;
}

const auto nothing = [](auto&&...) {};

}  // namespace

TEST_CASE("Whittle's drivers refit what mq has left, and OpenMesh's own when finish is called") {
  const Mesh plain = decimated<SweepDecimaterT>([](Mesh&, auto& mq) { mq.set_refit(false); },
                                                [](auto& mq) { CHECK(mq.refit_report().moved == 0); });
  const Mesh swept =
      decimated<SweepDecimaterT>(nothing, [](auto& mq) { CHECK(mq.refit_report().moved > 200); });
  const auto points = [](const Mesh& mesh) { return to_indexed(mesh).points; };
  REQUIRE(points(plain).size() == points(swept).size());
  CHECK(points(plain) != points(swept));
  CHECK(points(decimated<LazyDecimaterT>(nothing, nothing)) == points(swept));
  CHECK(points(decimated<OpenMesh::Decimater::DecimaterT>(nothing, nothing)) == points(plain));
  CHECK(points(decimated<OpenMesh::Decimater::DecimaterT>(nothing, [](auto& mq) { mq.finish(); })) ==
        points(swept));
  CHECK(bulk(to_faces(512), to_indexed(torus())).mesh.points == points(swept));
}

TEST_CASE("a refit leaves vertices that are locked, features or not selected where they are") {
  const auto lock = [](Mesh& mesh, auto& /*mq*/) {
    for (const auto v : mesh.vertices())
      if (v.idx() % 3 == 0) mesh.status(v).set_locked(true);
  };
  const Mesh input = torus(), locked = decimated<SweepDecimaterT>(lock, nothing);
  std::size_t n_locked = 0;
  for (const auto v : locked.vertices()) n_locked += locked.status(v).locked();
  CHECK(n_locked == 171);  // of 512
  std::size_t at = 0;
  for (const auto v : locked.vertices())
    if (locked.status(v).locked())
      CHECK(locked.point(v) == input.point(Mesh::VertexHandle(static_cast<int>(3 * at++))));

  const auto half = [](bool refit, auto after) {
    return decimated<SweepDecimaterT>(
        [refit](Mesh& mesh, auto& mq) {
          mq.set_refit(refit);
          for (const auto v : mesh.vertices()) mesh.status(v).set_selected(v.idx() < 256);
        },
        after, true);
  };
  const Mesh plain = half(false, nothing),
             fitted = half(true, [](auto&mq) { CHECK(mq.refit_report().moved > 50); });
  REQUIRE(plain.n_vertices() == fitted.n_vertices());
  for (const auto v : plain.vertices())
    if (!plain.status(v).selected()) CHECK(plain.point(v) == fitted.point(v));
}

TEST_CASE("attributes and face normals follow the vertices that a refit moves") {
  Mesh mesh = torus();
  mesh.request_vertex_texcoords3D();
  mesh.request_halfedge_texcoords3D();
  mesh.request_face_normals();
  for (const auto v : mesh.vertices()) {
    mesh.set_texcoord3D(v, mesh.point(v));
    for (const auto h : mesh.vih_range(v)) mesh.set_texcoord3D(h, mesh.point(v));
  }
  const Mesh input = mesh;
  const DecimateReport report = decimate(mesh, to_half());
  CHECK(report.refit.moved > 200);
  // A vertex takes the values at the nearest point of the input: where that is.
  for (const auto v : mesh.vertices()) {
    const auto at = mesh.texcoord3D(v);
    CHECK((at - mesh.point(v)).norm() < 0.1);
    double least = HUGE_VAL;
    for (const auto f : input.faces()) {
      std::array<Eigen::Vector3d, 3> p;
      std::size_t k = 0;
      for (const auto w : input.fv_range(f)) {
        const auto q = input.point(w);
        p[k++] = {q[0], q[1], q[2]};
      }
      const auto q = mesh.point(v);
      const Eigen::Vector3d here(q[0], q[1], q[2]);
      least = std::min(least, (detail::closest_point(here, p[0], p[1], p[2]) - here).norm());
    }
    CHECK((at - mesh.point(v)).norm() < least + 1e-4);
    for (const auto h : mesh.vih_range(v)) CHECK((mesh.texcoord3D(h) - at).norm() < 1e-5);
  }
  for (const auto f : mesh.faces()) CHECK((mesh.normal(f) - mesh.calc_face_normal(f)).norm() < 1e-5);
}

TEST_CASE("where texture counts in an OpenMesh mesh, a refit moves vertices as it does in arrays") {
  for (const float weight : {0.0f, 0.2f}) {
    Mesh mesh = torus();
    mesh.request_vertex_texcoords1D();
    for (const auto v : mesh.vertices()) mesh.set_texcoord1D(v, static_cast<float>(mesh.point(v)[0]));
    DecimateOptions options = to_half();
    options.values.texture = weight;
    SurfaceExtras extras;
    if (weight > 0) detail::add_values(mesh, options.values, extras);
    options.values = {};
    const auto arrays = decimate(to_indexed(mesh), options, MemorylessQuadric(), extras);
    options.values.texture = weight;
    CHECK(decimate(mesh, options).refit.moved == arrays.refit.moved);
    CHECK(arrays.refit.moved > 200);
    CHECK(to_indexed(mesh).points == arrays.mesh.points);
  }
}

TEST_CASE("decimate refits what other planners make where it is asked for") {
  VertexDistance ivdd;
  ivdd.max_distance = 0.3;
  DecimateOptions options;
  Mesh plain = torus(), fitted = torus();
  CHECK(decimate(plain, options, ivdd).refit.moved == 0);
  options.refit = true;
  CHECK(decimate(fitted, options, ivdd).refit.moved > 50);
  CHECK(plain.n_faces() == fitted.n_faces());
  options = to_half();
  options.max_distance = 0.1;
  CHECK(decimate(plain, options).refit.moved == 0);
  options.refit = true;
  CHECK_THROWS_AS(decimate(plain, options), InvalidParameter);
}
