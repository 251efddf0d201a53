#include "whittle/plan/merged_wedges.hh"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "catch.hh"
#include "charts.hh"
#include "whittle/plan/execute.hh"
#include "whittle/surface/charts.hh"

using namespace whittle;
using meshes::IndexedMesh;
using meshes::Wedges;

namespace {

struct MergedCase {
  ExecutedT<double> left;
  Wedges wedges;

  /// The wedge of a vertex of the input in a face of the input.
  std::uint32_t at(std::uint32_t face, std::uint32_t v) const {
    const auto f = static_cast<std::size_t>(
        std::find(left.face_origin.begin(), left.face_origin.end(), face) - left.face_origin.begin());
    const auto& t = left.mesh.triangles.at(f);
    const auto k = std::find(t.begin(), t.end(), left.vertex_map[v]) - t.begin();
    return wedges[f].at(static_cast<std::size_t>(k));
  }
};

MergedCase merged(const IndexedMesh& mesh, const Wedges& wedges, const std::vector<Collapse>& collapses) {
  CollapsePlan plan;
  plan.collapses = collapses;
  MergedCase out{execute(plan, mesh), {}};
  out.wedges = merged_wedges({mesh.triangles, out.left.mesh.triangles, out.left.vertex_map,
                              out.left.face_origin, out.left.mesh.points.size()},
                             wedges);
  return out;
}

/// In a hexagon a triangle that is a chart by itself; `around`: of the nine faces around it.
Wedges hexagon_wedges(const IndexedMesh& mesh, std::vector<std::uint32_t> around) {
  around.insert(around.begin(), 99);
  return meshes::wedges_of(mesh, around);
}

}  // namespace

TEST_CASE("charts are what seams enclose") {
  const IndexedMesh grid = meshes::flat_grid(4);
  const auto third =
      meshes::charts_by_centre(grid, [](const meshes::Point& p) { return std::uint32_t(p.x()); });
  const Charts all = charts(grid.triangles, meshes::wedges_of(grid, third));
  CHECK(all.count == 3);
  for (std::size_t f = 0; f < third.size(); ++f) CHECK(all.of_face[f] == third[f]);
  CHECK(count_vanished(all, {0, 1, 4}) == 1);
  CHECK(count_vanished(all, {}) == 3);
  // A slit parts nothing: its two sides hang together around its end.
  Wedges slit;
  for (const auto& t : grid.triangles) slit.push_back(t);
  slit[0][1] = 77;
  CHECK(charts(grid.triangles, slit).count == 1);
}

TEST_CASE("corners of vertices that have not merged differ where they differed") {
  const IndexedMesh grid = meshes::flat_grid(3);
  const Wedges wedges = meshes::wedges_of(grid, meshes::halves(grid, 1));
  const MergedCase same = merged(grid, wedges, {});
  for (std::size_t f = 0; f < 8; ++f)
    for (std::size_t g = 0; g < 8; ++g)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          CHECK((wedges[f][k] == wedges[g][l]) == (same.wedges[f][k] == same.wedges[g][l]));
}

TEST_CASE("vertices that merge along a seam have a wedge on either side") {
  const IndexedMesh grid = meshes::flat_grid(5);
  const Wedges wedges = meshes::wedges_of(grid, meshes::halves(grid, 2));
  const MergedCase out = merged(grid, wedges, {{12, 17, 2, 0, {2, 2.5, 0}}, {11, 17, 2, 0, {2, 2.5, 0}}});
  std::set<std::array<std::uint32_t, 2>> at_merged;  // charts and wedges
  for (std::size_t f = 0; f < out.left.mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (out.left.mesh.triangles[f][k] == out.left.vertex_map[17])
        at_merged.insert({wedges[out.left.face_origin[f]][0] / 25, out.wedges[f][k]});
  REQUIRE(at_merged.size() == 2);
  CHECK((*at_merged.begin())[1] != (*at_merged.rbegin())[1]);
}

TEST_CASE("a chart that vanishes inside another leaves no seam") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  const Wedges island = hexagon_wedges(mesh, std::vector<std::uint32_t>(9, 0));
  const MergedCase out = merged(mesh, island, {{1, 0, 2, 0, {0, -0.3, 0}}});
  // Faces 6 and 9 meet at the edge from 0 to 2 now.
  CHECK(out.at(6, 1) == out.at(9, 0));
  CHECK(out.at(6, 2) == out.at(9, 2));
  CHECK(charts(out.left.mesh.triangles, out.wedges).count == 1);
}

TEST_CASE("a chart that vanishes at the rim of another closes it") {
  const IndexedMesh mesh = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  // The faces between 0 and 1 are another chart, those around 2 one.
  const Wedges rim = hexagon_wedges(mesh, {1, 1, 1, 0, 0, 0, 0, 0, 0});
  const MergedCase out = merged(mesh, rim, {{1, 0, 2, 0, {0, -0.3, 0}}});
  CHECK(out.at(6, 2) == out.at(9, 2));
  CHECK(out.at(6, 1) == out.at(9, 0));
  CHECK(out.at(6, 1) != out.at(2, 0));
}

TEST_CASE("a slit that vertices merge along keeps its sides apart") {
  const IndexedMesh grid = meshes::flat_grid(7);
  Wedges wedges;  // from (3, 1) to (3, 5)
  for (const auto& t : grid.triangles) {
    const double middle = (grid.points[t[0]].x() + grid.points[t[1]].x() + grid.points[t[2]].x()) / 3;
    auto& corners = wedges.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const meshes::Point& p = grid.points[t[k]];
      corners[k] = t[k] + (p.x() == 3 && p.y() > 1 && p.y() < 5 && middle > 3 ? 100 : 0);
    }
  }
  const MergedCase out = merged(grid, wedges, {{24, 17, 2, 0, {3, 2.5, 0}}, {31, 17, 2, 0, {3, 3, 0}}});
  REQUIRE(charts(out.left.mesh.triangles, out.wedges).count == 1);
  std::set<std::uint32_t> at_middle;
  for (std::size_t f = 0; f < out.left.mesh.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (out.left.mesh.triangles[f][k] == out.left.vertex_map[17]) at_middle.insert(out.wedges[f][k]);
  CHECK(at_middle.size() == 2);
}

TEST_CASE("a chart that vanishes between the boundary and another one leaves that whole") {
  IndexedMesh mesh;  // 0 to 3 along the boundary, 4 above
  mesh.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0.5, 1, 0}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}};
  const MergedCase out = merged(mesh, meshes::wedges_of(mesh, {0, 1, 0}), {{2, 1, 1, 0, {0.5, 0, 0}}});
  CHECK(out.at(0, 1) == out.at(2, 2));
  CHECK(out.at(0, 4) == out.at(2, 4));
  CHECK(charts(out.left.mesh.triangles, out.wedges).count == 1);
}
