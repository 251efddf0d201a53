#include "model/panes.hh"

#include <algorithm>
#include <cmath>

namespace whittle::viewer {

int split_column(const View& view, const Rect& area) {
  return area.x + static_cast<int>(std::lround(std::clamp(view.split, 0.0, 1.0) * area.width));
}

std::vector<Pane> panes(const View& view, const Rect& area, bool has_result) {
  if (!has_result || view.layout == Layout::original) return {{Which::original, area, area}};
  if (view.layout == Layout::result) return {{Which::result, area, area}};
  if (view.layout == Layout::split) {
    const int column = split_column(view, area);
    Rect left = area, right = area;
    left.width = column - area.x;
    right.x = column;
    right.width = area.x + area.width - column;
    return {{Which::original, area, left}, {Which::result, area, right}};
  }
  Rect left = area, right = area;
  left.width = area.width / 2;
  right.x = area.x + left.width;
  right.width = area.width - left.width;
  return {{Which::original, left, left}, {Which::result, right, right}};
}

}  // namespace whittle::viewer
