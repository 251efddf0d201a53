/// \file
/// Points in the plane, joined to curves where that makes sense.
#pragma once

#include <string>
#include <vector>

#include "chart/Axis.hh"

namespace whittle::chart {

struct ScatterPoint {
  double x = 0, y = 0;
  std::string tip;  ///< shown while the mouse rests on it
};

struct ScatterSeries {
  std::string name;
  std::vector<ScatterPoint> points;  ///< joined in this order
  bool joined = true;
};

/// Fill in and draw. All values must be finite, and positive on a logarithmic axis; a chart without points
/// is empty axes.
struct ScatterChart {
  std::string title;  ///< what it shows, for screen readers
  std::string x_axis, y_axis;
  Scale x_scale = Scale::linear, y_scale = Scale::linear;
  std::vector<ScatterSeries> series;
  int width = 760, height = 460;  ///< pixels

  std::string svg() const;
};

}  // namespace whittle::chart
