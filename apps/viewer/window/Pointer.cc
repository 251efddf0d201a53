#include "window/Pointer.hh"

#include <imgui.h>

namespace whittle::viewer {
namespace {

constexpr int kSteps = 8;

float across(const Rect& area, double part) {
  return static_cast<float>(area.x + part * area.width);
}
float down(const Rect& area, double part) {
  return static_cast<float>(area.y + part * area.height);
}

}  // namespace

void Pointer::drag(int button, const Rect& area, double x0, double y0, double x1, double y1) {
  states_.push_back({across(area, x0), down(area, y0), 0, -1});
  for (int i = 0; i <= kSteps; ++i) {
    const double t = double(i) / kSteps;
    states_.push_back({across(area, x0 + t * (x1 - x0)), down(area, y0 + t * (y1 - y0)), 0, button});
  }
  states_.push_back({across(area, x1), down(area, y1), 0, -1});
}

void Pointer::scroll(const Rect& area, double x, double y, double clicks) {
  states_.push_back({across(area, x), down(area, y), 0, -1});
  states_.push_back({across(area, x), down(area, y), static_cast<float>(clicks), -1});
  states_.push_back({across(area, x), down(area, y), 0, -1});
}

void Pointer::apply() {
  if (states_.empty()) return;
  ImGuiIO& io = ImGui::GetIO();
  const State state = states_.front();
  states_.pop_front();
  io.MousePos = {state.x, state.y};
  io.MouseWheel = state.wheel;
  for (int button = 0; button < 3; ++button) io.MouseDown[button] = button == state.button;
}

}  // namespace whittle::viewer
