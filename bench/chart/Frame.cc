#include "chart/Frame.hh"

#include <algorithm>

namespace whittle::chart {

double text_width(const std::string& text) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
  return 7.0 * static_cast<double>(letters);
}

double draw_legend(Svg& svg, const std::vector<Key>& keys, double left, double right) {
  constexpr double kRow = 20, kBox = 18, kGap = 16;
  if (keys.empty()) return 0;
  double x = left, y = 14;
  for (const Key& key : keys) {
    const double width = kBox + text_width(key.name);
    if (x > left && x + width > right) {
      x = left;
      y += kRow;
    }
    if (key.marker)
      svg.marker(x + 6, y - 4, key.colour);
    else
      svg.rectangle(x, y - 10, 12, 12, "f" + std::to_string(key.colour % kColours));
    svg.text(x + kBox, y, key.name, Anchor::start);
    x += width + kGap;
  }
  return y + 8;
}

void draw_vertical_axis(Svg& svg, const Axis& axis, const Area& area, const std::string& title) {
  for (const double tick : axis.ticks()) {
    const double y = axis.place(tick);
    svg.line(area.left, y, area.right, y, "grid");
    svg.text(area.left - 7, y + 4, number_text(tick), Anchor::end, "small");
  }
  svg.text_upward(13, (area.top + area.bottom) / 2, title);
}

void draw_horizontal_axis(Svg& svg, const Axis& axis, const Area& area, const std::string& title) {
  svg.line(area.left, area.bottom, area.right, area.bottom, "axis");
  for (const double tick : axis.ticks()) {
    const double x = axis.place(tick);
    svg.line(x, area.bottom, x, area.bottom + 5, "tick");
    svg.text(x, area.bottom + 18, number_text(tick), Anchor::middle, "small");
  }
  svg.text((area.left + area.right) / 2, area.bottom + 38, title, Anchor::middle);
}

}  // namespace whittle::chart
