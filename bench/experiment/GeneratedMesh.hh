/// \file
/// A stand-in of the bunny's size for where the bunny cannot be had.
#pragma once

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::bench {

/// Names the stand-in in every output.
inline constexpr char kGeneratedLabel[] = "generated closed mesh, not the bunny";

/// The mean edge of Stanford's bunny, the unit in which the paper's thresholds make sense.
inline constexpr double kBunnyMeanEdge = 0.00147;

/// A closed, bumpy ball: each face of an icosahedron cut into `frequency`² triangles, so 10·frequency² + 2
/// vertices and 20·frequency² triangles. The default has 34,812 and 69,620; the bunny has 34,835 and 69,666.
/// The same on every machine up to rounding; all edges together have the mean length `mean_edge`.
/// \pre frequency > 0
IndexedMesh generated_mesh(int frequency = 59, double mean_edge = kBunnyMeanEdge);

/// The mean length over the edges; an edge of two faces counts twice.
double mean_edge_length(const IndexedMesh& mesh);

}  // namespace whittle::bench
