#include <imgui.h>

#include "panels/Ui.hh"
#include "panels/widgets.hh"
#include "window/Scene.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

void gap(const Ui& ui) {
  ImGui::SameLine(0, 18 * ui.scale);
}

void file_buttons(Ui& ui) {
  if (ImGui::Button("Open")) ui.open_dialog(Dialog::open, ui.session.model() ? ui.session.model()->path : "");
  tip("Open a mesh (Ctrl+O). Or drop a file on the window.");
  ImGui::SameLine();
  ImGui::BeginDisabled(!ui.session.outcome());
  if (ImGui::Button("Export")) ui.open_dialog(Dialog::export_result, ui.stem() + "-whittled.ply");
  ImGui::EndDisabled();
  tip("Write the result as OBJ, PLY, OFF, STL, OM or GLB (Ctrl+E)");
  ImGui::SameLine();
  if (ImGui::Button("Picture")) ui.open_dialog(Dialog::picture, ui.stem() + ".png");
  tip("Write what the views show as PNG, at any size (Ctrl+P)");
}

void layout_buttons(Ui& ui) {
  constexpr struct {
    Layout layout;
    const char *label, *meaning;
  } kButtons[] = {{Layout::side_by_side, "Side by side", "Original left, result right, one camera (1)"},
                  {Layout::split, "Split", "One view with a line to drag (2)"},
                  {Layout::original, "Original", "The original alone (3)"},
                  {Layout::result, "Result", "The result alone (4)"}};
  for (const auto& [layout, label, meaning] : kButtons) {
    if (layout != Layout::side_by_side) ImGui::SameLine(0, 2 * ui.scale);
    if (toggle(label, ui.view.layout == layout)) ui.view.layout = layout;
    tip(meaning);
  }
}

void shading_choice(Ui& ui) {
  constexpr const char* kNames[] = {"Shaded", "Flat", "Wireframe", "Wire over shaded"};
  int shading = static_cast<int>(ui.view.shading);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 11.5f);
  if (ImGui::Combo("##shading", &shading, kNames, 4)) ui.view.shading = static_cast<Shading>(shading);
  tip("How faces are drawn (S for the next); faces seen from behind are red");
}

void edge_choice(Ui& ui) {
  bool any = false;
  for (const EdgeSet set : kEdgeSets) any = any || ui.view.shows(set);
  if (toggle("Edges", any)) ImGui::OpenPopup("edges");
  tip("Draw boundary, non-manifold, feature and locked edges");
  if (!ImGui::BeginPopup("edges")) return;
  constexpr struct {
    EdgeSet set;
    const char *label, *meaning;
  } kRows[] = {{EdgeSet::boundary, "Boundary", "edges of one face"},
               {EdgeSet::nonmanifold, "Non-manifold", "edges of three faces, or of two that disagree"},
               {EdgeSet::feature, "Feature", "edges sharper than the angle below"},
               {EdgeSet::locked, "Locked", "inner edges between vertices that no module moves"}};
  for (const auto& [set, label, meaning] : kRows) {
    const Eigen::Vector4f c = edge_colour(set);
    ImGui::ColorButton(label, {c[0], c[1], c[2], 1},
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoPicker);
    ImGui::SameLine();
    ImGui::Checkbox(label, &ui.view.shows(set));
    ImGui::SameLine(ImGui::GetFontSize() * 11);
    quiet_text(meaning);
  }
  auto angle = static_cast<float>(ui.view.feature_angle);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 12);
  if (ImGui::SliderFloat("feature angle", &angle, 1, 180, "%.0f degrees"))
    ui.view.feature_angle = double(angle);
  ImGui::EndPopup();
}

void overlays(Ui& ui) {
  if (toggle("Heat map", ui.view.heat)) ui.view.heat = !ui.view.heat;
  tip("Colours by the distance between original and result (H)");
  ImGui::SameLine(0, 2 * ui.scale);
  edge_choice(ui);
  ImGui::SameLine(0, 2 * ui.scale);
  if (toggle("Plan", ui.view.plan)) {
    ui.view.plan = !ui.view.plan;
    ui.session.set_plan_wanted(ui.view.plan);
  }
  tip("On the original: which vertices the first module would merge, and where to (P)");
}

void right_end(Ui& ui) {
  if (ImGui::Button("Frame")) ui.frame_wanted = true;
  tip("See the whole model (F)");
  ImGui::SameLine();
  if (ImGui::Button("?")) ui.open_dialog(Dialog::help);
  tip("Mouse, keys and settings (?)");
}

}  // namespace

void draw_toolbar(Ui& ui, const Rect& place) {
  begin_panel("toolbar", place);
  file_buttons(ui);
  gap(ui);
  layout_buttons(ui);
  gap(ui);
  shading_choice(ui);
  gap(ui);
  overlays(ui);
  gap(ui);
  right_end(ui);
  ImGui::End();
}

}  // namespace whittle::viewer
