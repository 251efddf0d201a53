#include "chart/BarChart.hh"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chart/Frame.hh"

namespace whittle::chart {
namespace {

struct Range {
  double low = 0, high = 0;  // bars stand on zero
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range range_of(const BarChart& chart) {
  Range range;
  for (const BarGroup& group : chart.groups) {
    if (group.claim) range.add(*group.claim);
    for (const Bar& bar : group.bars) {
      range.add(bar.value);
      if (bar.spread) {
        range.add(bar.spread->low);
        range.add(bar.spread->high);
      }
    }
  }
  return range;
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

void draw_bar(Svg& svg, const BarChart& chart, const BarGroup& group, const Bar& bar, const Axis& axis,
              double x, double width) {
  const double zero = axis.place(0), end = axis.place(bar.value), middle = x + width / 2;
  std::string tip = group.label + " " + bar.label + ": " + fixed(bar.value, chart.decimals);
  if (bar.spread)
    tip += " (" + fixed(bar.spread->low, chart.decimals) + " to " + fixed(bar.spread->high, chart.decimals) +
           ")";
  svg.rectangle(x, std::min(zero, end), width, std::abs(zero - end),
                "f" + std::to_string(bar.colour % kColours), tip);
  double top = std::min(zero, end);
  if (bar.spread) {
    const double low = axis.place(bar.spread->low), high = axis.place(bar.spread->high);
    svg.line(middle, low, middle, high, "whisker");
    for (const double y : {low, high}) svg.line(middle - 4, y, middle + 4, y, "whisker");
    top = std::min(top, high);
  }
  svg.text(middle, top - 5, fixed(bar.value, chart.decimals), Anchor::middle, "value");
}

}  // namespace

std::string BarChart::svg() const {
  Svg svg(width, height, title);
  std::vector<Key> keys;
  for (std::size_t i = 0; i < legend.size(); ++i) keys.push_back({legend[i], static_cast<int>(i), false});
  const double legend_height = draw_legend(svg, keys, 62, width - 150.0);
  const bool claims =
      std::any_of(groups.begin(), groups.end(), [](const auto& g) { return g.claim.has_value(); });
  const Area area{62, std::max(legend_height, claims ? 22.0 : 0.0) + 16, width - 8.0, height - 46.0};
  if (claims) {
    svg.line(width - 140, 10, width - 112, 10, "claim");
    svg.text(width - 106, 14, claim_name, Anchor::start, "claimtext");
  }

  const Range range = range_of(*this);
  const Axis axis(range.low, range.high, area.bottom, area.top);
  draw_vertical_axis(svg, axis, area, value_axis);

  // A gap between groups is as wide as a bar, and so is a group without any.
  double units = 0;
  for (const BarGroup& group : groups)
    units += 1.0 + std::max<double>(1, static_cast<double>(group.bars.size()));
  const double unit = (area.right - area.left) / std::max(units, 1.0);
  double x = area.left + unit / 2;
  for (const BarGroup& group : groups) {
    const double group_width = unit * std::max<double>(1, static_cast<double>(group.bars.size()));
    for (std::size_t i = 0; i < group.bars.size(); ++i) {
      const double left = x + unit * static_cast<double>(i);
      draw_bar(svg, *this, group, group.bars[i], axis, left + unit * 0.1, unit * 0.8);
      svg.text(left + unit / 2, area.bottom + 16, group.bars[i].label, Anchor::middle, "small");
    }
    if (group.claim)
      svg.line(x - unit * 0.2, axis.place(*group.claim), x + group_width + unit * 0.2,
               axis.place(*group.claim), "claim");
    svg.text(x + group_width / 2, area.bottom + 36, group.label, Anchor::middle, "strong");
    x += group_width + unit;
  }
  svg.line(area.left, axis.place(0), area.right, axis.place(0), "axis");
  return svg.finish();
}

}  // namespace whittle::chart
