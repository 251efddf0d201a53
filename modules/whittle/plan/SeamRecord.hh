/// \file
/// The seams of an input, to report on what became of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/surface/IndexedMesh.hh"
#include "whittle/surface/Surface.hh"
#include "whittle/surface/charts.hh"
#include "whittle/surface/seams.hh"

namespace whittle::detail {

struct SeamRecord {
  std::vector<bool> on_seam;  ///< for each vertex; empty: there are no seams
  Charts charts;              ///< none where there are no seams

  SeamRecord() = default;
  /// \param mesh    every index is in range
  /// \param wedges  for each triangle, or none
  template <typename Real>
  SeamRecord(const IndexedMeshT<Real>& mesh, const std::vector<std::array<std::uint32_t, 3>>& wedges) {
    if (wedges.empty()) return;
    on_seam = on_seams(mesh.triangles, wedges, mesh.points.size());
    if (std::find(on_seam.begin(), on_seam.end(), true) == on_seam.end())
      on_seam.clear();
    else
      charts = whittle::charts(mesh.triangles, wedges);
  }

  bool empty() const { return on_seam.empty(); }
  bool has(std::size_t v) const { return !empty() && on_seam[v]; }
  /// Adds kSeam to the flags of the vertices on seams. \pre there are flags for every vertex
  void add_flags(std::vector<std::uint8_t>& flags) const {
    for (std::size_t v = 0; v < on_seam.size(); ++v)
      if (on_seam[v]) flags[v] |= kSeam;
  }
};

}  // namespace whittle::detail
