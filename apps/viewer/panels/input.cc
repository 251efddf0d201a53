#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "model/RecipeText.hh"
#include "panels/Ui.hh"

namespace whittle::viewer {
namespace {

enum class Drag { none, turn, pan, split };

Drag drag_of(const Ui& ui, int button) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool pan_key = io.KeyShift || io.KeyCtrl;
  if (button == ImGuiMouseButton_Right) return Drag::pan;
  if (button == ImGuiMouseButton_Left) return pan_key ? Drag::pan : Drag::turn;
  if (ui.settings.mouse == MouseStyle::meshlab) return Drag::pan;
  return pan_key ? Drag::pan : Drag::turn;
}

bool near_split_line(const Ui& ui, ImVec2 mouse) {
  return ui.view.layout == Layout::split && ui.session.outcome() &&
         std::abs(mouse.x - static_cast<float>(split_column(ui.view, ui.area))) < 9 * ui.scale;
}

/// The picture that the mouse is over: half of the area where two stand side by side.
Rect picture_under(const Ui& ui, ImVec2 mouse) {
  for (const Pane& pane : panes(ui.view, ui.area, ui.session.outcome() != nullptr))
    if (pane.seen.contains(double(mouse.x), double(mouse.y))) return pane.picture;
  return ui.area;
}

void next_shading(Ui& ui) {
  ui.view.shading = static_cast<Shading>((static_cast<int>(ui.view.shading) + 1) % 4);
}

void copy_command(Ui& ui) {
  ui.clipboard = ui.session.command(ui.stem() + "-whittled.ply");
  ui.say("The command is in the clipboard");
}

}  // namespace

void handle_mouse(Ui& ui) {
  static Drag drag = Drag::none;  // as ImGui's own state of the mouse
  static Rect picture;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse = io.MousePos;
  const bool over = !io.WantCaptureMouse && ui.area.contains(double(mouse.x), double(mouse.y));
  if (drag == Drag::none && over) {
    if (near_split_line(ui, mouse)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    for (const int button : {0, 1, 2}) {
      if (!ImGui::IsMouseClicked(button)) continue;
      drag = button == 0 && near_split_line(ui, mouse) ? Drag::split : drag_of(ui, button);
      picture = picture_under(ui, mouse);
    }
  }
  if (drag != Drag::none && !io.MouseDown[0] && !io.MouseDown[1] && !io.MouseDown[2]) drag = Drag::none;

  const double dx = double(io.MouseDelta.x), dy = double(io.MouseDelta.y);
  const double w = std::max(picture.width, 1), h = std::max(picture.height, 1);
  if (drag == Drag::turn) ui.view.orbit.turn(-dx / h * 240, dy / h * 240);
  if (drag == Drag::pan) ui.view.orbit.pan(2 * dx / w, -2 * dy / h, picture.aspect());
  if (drag == Drag::split)
    ui.view.split = std::clamp((double(mouse.x) - ui.area.x) / std::max(ui.area.width, 1), 0.0, 1.0);

  if (over && io.MouseWheel != 0) {
    const Rect under = picture_under(ui, mouse);
    ui.view.orbit.zoom(std::pow(0.88, double(io.MouseWheel)),
                       2 * (double(mouse.x) - under.x) / under.width - 1,
                       1 - 2 * (double(mouse.y) - under.y) / under.height, under.aspect());
  }
}

bool press_key(Ui& ui, const std::string& key) {
  const auto plan = [](Ui& u) {
    u.view.plan = !u.view.plan;
    u.session.set_plan_wanted(u.view.plan);
  };
  using Act = void (*)(Ui&);
  static const std::map<std::string, Act> acts = {
      {"F", [](Ui& u) { u.frame_wanted = true; }},
      {"?", [](Ui& u) { u.open_dialog(u.dialog == Dialog::help ? Dialog::none : Dialog::help); }},
      {"Escape",
       [](Ui& u) {
         if (!u.session.errors.empty())
           u.session.errors.pop_front();
         else
           u.dialog = Dialog::none;
       }},
      {"1", [](Ui& u) { u.view.layout = Layout::side_by_side; }},
      {"2", [](Ui& u) { u.view.layout = Layout::split; }},
      {"3", [](Ui& u) { u.view.layout = Layout::original; }},
      {"4", [](Ui& u) { u.view.layout = Layout::result; }},
      {"S", next_shading},
      {"H", [](Ui& u) { u.view.heat = !u.view.heat; }},
      {"P", plan},
      {"R", [](Ui& u) { u.session.run(); }},
      {"Ctrl+Z", [](Ui& u) { u.session.undo(); }},
      {"Ctrl+Y", [](Ui& u) { u.session.redo(); }},
      {"Ctrl+Shift+Z", [](Ui& u) { u.session.redo(); }},
      {"Ctrl+Shift+C", copy_command},
      {"Ctrl+O",
       [](Ui& u) { u.open_dialog(Dialog::open, u.session.model() ? u.session.model()->path : ""); }},
      {"Ctrl+E",
       [](Ui& u) {
         if (u.session.outcome()) u.open_dialog(Dialog::export_result, u.stem() + "-whittled.ply");
       }},
      {"Ctrl+P", [](Ui& u) { u.open_dialog(Dialog::picture, u.stem() + ".png"); }},
  };
  const auto act = acts.find(key);
  if (act == acts.end()) return false;
  act->second(ui);
  return true;
}

}  // namespace whittle::viewer
