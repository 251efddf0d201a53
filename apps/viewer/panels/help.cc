#include "panels/help.hh"

#include <imgui.h>

#include <iterator>
#include <string>

#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

struct Line {
  const char *keys, *meaning;
};

void lines(const char* table, const Line* first, const Line* last) {
  if (!ImGui::BeginTable(table, 2)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 13);
  for (; first != last; ++first) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(first->keys);
    ImGui::TableNextColumn();
    ImGui::TextColored(colour::quiet, "%s", first->meaning);
  }
  ImGui::EndTable();
}

void settings(Ui& ui) {
  int style = ui.settings.mouse == MouseStyle::blender ? 1 : 0;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Middle button");
  ImGui::SameLine(ImGui::GetFontSize() * 8);
  ImGui::RadioButton("pans, as in MeshLab", &style, 0);
  ImGui::SameLine();
  ImGui::RadioButton("turns, as in Blender", &style, 1);
  ui.settings.mouse = style == 1 ? MouseStyle::blender : MouseStyle::meshlab;

  int up = ui.view.orbit.up() == Orbit::Up::z ? 1 : 0;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Upward");
  ImGui::SameLine(ImGui::GetFontSize() * 8);
  bool changed = ImGui::RadioButton("y", &up, 0);
  ImGui::SameLine();
  changed = ImGui::RadioButton("z", &up, 1) || changed;
  if (changed) {
    ui.view.orbit.set_up(up == 1 ? Orbit::Up::z : Orbit::Up::y);
    ui.frame_wanted = true;
  }

  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Text size");
  ImGui::SameLine(ImGui::GetFontSize() * 8);
  for (const double size : {0.85, 1.0, 1.25, 1.5, 2.0}) {
    const std::string label = std::to_string(static_cast<int>(100 * size + 0.5)) + " %";
    if (toggle(label.c_str(), ui.settings.text_scale == size)) ui.settings.text_scale = size;
    ImGui::SameLine();
  }
  ImGui::NewLine();
  ImGui::Checkbox("Smooth edges", &ui.settings.smooth_edges);
}

}  // namespace

void help(Ui& ui) {
  constexpr Line kMouse[] = {{"left drag", "turn the model"},
                             {"right drag, Shift + left drag", "pan"},
                             {"wheel", "zoom towards the cursor"},
                             {"drag the split line", "compare"},
                             {"drag on a histogram", "pick the threshold of the chosen module"},
                             {"Ctrl + click on a slider", "type a number"},
                             {"right click on a parameter", "back to its default"}};
  constexpr Line kKeys[] = {{"F", "frame the model"},
                            {"1, 2, 3, 4", "side by side, split, original, result"},
                            {"S", "next shading"},
                            {"H, P", "heat map, plan"},
                            {"R", "run the recipe"},
                            {"Ctrl+Z, Ctrl+Shift+Z", "undo and redo recipe changes"},
                            {"Ctrl+O, Ctrl+E, Ctrl+P", "open, export, picture"},
                            {"Ctrl+Shift+C", "copy as command"},
                            {"?", "this help"}};
  heading("Mouse");
  lines("mouse", std::begin(kMouse), std::end(kMouse));
  heading("Keys");
  lines("keys", std::begin(kKeys), std::end(kKeys));
  heading("Settings");
  settings(ui);
  ImGui::Spacing();
  if (ImGui::Button("Close", {ImGui::GetFontSize() * 7, 0})) ui.dialog = Dialog::none;
}

}  // namespace whittle::viewer
