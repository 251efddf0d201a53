/// \file
/// How close so many triangles can come to a smooth surface.
#pragma once

#include "whittle/surface/IndexedMesh.hh"

namespace whittle::measure {

/// The least RMS distance of a smooth surface from N triangles, in the limit of many, times N; in model units.
///
/// On a triangle of area A a surface is, but for a linear part, a quadratic function whose Hessian has the determinant K,
/// the Gaussian curvature. The best linear function leaves a squared error of at least A^3 K / 180 where K > 0, and
/// A^3 |K| / 225 where K < 0; with k = K or 0.8 |K| the sum over the triangles is least where A is proportional to
/// k^(-1/3), and then RMS >= (integral of k^(1/3))^(3/2) / (N sqrt(180 S)) on a surface of area S (docs/accuracy.md).
///
/// The mesh stands for the smooth surface: its vertices' angle defects are their shares of the integral of K. So the figure
/// means little where the mesh is noisy, or has creases, or hardly more than N triangles itself. Vertices on the
/// boundary count as flat.
/// \pre every index is in range
double smooth_limit(const IndexedMesh& mesh);

}  // namespace whittle::measure
