#include "whittle/surface/SeamGraph.hh"

#include <vector>

#include "catch.hh"
#include "charts.hh"
#include "whittle/surface/Surface.hh"

using namespace whittle;
using meshes::IndexedMesh;

namespace {

/// The seams between the faces of a grid of n by n vertices whose centres are inside a rectangle and all others.
SurfaceExtras island(const IndexedMesh& grid, double x0, double x1, double y0, double y1) {
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(grid, meshes::charts_by_centre(grid, [=](const meshes::Point& p) {
                                      return p.x() > x0 && p.x() < x1 && p.y() > y0 && p.y() < y1 ? 1u : 0u;
                                    }));
  return extras;
}
detail::SeamGraph graph_of(const IndexedMesh& mesh, const SurfaceExtras& extras) {
  return {mesh.triangles, extras.wedges, mesh.points.size()};
}
using List = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a straight seam passes through its vertices, and each may vanish into its neighbours") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const auto graph = graph_of(grid, island(grid, 3, 9, -1, 9));
  CHECK(graph.neighbours(3) == List{10});
  CHECK(graph.neighbours(24) == List{17, 31});
  CHECK(graph.neighbours(23).empty());
  CHECK_FALSE(graph.is_passed(3));
  CHECK(graph.is_passed(24));
  CHECK(graph.may_remove(24, 31));
  CHECK(graph.may_remove(10, 3));
  CHECK_FALSE(graph.may_remove(3, 10));   // the end
  CHECK_FALSE(graph.may_remove(24, 23));  // no seam
  CHECK_FALSE(graph.may_remove(23, 24));
  CHECK(detail::SeamGraph().empty());
  CHECK(graph_of(grid, island(grid, 9, 9, 9, 9)).empty());
}

TEST_CASE("a seam around a chart does not fall below three edges, however many merge at once") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const auto quad = graph_of(grid, island(grid, 2, 3, 2, 3));  // 16, 17, 24, 23
  for (const List& pair : {List{16, 17}, {17, 24}, {24, 23}, {23, 16}}) {
    CHECK(quad.is_passed(pair[0]));
    CHECK_FALSE(quad.may_remove(pair[0], pair[1]));
  }
  const auto two = graph_of(grid, island(grid, 2, 4, 2, 3));  // 16, 17, 18, 25, 24, 23
  CHECK(two.may_remove(17, 18));
  CHECK(two.may_remove(17, 16));
  const IndexedMesh hexagon = meshes::triangle_in_hexagon({-0.5, -0.3, 0}, {0.5, -0.3, 0}, {0, 0.6, 0}, 4);
  std::vector<std::uint32_t> chart(hexagon.triangles.size(), 0);
  chart[0] = 1;
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(hexagon, chart);
  CHECK_FALSE(graph_of(hexagon, extras).may_remove(0, 1));
}

TEST_CASE("a slit keeps its ends and a vertex between them when seams merge") {
  const IndexedMesh grid = meshes::flat_grid(7);
  const auto slit = [&](double top) {  // along x = 3 from y = 1 on
    SurfaceExtras extras;
    for (const auto& t : grid.triangles) {
      const double middle = (grid.points[t[0]].x() + grid.points[t[1]].x() + grid.points[t[2]].x()) / 3;
      auto& corners = extras.wedges.emplace_back(t);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& p = grid.points[t[k]];
        if (p.x() == 3 && p.y() > 1 && p.y() < top && middle > 3) corners[k] += 100;
      }
    }
    return graph_of(grid, extras);
  };
  const auto one = slit(3), two = slit(4);
  CHECK(one.neighbours(17) == List{10, 24});
  CHECK_FALSE(one.may_remove(17, 10));
  CHECK_FALSE(one.may_remove(17, 24));
  CHECK_FALSE(one.may_remove(10, 17));
  CHECK(two.may_remove(17, 24));
  CHECK(two.may_remove(17, 10));
}

TEST_CASE("a surface lets vertices on seams merge along them if it is asked to") {
  const IndexedMesh grid = meshes::flat_grid(7);
  SurfaceExtras extras = island(grid, 3, 9, -1, 9);
  extras.flags.assign(grid.points.size(), 0);
  extras.flags[38] = kLocked;
  const SurfaceT<double> surface(grid, extras);
  const auto merge = [&](std::uint32_t a, std::uint32_t b) {
    return surface.may_merge(a, b, Boundary::merge, Seams::merge);
  };
  CHECK(surface.is_on_seam(24));
  CHECK_FALSE(surface.is_free(24, Boundary::merge));
  CHECK(surface.is_free(24, Boundary::keep, Seams::merge));
  CHECK(merge(24, 31));
  CHECK_FALSE(merge(24, 23));  // inside of a chart
  CHECK_FALSE(merge(31, 38));  // locked
  CHECK_FALSE(merge(10, 3));   // at the boundary
  CHECK(merge(22, 23));
  CHECK(merge(1, 2));
  CHECK_FALSE(surface.may_merge(24, 31, Boundary::merge));
}

TEST_CASE("an edge where three charts meet is one seam edge") {
  IndexedMesh book;
  book.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  book.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const detail::SeamGraph graph(book.triangles, meshes::wedges_of(book, {0, 1, 2}), 5);
  CHECK(graph.neighbours(0) == std::vector<std::uint32_t>{1});
  CHECK(graph.neighbours(1) == std::vector<std::uint32_t>{0});
}

TEST_CASE("a vertex inside a chart merges with none on a seam that merges along it") {
  const IndexedMesh grid = meshes::flat_grid(5);
  SurfaceExtras extras;
  extras.wedges = meshes::wedges_of(grid, meshes::halves(grid, 2));
  const SurfaceT<double> surface(grid, extras);
  CHECK(surface.may_merge(12, 17, Boundary::keep, Seams::merge));
  CHECK(surface.may_merge(11, 16, Boundary::keep, Seams::merge));
  CHECK_FALSE(surface.may_merge(11, 12, Boundary::keep, Seams::merge));
  CHECK_FALSE(surface.may_merge(12, 11, Boundary::keep, Seams::merge));
}
