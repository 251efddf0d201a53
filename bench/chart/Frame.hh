/// \file
/// What bar and scatter charts have in common: legend, grid, axis titles.
#pragma once

#include <string>
#include <vector>

#include "chart/Axis.hh"
#include "chart/Svg.hh"

namespace whittle::chart {

/// The area that the data are drawn in.
struct Area {
  double left, top, right, bottom;
};

/// One entry of a legend.
struct Key {
  std::string name;
  int colour = 0;
  bool marker = false;  ///< as in a scatter chart; else a box
};

/// How wide a text will be, roughly; browsers differ.
double text_width(const std::string& text);

/// Draws the legend from the upper left corner, in as many rows as it needs.
/// \return the height that it took.
double draw_legend(Svg& svg, const std::vector<Key>& keys, double left, double right);

/// Horizontal grid lines with numbers at the left, and the title of the vertical axis.
void draw_vertical_axis(Svg& svg, const Axis& axis, const Area& area, const std::string& title);

/// Ticks with numbers below, and the title of the horizontal axis.
void draw_horizontal_axis(Svg& svg, const Axis& axis, const Area& area, const std::string& title);

}  // namespace whittle::chart
