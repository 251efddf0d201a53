/// \file
/// libFuzzer's entry to the cutting of polygons: two bytes are a corner, on a grid, so that corners meet and sides lie on
/// one another. Whatever the polygon is, its triangles have each side once and hang together.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "files/PolygonCutter.hh"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using whittle::files::PolygonCutter;
  const std::size_t corners = size / 2;
  if (corners < 3) return 0;
  std::vector<whittle::IndexedMesh::Point> polygon;
  for (std::size_t i = 0; i < corners; ++i)
    polygon.emplace_back(data[2 * i] % 16, data[2 * i] / 16,
                         data[2 * i + 1] % 4 == 3 ? data[2 * i + 1] / 64 : 0);
  PolygonCutter cutter;
  const PolygonCutter::Shape shape = cutter.cut(polygon);
  require(cutter.triangles().size() == corners - 2, "not two triangles less than corners");

  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : cutter.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      require(triangle[k] < corners, "a corner that is not there");
      ++edges[{triangle[k], triangle[(k + 1) % 3]}];
    }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = i + 1 == corners ? 0 : i + 1;
    require(--edges[{i, next}] >= 0, "a side is missing");
  }
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    require(count == (other == edges.end() ? 0 : other->second), "triangles that do not hang together");
  }
  // A convex one is a fan, in which nothing is turned over.
  if (shape == PolygonCutter::Shape::convex)
    for (std::size_t i = 0; i < cutter.triangles().size(); ++i)
      require(cutter.triangles()[i][0] == 0 && cutter.triangles()[i][2] == i + 2,
              "a convex polygon that is no fan");
  return 0;
}
