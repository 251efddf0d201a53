#include "model/Histogram.hh"

#include "catch.hh"
#include "meshes.hh"

using namespace whittle;
using namespace whittle::viewer;

TEST_CASE("every value falls in one bin or beyond the ends") {
  const Histogram h = histogram({-1, 0, 0.1f, 0.5f, 0.99f, 1, 2}, 0, 1, 4);
  CHECK(h.bins == std::vector<std::size_t>{2, 0, 1, 2});
  CHECK(h.below == 1);
  CHECK(h.above == 1);
  CHECK(h.bin_width() == 0.25);
}

TEST_CASE("quantiles are the values below which a part of the values lies") {
  CHECK(quantile({}, 0.5) == 0);
  CHECK(quantile({3, 1, 2}, 0) == 1);
  CHECK(quantile({3, 1, 2}, 0.5) == 2);
  CHECK(quantile({3, 1, 2}, 1) == 3);
}

TEST_CASE("the quality is 1 for equilateral and 0 for degenerate triangles") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 0}};
  const auto values = qualities(mesh);
  CHECK(values[0] == Approx(1));
  CHECK(values[1] == 0);
  CHECK(values[2] == 0);
}

TEST_CASE("a pair of histograms has one axis, which both meshes fit on") {
  const std::vector<float> before{1, 2, 3}, after{4, 5, 6, 30};
  const HistogramPair alone = histograms(Quantity::edge_length, before, nullptr);
  CHECK(alone.original.high == 2);  // of three values the second is the last below 99.9 %
  CHECK(alone.result.bins == std::vector<std::size_t>(alone.original.bins.size(), 0));
  const HistogramPair both = histograms(Quantity::edge_length, before, &after);
  CHECK(both.original.high == 6);
  CHECK(both.result.high == 6);
  CHECK(both.original.above == 0);
  CHECK(both.result.above == 1);
  CHECK(histograms(Quantity::quality, before, nullptr).original.high == 1);
  CHECK(histograms(Quantity::edge_length, {0, 0}, nullptr).original.high == 1);
}

TEST_CASE("a mesh's histograms hold a length an edge, an angle an inner edge and a quality a face") {
  const IndexedMesh mesh = meshes::tetrahedron();
  const auto edges = edge_table(mesh);
  CHECK(values_of(Quantity::edge_length, mesh, edges).size() == 6);
  CHECK(values_of(Quantity::face_angle, mesh, edges).size() == 6);
  CHECK(values_of(Quantity::quality, mesh, edges).size() == 4);
  const IndexedMesh lone = meshes::lone_triangle();
  CHECK(values_of(Quantity::face_angle, lone, edge_table(lone)).empty());
}
