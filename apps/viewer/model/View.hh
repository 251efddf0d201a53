/// \file
/// What the user has chosen to see.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "model/EdgeTable.hh"
#include "model/Orbit.hh"

namespace whittle::viewer {

enum class Layout { side_by_side, split, original, result };
enum class Shading { smooth, flat, wires, wires_over };

struct View {
  Layout layout = Layout::side_by_side;
  Shading shading = Shading::wires_over;
  bool heat = false;               ///< colours by distance instead of clay
  std::optional<double> heat_top;  ///< model units at the upper end of the scale; none: it finds one
  std::array<bool, 4> edges{};     ///< by EdgeSet
  double feature_angle = 40;       ///< degrees
  bool plan = false;
  double split = 0.5;  ///< where the line stands, from the left
  Orbit orbit;

  bool& shows(EdgeSet set) { return edges[static_cast<std::size_t>(set)]; }
  bool shows(EdgeSet set) const { return edges[static_cast<std::size_t>(set)]; }

  bool operator==(const View& other) const;
};

/// The words of scripts and settings.
/// \{
const char* word(Layout layout);
const char* word(Shading shading);
std::optional<Layout> layout_named(const std::string& word);
std::optional<Shading> shading_named(const std::string& word);
/// \}

}  // namespace whittle::viewer
