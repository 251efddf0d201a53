/// \file
/// The C++ of the README, of the pages on modules and of the headers' comments, each block on a mesh; what it
/// leaves is written, read back and counted.
#include "readme_decimate.inc"

#include "readme_arrays.inc"

#include "readme_module.inc"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <whittle/DelaunayFlips.hh>
#include <whittle/LazyDecimaterT.hh>
#include <whittle/ModChainT.hh>
#include <whittle/ModGuardedQuadricT.hh>
#include <whittle/ModVertexDistanceT.hh>
#include <whittle/planners/FaceAngle.hh>
#include <whittle/planners/VertexDistance.hh>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "catch.hh"
#include "meshes.hh"
#include "whittle/bulk.hh"
#include "whittle/decimate.hh"
#include "whittle/join_doubled.hh"
#include "whittle/openmesh/convert.hh"
#include "whittle/planners/MemorylessQuadric.hh"
#include "whittle/refit.hh"
#include "written.hh"

namespace {

Mesh to_mesh(const whittle::IndexedMesh& in) {
  whittle::IndexedMeshT<float> single;
  for (const auto& p : in.points) single.points.push_back(p.cast<float>());
  single.triangles = in.triangles;
  Mesh mesh;
  REQUIRE(whittle::to_openmesh(single, mesh) == 0);
  return mesh;
}

Mesh torus() {
  return to_mesh(meshes::torus(96, 48));
}
constexpr std::size_t kTorusFaces = 2 * 96 * 48;

/// The planner's own plan on the mesh, in flat arrays: what a module over it must leave.
template <typename Planner>
std::size_t faces_by_plan(const Planner& planner, const Mesh& mesh) {
  const auto flat = whittle::to_indexed(mesh);
  return whittle::execute(planner.plan(whittle::SurfaceT<float>(flat)), flat).mesh.triangles.size();
}

}  // namespace

TEST_CASE("README: to a tenth, boundary, attributes and the user's own properties are kept") {
  const std::uint32_t n = 60;
  Mesh mesh = to_mesh(meshes::grid(n, [](auto i, auto j) { return std::sin(0.1 * i) * std::cos(0.1 * j); }));
  const std::size_t before = mesh.n_faces();
  mesh.request_vertex_colors();
  mesh.request_vertex_texcoords2D();
  mesh.request_halfedge_texcoords2D();
  OpenMesh::VPropHandleT<int> number;
  mesh.add_property(number, "number");
  // Linear in x and y, so that each survivor's position tells what it must have.
  for (auto v : mesh.vertices()) {
    const float x = mesh.point(v)[0] / n, y = mesh.point(v)[1] / n;
    mesh.set_color(v, {static_cast<std::uint8_t>(255 * x), static_cast<std::uint8_t>(255 * y), 7});
    mesh.set_texcoord2D(v, {x, y});
    mesh.property(number, v) = v.idx();
    for (auto h : mesh.vih_range(v)) mesh.set_texcoord2D(h, {x, y});
  }

  to_a_tenth(mesh);

  CHECK(mesh.n_faces() <= before / 10);
  CHECK(mesh.n_faces() > before / 10 - 2);
  std::size_t on_boundary = 0;
  for (auto v : mesh.vertices()) {
    on_boundary += mesh.is_boundary(v);
    const float x = mesh.point(v)[0] / n, y = mesh.point(v)[1] / n;
    CHECK(std::abs(mesh.texcoord2D(v)[0] - x) < 0.001);
    CHECK(std::abs(mesh.texcoord2D(v)[1] - y) < 0.001);
    CHECK(std::abs(mesh.color(v)[0] - 255 * x) < 2);
    CHECK(mesh.color(v)[2] == 7);
    for (auto h : mesh.vih_range(v))
      if (!mesh.is_boundary(h)) CHECK((mesh.texcoord2D(h) - mesh.texcoord2D(v)).norm() < 1e-6);
    CHECK(mesh.property(number, v) >= 0);
  }
  CHECK(on_boundary == 4 * (n - 1));
  CHECK_FALSE(mesh.has_face_status());

  written::check_faces(mesh, mesh.n_faces());
  const Mesh read = written::read_back(mesh, ".ply", OpenMesh::IO::Options::VertexColor);
  REQUIRE(read.n_vertices() == mesh.n_vertices());
  for (auto v : mesh.vertices()) CHECK(read.color(v) == mesh.color(v));
}

TEST_CASE("README: arrays come down to 1000 faces") {
  const auto out = to_1000_faces(meshes::torus(96, 48));
  CHECK(out.triangles.size() == 1000);
  written::check_faces(to_mesh(out), 1000);
}

TEST_CASE("header of decimate: the example keeps the boundary and reaches its target") {
  Mesh mesh = to_mesh(meshes::grid(60, [](auto i, auto j) { return std::sin(0.1 * i) * std::cos(0.1 * j); }));
  {
#include "header_decimate.inc"
    CHECK(report.target_reached);
    CHECK(report.faces == mesh.n_faces());
    CHECK(report.faces_before == 2 * 59 * 59);
  }
  written::check_faces(mesh, 2 * 59 * 59 / 10);
}

TEST_CASE("header of refit: the example reaches its target, and makes what bulk makes by default") {
  const whittle::IndexedMesh mesh = meshes::torus(96, 48);
#include "header_refit.inc"
  CHECK(result.mesh.triangles.size() <= mesh.triangles.size() / 10);
  const auto by_default = whittle::bulk(planner, mesh);
  CHECK(result.mesh.triangles == by_default.mesh.triangles);
  CHECK(result.mesh.points == by_default.mesh.points);
}

TEST_CASE("header of join_doubled: the example keeps a torus closed that was cut along its texture") {
  const whittle::IndexedMesh whole = meshes::torus(96, 48);
  whittle::IndexedMesh mesh;  // a vertex for each side of the cut
  std::vector<float> texture;
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> known;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f) {
    const bool second = f >= whole.triangles.size() / 2;
    auto& corners = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = whole.triangles[f][k];
      const auto fresh = static_cast<std::uint32_t>(mesh.points.size());
      const auto [found, is_new] = known.emplace(std::pair(v, second), fresh);
      corners[k] = found->second;
      if (!is_new) continue;
      mesh.points.push_back(whole.points[v]);
      texture.insert(texture.end(), {second ? 1.0f : 0.0f, 0.0f});
    }
  }
#include "header_join_doubled.inc"
  CHECK(joined.mesh.points.size() == whole.points.size());
  CHECK(small.target_reached);
  CHECK(small.charts == 2);
  const Mesh left = to_mesh(small.mesh);
  for (const auto e : left.edges()) CHECK_FALSE(left.is_boundary(e));
}

TEST_CASE("README: the module in a decimater leaves a mesh that can be written") {
  Mesh mesh = torus();
  whittle::FaceAngle fad;
  fad.max_normal_angle = 30;
  const std::size_t expected = faces_by_plan(fad, mesh);
  REQUIRE(expected < kTorusFaces * 9 / 10);
  remove_flat_vertices(mesh);
  written::check_faces(mesh, expected);
  mesh.garbage_collection();
  written::check_faces(mesh, expected);
}

TEST_CASE("header of ModFaceAngleT: the example leaves what the planner plans") {
  Mesh mesh = torus();
  const std::size_t expected = faces_by_plan(whittle::FaceAngle(), mesh);
#include "header_face_angle.inc"
  written::check_faces(mesh, expected);
}

TEST_CASE("header of ModChainT: the second planner runs on what the first leaves") {
  Mesh mesh = torus();
  whittle::SweepDecimaterT<Mesh> decimater(mesh);
#include "header_chain.inc"
  REQUIRE(decimater.initialize());
  const std::size_t removed = decimater.decimate();
  REQUIRE(removed > 0);
  mesh.garbage_collection();
  written::check_faces(mesh, kTorusFaces - 2 * removed);
}

TEST_CASE("page on chains: both planners of the example remove something") {
  Mesh mesh = torus();
  for (auto v : mesh.vertices())
    mesh.set_point(v, mesh.point(v) * 0.02f);  // edges about the page's threshold
  whittle::FaceAngle first;
  first.max_normal_angle = 20;
  const std::size_t after_first = faces_by_plan(first, mesh);
  whittle::SweepDecimaterT<Mesh> decimater(mesh);
#include "chain.inc"
  REQUIRE(decimater.initialize());
  const std::size_t removed = decimater.decimate();
  mesh.garbage_collection();
  CHECK(after_first < kTorusFaces);
  CHECK(mesh.n_faces() < after_first);
  written::check_faces(mesh, kTorusFaces - 2 * removed);
}

TEST_CASE("page on Delaunay flips: the example flips edges and removes no face") {
  Mesh mesh = to_mesh(meshes::shaken(meshes::flat_grid(30), 0.3, 1));
  const std::size_t faces = mesh.n_faces();
  {
#include "flips.inc"
    CHECK(report.flipped > 0);
    CHECK(report.converged);
  }
  written::check_faces(mesh, faces);
}

TEST_CASE("page on Delaunay flips: nothing is flipped outside of the region") {
  Mesh mesh = to_mesh(meshes::shaken(meshes::flat_grid(30), 0.3, 1)), whole = mesh;
  const std::size_t all = whittle::delaunay_flips(whole).flipped;
  std::vector<bool> changed(mesh.n_vertices(), false);
#include "flips_region.inc"
  CHECK(whittle::to_indexed(mesh).triangles ==
        whittle::to_indexed(to_mesh(meshes::shaken(meshes::flat_grid(30), 0.3, 1))).triangles);
  changed.assign(mesh.n_vertices(), true);
#include "flips_region.inc"
  CHECK(all > 0);
  CHECK(whittle::to_indexed(mesh).triangles == whittle::to_indexed(whole).triangles);
  written::check_faces(mesh, whole.n_faces());
}

TEST_CASE("page on the guarded quadric: the example reaches a tenth of the faces") {
  Mesh mesh = torus();
#include "quadric.inc"
  mesh.garbage_collection();
  written::check_faces(mesh, kTorusFaces / 20 * 2);  // faces go in pairs
}

TEST_CASE("page on all modules: tolerances of a quarter keep the figure's face finer") {
  Mesh mesh = torus();
  const auto is_face_of_the_figure = [&](auto v) { return mesh.point(v)[0] > 0; };
  whittle::SweepDecimaterT<Mesh> decimater(mesh);
  whittle::ModVertexDistanceT<Mesh>::Handle ivdd;
  decimater.add(ivdd);
  decimater.module(ivdd).set_max_distance(0.06);
#include "tolerance.inc"
  REQUIRE(decimater.initialize());
  const std::size_t removed = decimater.decimate();
  mesh.garbage_collection();
  written::check_faces(mesh, kTorusFaces - 2 * removed);
  std::size_t face = 0, rest = 0;
  for (auto v : mesh.vertices()) ++(is_face_of_the_figure(v) ? face : rest);
  CHECK(face > rest * 3 / 2);
}
