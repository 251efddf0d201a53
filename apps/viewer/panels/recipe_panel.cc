#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "model/RecipeEdit.hh"
#include "model/RecipeText.hh"
#include "model/number.hh"
#include "panels/Ui.hh"
#include "panels/module_card.hh"
#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

using recipe::Role;

void history_buttons(Ui& ui) {
  ImGui::BeginDisabled(!ui.session.history().can_undo());
  if (ImGui::Button("Undo")) ui.session.undo();
  ImGui::EndDisabled();
  tip("Ctrl+Z");
  ImGui::SameLine();
  ImGui::BeginDisabled(!ui.session.history().can_redo());
  if (ImGui::Button("Redo")) ui.session.redo();
  ImGui::EndDisabled();
  tip("Ctrl+Shift+Z or Ctrl+Y");
  ImGui::SameLine();
  if (ImGui::Button("Load")) ui.open_dialog(Dialog::load_recipe, ui.stem() + ".recipe");
  tip("Load a chain of modules in the command line's syntax");
  ImGui::SameLine();
  if (ImGui::Button("Save")) ui.open_dialog(Dialog::save_recipe, ui.stem() + ".recipe");
  tip("Save the chain in the command line's syntax");
}

void add_button(Ui& ui) {
  if (ImGui::Button("+ Add module", {-1, 0})) ImGui::OpenPopup("add");
  if (!ImGui::BeginPopup("add")) return;
  const auto& modules = recipe::catalogue();
  for (const auto& module : modules) {
    if (module.role == Role::priority && &module != &modules.front()) ImGui::Separator();
    if (ImGui::Selectable(module.name.c_str(), false, 0, {ImGui::GetFontSize() * 8, 0})) {
      recipe::Recipe changed = ui.session.recipe();
      changed.modules.push_back(fresh_module(module.name));
      ui.selected = changed.modules.size() - 1;
      ui.session.change(std::move(changed));
    }
    ImGui::SameLine(ImGui::GetFontSize() * 9);
    ImGui::TextDisabled("%s", module.meaning.c_str());
  }
  ImGui::EndPopup();
}

/// The target as one of four kinds, with a number.
void target(Ui& ui) {
  recipe::Recipe changed = ui.session.recipe();
  auto& target = changed.target;
  constexpr const char* kKinds[] = {"none: as the thresholds say", "ratio of the faces", "faces", "vertices"};
  int kind = target.ratio ? 1 : target.faces ? 2 : target.vertices ? 3 : 0;
  const Model* model = ui.session.model();
  const std::size_t faces = model ? model->mesh().triangles.size() : 10000;
  const std::size_t vertices = model ? model->mesh().points.size() : 5000;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##target", &kind, kKinds, 4)) {
    target = {};
    if (kind == 1) target.ratio = 0.5;
    if (kind == 2) target.faces = std::max<std::size_t>(faces / 2, 1);
    if (kind == 3) target.vertices = std::max<std::size_t>(vertices / 2, 1);
    ui.session.change(changed);
    return;
  }
  tip("Without a threshold of its own, a module searches for the least one that gets there");
  if (kind == 0) return;
  ImGui::SetNextItemWidth(-1);
  bool moved = false;
  if (kind == 1) {
    auto ratio = static_cast<float>(*target.ratio);
    moved = ImGui::SliderFloat("##ratio", &ratio, 0.01f, 0.99f, "%.2f of the faces",
                               ImGuiSliderFlags_AlwaysClamp);
    target.ratio = rounded(double(ratio), 3);
  } else {
    auto& count = kind == 2 ? target.faces : target.vertices;
    int value = static_cast<int>(*count);
    moved = ImGui::SliderInt("##count", &value, 1, static_cast<int>(kind == 2 ? faces : vertices),
                             kind == 2 ? "%d faces at most" : "%d vertices at most",
                             ImGuiSliderFlags_AlwaysClamp);
    count = static_cast<std::size_t>(std::max(value, 1));
  }
  if (moved) ui.session.change(changed, "target");
  if (just_released()) ui.session.end_of_drag();
}

/// For mq alone: the slider goes through one plan.
void levels(Ui& ui) {
  if (!has_levels(ui.session.recipe())) return;
  bool on = ui.session.levels();
  if (ImGui::Checkbox("All levels from one plan", &on)) ui.session.set_levels(on);
  tip("Planned once, down to nothing; then every position of the slider is had at once. A plan for "
      "one target is a little truer");
}

/// A slider over a length, in the unit that it has.
bool length_slider(recipe::Length& length, const recipe::Scale& scale) {
  const recipe::Length percent{1, Unit::percent}, own{1, length.unit};
  const double unit = percent.in(scale) / own.in(scale);  // a percent of the diagonal
  const double low = 0.01 * unit, high = 5 * unit;
  const char* format = length.unit == Unit::percent ? "%.3g %% of the diagonal"
                       : length.unit == Unit::edges ? "%.3g mean edges"
                                                    : "%.3g model units";
  if (!ImGui::SliderScalar("##bound", ImGuiDataType_Double, &length.amount, &low, &high, format,
                           ImGuiSliderFlags_Logarithmic))
    return false;
  length.amount = rounded(std::max(length.amount, low), 3);
  return true;
}

void bound(Ui& ui) {
  recipe::Recipe changed = ui.session.recipe();
  bool on = changed.max_distance.has_value();
  if (ImGui::Checkbox("No farther from the original than", &on)) {
    changed.max_distance = on ? std::optional(recipe::Length{0.5, Unit::percent}) : std::nullopt;
    ui.session.change(changed);
    return;
  }
  tip("A bound on the distance both ways; it is measured again and again, which takes a while");
  const Model* model = ui.session.model();
  if (!on || !model || !(model->scale.diagonal > 0) || !(model->scale.mean_edge > 0)) return;
  ImGui::SetNextItemWidth(-1);
  if (length_slider(*changed.max_distance, model->scale)) ui.session.change(changed, "bound");
  if (just_released()) ui.session.end_of_drag();
}

void executor(Ui& ui) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##driver", recipe::to_string(ui.session.recipe().driver).c_str())) return;
  for (const auto& [driver, name, meaning] : recipe::drivers()) {
    if (ImGui::Selectable(name, driver == ui.session.recipe().driver, 0, {ImGui::GetFontSize() * 6, 0})) {
      recipe::Recipe changed = ui.session.recipe();
      changed.driver = driver;
      ui.session.change(std::move(changed));
    }
    ImGui::SameLine(ImGui::GetFontSize() * 7);
    ImGui::TextDisabled("%s", meaning);
  }
  ImGui::EndCombo();
}

void delaunay(Ui& ui) {
  recipe::Recipe changed = ui.session.recipe();
  bool on = changed.delaunay.has_value();
  if (ImGui::Checkbox("Delaunay flips at the end", &on)) {
    changed.delaunay = on ? std::optional(20.0) : std::nullopt;
    ui.session.change(changed);
    return;
  }
  tip("Retriangulates the result; edges sharper than the angle stay");
  if (!on) return;
  auto angle = static_cast<float>(*changed.delaunay);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderFloat("##delaunay", &angle, 0, 180, "up to %.0f degrees", ImGuiSliderFlags_AlwaysClamp)) {
    changed.delaunay = rounded(double(angle), 3);
    ui.session.change(changed, "delaunay");
  }
  if (just_released()) ui.session.end_of_drag();
}

void run_row(Ui& ui) {
  bool live = ui.session.live();
  if (ImGui::Checkbox("Live", &live)) ui.session.set_live(live);
  tip("Run at once after every change; off: look at the plan first, then run");
  ImGui::SameLine();
  ImGui::BeginDisabled(!ui.session.problem().empty() || !ui.session.model());
  if (ImGui::Button("Run")) ui.session.run();
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Copy as command", {-1, 0})) {
    ui.clipboard = ui.session.command(ui.stem() + "-whittled.ply");
    ui.say("The command is in the clipboard");
  }
  tip(ui.session.levels() ? "whittle lods …, whose level 1 is this (Ctrl+Shift+C)"
                          : "whittle simplify … with exactly this recipe (Ctrl+Shift+C)");
}

/// What each module did.
void stages(const Ui& ui) {
  const Outcome* outcome = ui.session.outcome();
  if (!outcome) return;
  heading("What they did");
  for (const recipe::StageResult& stage : outcome->result.stages) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(stage.module.c_str());
    ImGui::PopTextWrapPos();
    char milliseconds[64];
    std::snprintf(milliseconds, sizeof milliseconds, "%.1f + %.1f ms", 1e3 * stage.plan_seconds,
                  1e3 * stage.execute_seconds);
    quiet_text(grouped(stage.faces_before) + " → " + grouped(stage.faces_after) + " triangles, " +
               recipe::to_string(stage.driver) + ", " + milliseconds);
    tip("planning + execution; refused by the flip guard: " + grouped(stage.record.refused_by_flip_guard) +
        ", by the link condition: " + grouped(stage.record.refused_by_link) +
        ", by a constraint: " + grouped(stage.refused_by_decimater));
  }
}

}  // namespace

void draw_recipe_panel(Ui& ui, const Rect& place) {
  begin_panel("recipe", place);
  heading("Recipe");
  history_buttons(ui);
  ImGui::Spacing();
  for (std::size_t i = 0; i < ui.session.recipe().modules.size(); ++i)
    if (draw_module_card(ui, i)) break;  // the chain has changed; the rest waits for the next frame
  add_button(ui);
  heading("Target");
  target(ui);
  levels(ui);
  bound(ui);
  heading("Executor");
  executor(ui);
  delaunay(ui);
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  run_row(ui);
  if (!ui.session.problem().empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour::warning);
    ImGui::TextWrapped("%s", ui.session.problem().c_str());
    ImGui::PopStyleColor();
  }
  stages(ui);
  ImGui::End();
}

}  // namespace whittle::viewer
