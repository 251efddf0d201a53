/// \file
/// Seams of half-edge texture coordinates that move.
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "OpenMeshFixture.hh"
#include "charts.hh"
#include "measure/MeshFacts.hh"
#include "whittle/LazyDecimaterT.hh"
#include "whittle/ModFaceAngleT.hh"
#include "whittle/ModFassT.hh"
#include "whittle/ModMemorylessQuadricT.hh"
#include "whittle/ModSphereScanT.hh"
#include "whittle/ModVertexDistanceT.hh"
#include "whittle/ModVtdT.hh"
#include "whittle/SweepDecimaterT.hh"
#include "whittle/decimate.hh"

using namespace whittle;

namespace {

struct SeamTraits : OpenMesh::DefaultTraitsDouble {
  using TexCoord1D = double;
  using TexCoord2D = OpenMesh::Vec2d;
  using TexCoord3D = OpenMesh::Vec3d;
};
using SeamMesh = OpenMesh::TriMesh_ArrayKernelT<SeamTraits>;
using Uv = SeamMesh::TexCoord2D;

/// Half-edge texture coordinates from `at(chart of the face, point)`.
template <typename At>
SeamMesh textured_charts(const IndexedMesh& in, const std::vector<std::uint32_t>& chart, At at) {
  auto mesh = fixture::to_openmesh<SeamMesh>(in);
  mesh.request_halfedge_texcoords2D();
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f))
      mesh.set_texcoord2D(h, at(chart[std::size_t(f.idx())], mesh.point(mesh.to_vertex_handle(h))));
  return mesh;
}
Uv apart(std::uint32_t chart, const SeamMesh::Point& p) {
  return {p[0] + 100.0 * chart, p[1]};
}

DecimateOptions down_to(std::size_t faces) {
  DecimateOptions options;
  options.faces = faces;
  return options;
}

/// The chart of each face that is left, by its coordinates, which `apart` has made.
std::uint32_t chart_of(const SeamMesh& mesh, SeamMesh::FaceHandle f) {
  return static_cast<std::uint32_t>(std::floor(mesh.texcoord2D(mesh.halfedge_handle(f))[0] / 100 + 0.5));
}

/// Every corner has the coordinates of its place.
void check_linear(const SeamMesh& mesh, double tolerance) {
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f))
      CHECK((mesh.texcoord2D(h) - apart(chart_of(mesh, f), mesh.point(h.to()))).norm() < tolerance);
}

/// Runs a module, set up by `setup`, in a decimater of type D with whatever `prepare` adds to it.
template <template <typename> class D, template <typename> class Module, typename Setup, typename Prepare>
SeamMesh run_seams(SeamMesh mesh, Setup setup, Prepare prepare) {
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  D<SeamMesh> decimater(mesh);
  typename Module<SeamMesh>::Handle handle;
  decimater.add(handle);
  setup(decimater.module(handle));
  prepare(decimater);
  REQUIRE(decimater.initialize());
  decimater.decimate();
  decimater.module(handle).finish();
  compact(mesh);
  return mesh;
}

template <template <typename> class D, typename Prepare>
SeamMesh run_mq(const SeamMesh& mesh, std::size_t faces, Prepare prepare) {
  return run_seams<D, ModMemorylessQuadricT>(
      mesh, [&](auto& mq) { mq.set_target_faces(faces); }, prepare);
}

void check_same(const SeamMesh& a, const SeamMesh& b) {
  REQUIRE(a.n_faces() == b.n_faces());
  REQUIRE(a.n_vertices() == b.n_vertices());
  for (const auto v : a.vertices()) CHECK(a.point(v) == b.point(v));
  for (const auto h : a.halfedges()) {
    CHECK(a.to_vertex_handle(h) == b.to_vertex_handle(h));
    if (!h.is_boundary()) CHECK(a.texcoord2D(h) == b.texcoord2D(h));
  }
}

/// Every module of the papers that merges along seams, on edges of about length 1; `look` takes the name and the mesh.
template <template <typename> class D, typename Look>
void with_merging_modules(const SeamMesh& mesh, double unit, Look look) {
  const auto nothing_else = [](auto&) {};
  const auto merging = [](auto set_threshold) {
    return [set_threshold](auto& module) {
      set_threshold(module);
      module.set_seams(Seams::merge);
    };
  };
  look("FAD", run_seams<D, ModFaceAngleT>(mesh, merging([](auto& m) {
                                            m.set_max_normal_angle(60);
                                            m.set_passes(3);
                                          }),
                                          nothing_else));
  look("IVDD", run_seams<D, ModVertexDistanceT>(
                   mesh, merging([&](auto& m) { m.set_max_distance(1.2 * unit); }), nothing_else));
  look("SS",
       run_seams<D, ModSphereScanT>(mesh, merging([&](auto& m) { m.set_radius(1.2 * unit); }), nothing_else));
  look("VTD",
       run_seams<D, ModVtdT>(mesh, merging([&](auto& m) { m.set_max_distance(1.6 * unit); }), nothing_else));
  look("FASS",
       run_seams<D, ModFassT>(mesh, merging([&](auto& m) { m.set_radius(1.5 * unit); }), nothing_else));
}

IndexedMesh hilly() {
  return meshes::grid(
      40, [](std::uint32_t i, std::uint32_t j) { return 2 * std::sin(i * 0.3) * std::cos(j * 0.2); });
}

}  // namespace

TEST_CASE("decimate moves a straight seam, and both sides have the coordinates of their place") {
  const IndexedMesh grid = meshes::flat_grid(13);
  SeamMesh mesh = textured_charts(grid, meshes::halves(grid, 6), apart);
  const DecimateReport report = decimate(mesh, down_to(12));
  CHECK(report.target_reached);
  CHECK(mesh.n_faces() <= 12);
  CHECK(report.seams == 0);
  CHECK(report.charts == 2);
  CHECK(report.charts_gone == 0);
  check_linear(mesh, 1e-4);
}

TEST_CASE("two charts that have changed places keep their coordinates when seams move") {
  const IndexedMesh grid = meshes::flat_grid(13);
  const auto swapped = [](std::uint32_t chart, const SeamMesh::Point& p) {
    return Uv(p[0] + (chart == 0 ? 6 : -6), p[1]);
  };
  SeamMesh mesh = textured_charts(grid, meshes::halves(grid, 6), swapped);
  decimate(mesh, down_to(12));
  CHECK(mesh.n_faces() <= 12);
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      const std::uint32_t chart = mesh.calc_face_centroid(f)[0] > 6 ? 1 : 0;
      CHECK((mesh.texcoord2D(h) - swapped(chart, p)).norm() < 1e-4);
    }
}

TEST_CASE("seams of one, two and three coordinates move together, and nothing is left on the mesh") {
  const IndexedMesh grid = meshes::flat_grid(13);
  SeamMesh mesh = textured_charts(grid, meshes::halves(grid, 6), apart);
  mesh.request_halfedge_texcoords1D();
  mesh.request_halfedge_texcoords3D();
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to()), center = mesh.calc_face_centroid(f);
      mesh.set_texcoord1D(h, p[1] + (center[1] > 4 ? 50 : 0));
      mesh.set_texcoord3D(h, {p[0], p[1], 7});
    }
  const auto n_properties = [](const SeamMesh& m) {
    return std::count_if(m.hprops_begin(), m.hprops_end(), [](auto* p) { return p != nullptr; }) +
           std::count_if(m.vprops_begin(), m.vprops_end(), [](auto* p) { return p != nullptr; });
  };
  const auto before = n_properties(mesh);
  const DecimateReport report = decimate(mesh, down_to(20));
  CHECK(n_properties(mesh) == before);
  CHECK(mesh.n_faces() <= 20);
  CHECK(report.charts == 4);
  check_linear(mesh, 1e-3);
  for (const auto f : mesh.faces())
    for (const auto h : mesh.fh_range(f)) {
      const auto p = mesh.point(h.to());
      const double y = mesh.texcoord1D(h);
      CHECK(std::min(std::abs(y - p[1]), std::abs(y - 50 - p[1])) < 1e-3);
      CHECK((mesh.texcoord3D(h) - SeamMesh::TexCoord3D(p[0], p[1], 7)).norm() < 1e-3);
    }
}

TEST_CASE("a chart that vanishes leaves no coordinates behind, and keep_charts keeps it") {
  const IndexedMesh in = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  std::vector<std::uint32_t> chart(in.triangles.size(), 0);
  chart[0] = 1;
  SeamMesh mesh = textured_charts(in, chart, apart), kept = mesh;
  const DecimateReport report = decimate(mesh, down_to(6));
  CHECK(report.charts == 2);
  CHECK(report.charts_gone == 1);
  CHECK(mesh.n_faces() <= 6);
  for (const auto f : mesh.faces()) CHECK(chart_of(mesh, f) == 0);
  for (const auto v : mesh.vertices()) CHECK_FALSE(detail::is_on_seam(mesh, v));
  check_linear(mesh, 0.3);  // the survivor lies where the chart was; its coordinates are at the chart's rim

  DecimateOptions options = down_to(6);
  options.keep_charts = true;
  const DecimateReport all = decimate(kept, options);
  CHECK(all.charts_gone == 0);
  std::size_t n = 0;
  for (const auto f : kept.faces()) n += chart_of(kept, f) == 1;
  CHECK(n >= 1);
}

TEST_CASE("decimate moves the seams of arrays and of OpenMesh meshes alike") {
  const IndexedMesh in = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const auto chart = meshes::grown_charts(in, 30, 4);
  SeamMesh mesh = textured_charts(in, chart, apart);
  SurfaceExtras extras;
  extras.wedges = detail::corner_wedges(mesh, detail::corner_numbers(mesh));
  REQUIRE(extras.wedges.size() == in.triangles.size());
  const DecimateReport a = decimate(mesh, down_to(400));
  const DecimatedT<double> b =
      decimate(to_indexed(fixture::to_openmesh<SeamMesh>(in)), down_to(400), MemorylessQuadric(), extras);
  CHECK(meshes::canonical(to_indexed(mesh)) == meshes::canonical(b.mesh));
  CHECK(a.charts == b.charts);
  CHECK(a.charts_gone == b.charts_gone);
  CHECK(a.charts_gone > 0);
  CHECK(a.seams == 0);
  CHECK(b.seams == 0);
  std::size_t i = 0;
  for (const auto f : mesh.faces()) CHECK(chart_of(mesh, f) == chart[b.face_origin[i++]]);
}

TEST_CASE("every decimater moves seams in the same way, bit for bit") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  const IndexedMesh open = meshes::riddled(meshes::shaken(meshes::flat_grid(30), 0.1, 2), 60, 5);
  for (const auto& [in, size] :
       {std::pair<IndexedMesh, std::size_t>{torus, 4}, {torus, 40}, {open, 40}, {hilly(), 4}}) {
    const SeamMesh mesh = textured_charts(in, meshes::grown_charts(in, size, 4), apart);
    const std::size_t target = in.triangles.size() / 8;
    const auto nothing_else = [](auto&) {};
    const SeamMesh by_sweep = run_mq<SweepDecimaterT>(mesh, target, nothing_else);
    CHECK(by_sweep.n_faces() <= target + 4);
    check_same(run_mq<LazyDecimaterT>(mesh, target, nothing_else), by_sweep);
    check_same(run_mq<OpenMesh::Decimater::DecimaterT>(mesh, target, nothing_else), by_sweep);
  }
}

TEST_CASE("where faces of two charts meet there is a seam, and where those of one meet there is none") {
  const IndexedMesh torus = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  for (const std::size_t size : {6u, 60u}) {
    SeamMesh mesh = textured_charts(torus, meshes::grown_charts(torus, size, 4), apart);
    const DecimateReport report = decimate(mesh, down_to(torus.triangles.size() / 6));
    CHECK(report.target_reached);
    CHECK(report.charts_gone > 0);
    CHECK(measure::facts(to_indexed(mesh)).closed());
    std::size_t inner = 0, torn = 0;
    for (const auto e : mesh.edges()) {
      const bool same = chart_of(mesh, e.h0().face()) == chart_of(mesh, e.h1().face());
      inner += same;
      torn += same && detail::is_seam(mesh, e.h0());
      if (!same) CHECK(detail::is_seam(mesh, e.h0()));
    }
    CHECK(torn <= inner / 20);  // a slit stays where a chart had closed around another
  }
}

TEST_CASE("along a seam both sides have the coordinates of one place, on any mesh") {
  const IndexedMesh in = hilly();
  for (const std::size_t size : {60u, 400u}) {
    SeamMesh mesh = textured_charts(in, meshes::grown_charts(in, size, 2), apart);
    DecimateOptions options = down_to(700);
    options.keep_charts = true;  // where a chart has vanished between two others, these have met nowhere
    const DecimateReport report = decimate(mesh, options);
    CHECK(report.target_reached);
    CHECK(report.charts_gone == 0);
    std::size_t compared = 0;
    for (const auto v : mesh.vertices()) {
      std::map<std::uint32_t, std::vector<Uv>> places;  // by chart
      for (const auto h : mesh.vih_range(v))
        if (!h.is_boundary()) {
          const std::uint32_t chart = chart_of(mesh, h.face());
          places[chart].push_back(mesh.texcoord2D(h) - Uv(100.0 * chart, 0));
        }
      for (const auto& [chart, of_chart] : places)
        for (const Uv& uv : of_chart) CHECK(uv == of_chart.front());
      if (places.size() != 2) continue;
      CHECK((places.begin()->second[0] - places.rbegin()->second[0]).norm() < 1e-9);
      ++compared;
    }
    CHECK(compared > 10);
  }
}

TEST_CASE("seams stay in their places where another module forbids a part of the plan") {
  const IndexedMesh in = hilly();
  for (const std::size_t size : {8u, 100u}) {
    const SeamMesh mesh = textured_charts(in, meshes::grown_charts(in, size, 2), apart);
    std::map<std::uint32_t, Eigen::AlignedBox2d> range;
    for (const auto f : mesh.faces())
      for (const auto h : mesh.fh_range(f))
        range[chart_of(mesh, f)].extend(Eigen::Vector2d(mesh.texcoord2D(h)[0], mesh.texcoord2D(h)[1]));
    const auto check = [&](const SeamMesh& out) {
      CHECK(out.n_faces() < mesh.n_faces() * 3 / 4);
      CHECK(out.n_faces() > 600);
      for (const auto f : out.faces())
        for (const auto h : out.fh_range(f)) {
          const auto uv = out.texcoord2D(h);
          const auto p = out.point(h.to());
          CHECK(range[chart_of(out, f)].exteriorDistance(Eigen::Vector2d(uv[0], uv[1])) < 1e-4);
          CHECK((uv - apart(chart_of(out, f), p)).norm() < 3);
        }
    };
    const auto forbid_long = [](auto& decimater) {
      OpenMesh::Decimater::ModEdgeLengthT<SeamMesh>::Handle length;
      decimater.add(length);
      decimater.module(length).set_edge_length(1.3f);
    };
    check(run_mq<SweepDecimaterT>(mesh, 600, forbid_long));
    check(run_mq<LazyDecimaterT>(mesh, 600, forbid_long));
    check(run_mq<OpenMesh::Decimater::DecimaterT>(mesh, 600, forbid_long));
  }
}

TEST_CASE(
    "the papers' modules merge along a straight seam when asked, and both sides keep their coordinates") {
  const IndexedMesh grid = meshes::flat_grid(13);
  const SeamMesh mesh = textured_charts(grid, meshes::halves(grid, 6), apart);
  with_merging_modules<SweepDecimaterT>(mesh, 1, [](const char* name, const SeamMesh& out) {
    INFO(name);
    std::size_t on_seam = 0;
    for (const auto v : out.vertices()) {
      if (!detail::is_on_seam(out, v)) continue;
      ++on_seam;
      CHECK(out.point(v)[0] == 6);
    }
    CHECK(on_seam < 13);
    CHECK(on_seam >= 3);
    check_linear(out, 1e-9);
  });
}

TEST_CASE("the papers' modules merge along seams of any shape, and no chart vanishes") {
  const IndexedMesh in = meshes::shaken(meshes::torus(48, 24), 0.004, 1);
  for (const std::size_t size : {3u, 20u, 120u}) {
    const auto chart = meshes::grown_charts(in, size, 4);
    const std::size_t n_charts = 1 + *std::max_element(chart.begin(), chart.end());
    const SeamMesh mesh = textured_charts(in, chart, apart);
    const auto on_seams = [](const SeamMesh& m) {
      std::size_t n = 0;
      for (const auto v : m.vertices()) n += detail::is_on_seam(m, v);
      return n;
    };
    std::vector<SeamMesh> by_sweep;
    with_merging_modules<SweepDecimaterT>(mesh, 0.1, [&](const char* name, const SeamMesh& out) {
      INFO(name << ", charts of " << size);
      by_sweep.push_back(out);
      if (size > 3) CHECK(on_seams(out) < on_seams(mesh));
      CHECK(measure::facts(to_indexed(out)).closed());
      CHECK(measure::facts(to_indexed(out)).euler_characteristic == 0);
      std::set<std::uint32_t> left;
      for (const auto f : out.faces()) left.insert(chart_of(out, f));
      CHECK(left.size() == n_charts);
      for (const auto e : out.edges())
        CHECK(detail::is_seam(out, e.h0()) == (chart_of(out, e.h0().face()) != chart_of(out, e.h1().face())));
    });
    std::size_t i = 0;
    with_merging_modules<LazyDecimaterT>(
        mesh, 0.1, [&](const char*, const SeamMesh& out) { check_same(out, by_sweep[i++]); });
    i = 0;
    with_merging_modules<OpenMesh::Decimater::DecimaterT>(
        mesh, 0.1, [&](const char*, const SeamMesh& out) { check_same(out, by_sweep[i++]); });
  }
}
