/// \file
/// The mouse as a script moves it.
#pragma once

#include <deque>

#include "model/panes.hh"

namespace whittle::viewer {

/// A queue of what the mouse does, one state a frame. While it is empty the real mouse counts.
class Pointer {
 public:
  /// A drag with a button (0 left, 1 right, 2 middle) from one place of the area to another, 0 to 1.
  void drag(int button, const Rect& area, double x0, double y0, double x1, double y1);
  void scroll(const Rect& area, double x, double y, double clicks);

  bool moving() const { return !states_.empty(); }

  /// Passes ImGui the next state. To be called between the window's news for a frame and the frame.
  void apply();

 private:
  struct State {
    float x, y, wheel;
    int button;  ///< held; -1: none
  };
  std::deque<State> states_;
};

}  // namespace whittle::viewer
