/// \file
/// Bars in groups, with error bars, and a line across a group for a claimed value.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace whittle::chart {

/// From where to where a figure was seen to vary.
struct Spread {
  double low, high;
};

struct Bar {
  std::string label;  ///< under the bar; short
  double value = 0;
  std::optional<Spread> spread;  ///< as an error bar
  int colour = 0;                ///< 0 to kColours - 1
};

struct BarGroup {
  std::string label;
  std::vector<Bar> bars;
  std::optional<double> claim;  ///< a dashed line across the group
};

/// Fill in and draw. All values must be finite.
struct BarChart {
  std::string title;       ///< what it shows, for screen readers
  std::string value_axis;  ///< title of the vertical axis, with the unit
  std::string claim_name;  ///< legend of the dashed lines
  std::vector<BarGroup> groups;
  std::vector<std::string> legend;  ///< names of the colours from 0 on; may be empty
  int decimals = 0;                 ///< of the numbers over the bars
  int width = 760, height = 360;    ///< pixels

  std::string svg() const;
};

}  // namespace whittle::chart
