/// \file
/// Which mesh is seen where.
#pragma once

#include <vector>

#include "model/View.hh"

namespace whittle::viewer {

/// A part of a picture, in pixels from its upper left corner.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Rect& other) const {
    return x == other.x && y == other.y && width == other.width && height == other.height;
  }
  double aspect() const { return height > 0 && width > 0 ? double(width) / height : 1; }
  bool contains(double px, double py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
};

enum class Which { original, result };

/// A mesh drawn into `picture`, of which only `seen` is shown.
struct Pane {
  Which which = Which::original;
  Rect picture, seen;
};

/// The panes that fill an area. Without a result there is only the original.
std::vector<Pane> panes(const View& view, const Rect& area, bool has_result);

/// The column of the split line.
int split_column(const View& view, const Rect& area);

}  // namespace whittle::viewer
