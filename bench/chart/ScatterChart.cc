#include "chart/ScatterChart.hh"

#include <algorithm>

#include "chart/Frame.hh"

namespace whittle::chart {
namespace {

/// The smallest and largest of one coordinate; [1, 10] without points.
std::pair<double, double> extent(const std::vector<ScatterSeries>& series, double ScatterPoint::*coordinate) {
  std::vector<double> values;
  for (const auto& one : series)
    for (const auto& point : one.points) values.push_back(point.*coordinate);
  if (values.empty()) return {1, 10};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

}  // namespace

std::string ScatterChart::svg() const {
  Svg svg(width, height, title);
  std::vector<Key> keys;
  for (std::size_t i = 0; i < series.size(); ++i) keys.push_back({series[i].name, static_cast<int>(i), true});
  const double legend_height = draw_legend(svg, keys, 70, width - 8.0);
  const Area area{70, legend_height + 12, width - 14.0, height - 50.0};

  const auto [x_low, x_high] = extent(series, &ScatterPoint::x);
  const auto [y_low, y_high] = extent(series, &ScatterPoint::y);
  const Axis x(x_low, x_high, area.left, area.right, x_scale);
  const Axis y(y_low, y_high, area.bottom, area.top, y_scale);
  draw_vertical_axis(svg, y, area, y_axis);
  draw_horizontal_axis(svg, x, area, x_axis);

  for (std::size_t i = 0; i < series.size(); ++i) {
    const int number = static_cast<int>(i);
    if (series[i].joined && series[i].points.size() > 1) {
      std::string path;
      for (const auto& point : series[i].points)
        path += coordinate(x.place(point.x)) + "," + coordinate(y.place(point.y)) + " ";
      path.pop_back();
      svg.polyline(path, "curve s" + std::to_string(number % kColours));
    }
    for (const auto& point : series[i].points)
      svg.marker(x.place(point.x), y.place(point.y), number, point.tip);
  }
  return svg.finish();
}

}  // namespace whittle::chart
