/// \file
/// What the two papers print, word for word or number for number. Figures whose bars carry no numbers give no
/// values here; `axis` texts say what their axes span.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace whittle::bench::papers {

/// Paper 1, Table 2.
constexpr std::size_t kBunnyVertices = 34032, kBunnyTriangles = 65630, kBunnyIndices = 196890;

/// Paper 1, Table 3: 1,000 frames of the original.
struct Computer {
  std::string name, gpu;
  double milliseconds, frames_per_second;  ///< both as printed
};
const std::vector<Computer>& computers();

/// Paper 1, Section V: by how much the algorithm raises the rendering speed, a mean over its parameters and
/// computers. The paper gives no number for a single set.
struct Algorithm {
  std::string name;
  double improvement_percent;
};
const std::vector<Algorithm>& algorithms();
std::optional<double> claimed_improvement(const std::string& algorithm);

/// Paper 2, Table 1. The counts are three times those of vertices and triangles: of coordinates and of
/// indices.
struct Angle {
  std::string set;       ///< name of Whittle's set
  std::string label;     ///< "> 30°"
  std::size_t vertices;  ///< as printed
  std::size_t triangles;
  double milliseconds;  ///< mean time of rendering, as printed
};
const std::vector<Angle>& angles();  ///< the original first

}  // namespace whittle::bench::papers
