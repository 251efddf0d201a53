#include "whittle/planners/ScanOrder.hh"

#include <algorithm>

#include "catch.hh"
#include "measure/Distance.hh"
#include "meshes.hh"
#include "whittle/bulk.hh"
#include "whittle/planners/Circumcenter.hh"
#include "whittle/planners/PlaneQuadric.hh"
#include "whittle/planners/SphereScan.hh"
#include "whittle/planners/VertexDistance.hh"
#include "whittle/planners/Vtd.hh"

using namespace whittle;

namespace {

/// Flat for x below 10, hilly beyond.
IndexedMesh half_hilly() {
  return meshes::grid(20, [](auto i, auto j) { return i < 10 ? 0.0 : 0.3 * ((7 * i + 3 * j) % 5); });
}

/// A roof whose ridge is the line x = 10, z = 10.
IndexedMesh roof() {
  return meshes::grid(21, [](auto i, auto) { return 10.0 - std::abs(double(i) - 10); });
}

template <typename Planner>
double rms(const IndexedMesh& mesh, const Planner& planner) {
  return measure::distance(mesh, bulk(planner, mesh).mesh).two_sided.rms;
}

}  // namespace

TEST_CASE(
    "a scan goes by index, or the cheapest first with ties by index, and leaves out what costs too much") {
  const std::vector<double> costs{3, 1, HUGE_VAL, 1, 2};
  const auto seen = [&](ScanOrder order) {
    std::vector<std::uint32_t> out;
    detail::scan(
        5, order, [&](std::uint32_t i) { return costs[i]; }, [&](std::uint32_t i) { out.push_back(i); });
    return out;
  };
  CHECK(seen(ScanOrder::index) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});
  CHECK(seen(ScanOrder::error) == std::vector<std::uint32_t>{1, 3, 4, 0});
}

TEST_CASE("the quadric of the planes around a cube's corner has its least point there") {
  const IndexedMesh mesh = meshes::cube_corner(0.5);
  const SurfaceT<double> surface(mesh);
  const std::vector<std::uint32_t> around{0, 1, 2, 3};
  detail::HubPlanes hubs;
  const detail::PlaneQuadric quadric(surface, around, {0.1, 0.1, 0.1}, hubs);
  CHECK(quadric.best(10).norm() < 1e-4);
  CHECK(quadric.error({0, 0, 0}) < 1e-12);
  CHECK((quadric.best(0.05) - Eigen::Vector3d(0.1, 0.1, 0.1)).norm() == Approx(0.05));
  // One face of area 1/2 in the plane z = 0: error is twice the area times the squared distance.
  const IndexedMesh triangle = meshes::lone_triangle();
  const SurfaceT<double> flat(triangle);
  CHECK(detail::PlaneQuadric(flat, std::vector<std::uint32_t>{0}, {0, 0, 5}, hubs).error({7, 7, 3}) ==
        Approx(9));
}

TEMPLATE_TEST_CASE("by error, flat places go before hilly ones", "", Circumcenter, VertexDistance,
                   SphereScan) {
  const IndexedMesh mesh = half_hilly();
  const SurfaceT<double> surface(mesh);
  TestType planner;
  if constexpr (std::is_same_v<TestType, VertexDistance>) planner.max_distance = 1.5;
  if constexpr (std::is_same_v<TestType, SphereScan>) planner.radius = 1.2;
  planner.order = ScanOrder::error;
  const CollapsePlan plan = planner.plan(surface);
  const auto is_flat = [&](const Collapse& c) {
    return mesh.points[c.from].x() < 9 && mesh.points[c.to].x() < 9;
  };
  std::size_t flat = 0;
  for (const Collapse& c : plan.collapses) flat += is_flat(c);
  REQUIRE(flat > 20);
  REQUIRE(plan.collapses.size() > flat + 20);
  // Equal to the last digit they are not, but what comes first is flat.
  for (std::size_t i = 0; i < flat / 2; ++i) CHECK(is_flat(plan.collapses[i]));

  planner.order = ScanOrder::index;
  const CollapsePlan by_index = planner.plan(surface);
  CHECK_FALSE(std::all_of(by_index.collapses.begin(),
                          by_index.collapses.begin() + static_cast<std::ptrdiff_t>(flat / 2), is_flat));
}

TEST_CASE("placement by quadrics keeps a ridge where midpoints and centres eat it") {
  const IndexedMesh mesh = roof();
  Circumcenter vt;
  VertexDistance ivdd;
  ivdd.max_distance = 2;
  Vtd vtd;
  vtd.max_distance = 2;
  SphereScan ss;
  ss.radius = 1.5;
  const double before[] = {rms(mesh, vt), rms(mesh, ivdd), rms(mesh, vtd), rms(mesh, ss)};
  vt.placement = ivdd.placement = vtd.placement = TrianglePlacement::quadric;
  ss.placement = SphereScan::Placement::quadric;
  const double after[] = {rms(mesh, vt), rms(mesh, ivdd), rms(mesh, vtd), rms(mesh, ss)};
  for (std::size_t i = 0; i < 4; ++i) {
    INFO(i);
    CHECK(before[i] > 0.01);
    CHECK(after[i] < 0.2 * before[i]);
  }
}

TEST_CASE("the error of a point is area times its squared distance from each plane") {
  // The planes x, y and z = 0 of a cube's corner: two faces of half a square each at the corner itself.
  const IndexedMesh mesh = meshes::cube_corner(0.5);
  const SurfaceT<double> surface(mesh);
  const std::array<std::uint32_t, 1> corner{0};
  double area = 0;  // around the corner, twice, on each side
  for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
    const auto& t = surface.triangle(f);
    if ((t[0] == 0 || t[1] == 0 || t[2] == 0) && std::abs(surface.normal(f).z()) > 0)
      area += surface.normal(f).norm();
  }
  for (const Eigen::Vector3d& center : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, -2, 3)}) {
    detail::HubPlanes hubs;
    const detail::PlaneQuadric quadric(surface, corner, center, hubs);
    CHECK(quadric.error({0, 0, 0}) == Approx(0).margin(1e-12));
    CHECK(quadric.error({0, 0, 2}) == Approx(area * 4));
    CHECK(quadric.error({1, 2, 3}) == Approx(area * 14));
  }
}

TEST_CASE("the planes around a hub are those around any vertex, seen from anywhere") {
  for (const int n : {64, 65, 200}) {  // up to 64 faces are summed each time
    const IndexedMesh mesh = meshes::cone(n, 0.5);
    const SurfaceT<double> surface(mesh);
    const std::array<std::uint32_t, 1> tip{0};
    const Eigen::Vector3d at(0.3, -0.2, 1);
    double expected = 0;
    for (std::uint32_t f = 0; f < surface.n_faces(); ++f) {
      const double offset = surface.normal(f).normalized().dot(at - mesh.points[0]);
      expected += surface.normal(f).norm() * offset * offset;
    }
    detail::HubPlanes hubs;
    for (const Eigen::Vector3d& center : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, -2, 3)})
      CHECK(detail::PlaneQuadric(surface, tip, center, hubs).error(at) == Approx(expected));
  }
}
