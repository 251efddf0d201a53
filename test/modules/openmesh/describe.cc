#include "whittle/openmesh/describe.hh"

#include <map>
#include <set>
#include <vector>

#include "OpenMeshFixture.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/surface/seams.hh"

using namespace whittle;
using fixture::Mesh;

namespace {

/// A flat grid of 9 by 9 vertices with half-edge texture coordinates (x, y); left of x = 4, `offset` more.
Mesh textured(float offset) {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(9));
  mesh.request_halfedge_texcoords2D();
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      mesh.set_texcoord2D(h, {p[0] + (mesh.calc_face_centroid(f)[0] < 4 ? offset : 0), p[1]});
    }
  return mesh;
}

}  // namespace

TEST_CASE("half-edge texture coordinates are values where the corners of a vertex agree") {
  const Mesh mesh = textured(10);
  ValueWeights weights;
  weights.texture = 2;
  SurfaceExtras extras;
  detail::add_values(mesh, weights, extras);
  REQUIRE(extras.n_values == 2);
  REQUIRE(extras.values.size() == 2 * mesh.n_vertices());
  for (const auto v : mesh.vertices()) {
    const float *value = &extras.values[2 * std::size_t(v.idx())], x = mesh.point(v)[0], y = mesh.point(v)[1];
    CHECK(detail::is_on_seam(mesh, v) == (x == 4));
    if (x == 4) {
      CHECK((std::isnan(value[0]) && std::isnan(value[1])));
    } else {
      CHECK(value[0] == 2 * (x + (x < 4 ? 10 : 0)));
      CHECK(value[1] == 2 * y);
    }
  }
}

TEST_CASE("what the user has locked or marked as a feature is held, and nothing that is deleted") {
  Mesh mesh = fixture::to_openmesh<Mesh>(meshes::flat_grid(2));
  CHECK(detail::user_flags(mesh) == std::vector<std::uint8_t>(4, 0));
  mesh.request_vertex_status();
  mesh.status(Mesh::VertexHandle(0)).set_locked(true);
  mesh.status(Mesh::VertexHandle(1)).set_feature(true);
  for (const int v : {2, 3}) mesh.status(Mesh::VertexHandle(v)).set_locked(true);
  mesh.status(Mesh::VertexHandle(2)).set_feature(true);
  mesh.status(Mesh::VertexHandle(3)).set_deleted(true);
  CHECK(detail::user_flags(mesh) == std::vector<std::uint8_t>{kLocked, kFeature, kLocked | kFeature, 0});
}

TEST_CASE("every kind of value has its place, and what the mesh lacks has none") {
  Mesh mesh = textured(0);
  ValueWeights weights;
  weights.normals = weights.colours = weights.texture = 1;
  const auto n_values = [&] {
    SurfaceExtras extras;
    detail::add_values(mesh, weights, extras);
    return extras.n_values;
  };
  CHECK(n_values() == 2);
  mesh.request_vertex_normals();
  CHECK(n_values() == 5);
  mesh.request_vertex_colors();
  CHECK(n_values() == 8);
  mesh.request_vertex_texcoords1D();
  mesh.request_halfedge_texcoords1D();
  CHECK(n_values() == 10);
  mesh.request_vertex_texcoords2D();
  CHECK(n_values() == 12);
  for (const auto v : mesh.vertices()) mesh.set_color(v, {255, 0, 51});
  SurfaceExtras extras;
  detail::add_values(mesh, weights, extras);
  CHECK(extras.values[3] == 1);
  CHECK(extras.values[5] == 0.2f);

  ModMemorylessQuadricT<Mesh> mq(mesh);
  mq.set_value_weights(weights);
  CHECK_NOTHROW(mq.plan());
  mesh.request_vertex_texcoords3D();
  CHECK_THROWS_AS(mq.initialize(), InvalidParameter);
}

TEST_CASE("half-edge texture coordinates count where mq merges vertices") {
  Mesh mesh = textured(0);
  for (const auto h : mesh.halfedges())  // a kink in the texture along x = 5
    if (!h.is_boundary()) mesh.set_texcoord2D(h, {std::abs(mesh.point(h.to())[0] - 5), 0});
  const auto n_on_kink = [&](double weight) {  // how many inner vertices of the kink have not moved off it
    Mesh out = mesh;
    out.request_vertex_status();
    out.request_edge_status();
    out.request_face_status();
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(out);
    ModMemorylessQuadricT<Mesh>::Handle mq;
    decimater.add(mq);
    decimater.module(mq).set_target_faces(40);
    ValueWeights weights;
    weights.texture = weight;
    decimater.module(mq).set_value_weights(weights);
    decimater.initialize();
    decimater.decimate();
    double worst = 0;  // how far the texture lies off in the middle of an edge
    for (const auto e : out.edges()) {
      const auto h = e.h0().is_boundary() ? e.h1() : e.h0();
      const auto a = out.point(h.from()), b = out.point(h.to());
      const double got = (out.texcoord2D(h)[0] + out.texcoord2D(h.prev())[0]) / 2;
      worst = std::max(worst, std::abs(got - std::abs((a[0] + b[0]) / 2 - 5)));
    }
    return worst;
  };
  CHECK(n_on_kink(1) < 0.01);
  CHECK(n_on_kink(0) > 0.1);
}

TEST_CASE("wedges tell corners apart whose texture coordinates differ, and there are none without seams") {
  CHECK(detail::corner_numbers(textured(0)).empty());
  CHECK(detail::corner_numbers(fixture::to_openmesh<Mesh>(meshes::flat_grid(4))).empty());
  CHECK(detail::corner_wedges(textured(0), {}).empty());
  Mesh mesh = textured(10);
  mesh.request_face_status();
  mesh.request_edge_status();
  mesh.request_vertex_status();
  mesh.delete_face(mesh.face_handle(5), false);
  const auto wedges = detail::corner_wedges(mesh, detail::corner_numbers(mesh));
  const auto triangles = to_indexed(mesh).triangles;
  REQUIRE(wedges.size() == triangles.size());
  std::map<std::uint32_t, std::set<std::uint32_t>> at;
  for (std::size_t f = 0; f < wedges.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) at[triangles[f][k]].insert(wedges[f][k]);
  for (const auto& [v, numbers] : at) CHECK(numbers.size() == (v % 9 == 4 ? 2 : 1));
}

TEST_CASE("the end of a slit inside the mesh has one wedge, and is on the seam none the less") {
  Mesh mesh = textured(0);
  for (const auto f : mesh.faces())  // a slit along x = 4 from y = 3 on
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      if (p[0] == 4 && p[1] > 3 && mesh.calc_face_centroid(f)[0] < 4) mesh.set_texcoord2D(h, {9, 9});
    }
  const auto seams = on_seams(to_indexed(mesh).triangles,
                              detail::corner_wedges(mesh, detail::corner_numbers(mesh)), mesh.n_vertices());
  for (const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    CHECK(seams[std::size_t(v.idx())] == (p[0] == 4 && p[1] >= 3));
    if (p[0] == 4 && p[1] == 3) CHECK_FALSE(detail::is_on_seam(mesh, v));
  }
}
