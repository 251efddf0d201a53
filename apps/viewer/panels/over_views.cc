#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "model/number.hh"
#include "panels/Ui.hh"
#include "render/heat_colour.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

ImDrawList* canvas() {
  return ImGui::GetBackgroundDrawList();
}

ImU32 tone(float r, float g, float b, float a) {
  return ImGui::GetColorU32({r, g, b, a});
}

/// Text on a dark pill, legible over any picture.
void label(ImVec2 at, const std::string& text, float scale, float align = 0, ImU32 ink = 0) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  at.x -= align * size.x;
  const float pad = 6 * scale;
  canvas()->AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + size.x + pad, at.y + size.y + pad / 2},
                          tone(0.10f, 0.11f, 0.12f, 0.72f), 4 * scale);
  canvas()->AddText(at, ink ? ink : ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

std::string caption(const Ui& ui, Which which) {
  const Model* model = ui.session.model();
  if (which == Which::original)
    return std::filesystem::path(model->path).filename().string() + "   " +
           grouped(model->mesh().triangles.size()) + " triangles";
  const Outcome* outcome = ui.session.outcome();
  char removed[32];
  std::snprintf(removed, sizeof removed, "%.1f", 100 * outcome->faces_removed());
  return "result   " + grouped(outcome->mesh().triangles.size()) + " triangles, " + removed + " % removed";
}

void captions(const Ui& ui) {
  const float margin = 14 * ui.scale;
  for (const Pane& pane : panes(ui.view, ui.area, ui.session.outcome() != nullptr)) {
    const bool right = ui.view.layout == Layout::split && pane.which == Which::result;
    const auto x = static_cast<float>(right ? ui.area.x + ui.area.width : pane.picture.x);
    const auto left = static_cast<float>(pane.seen.x), top = static_cast<float>(pane.seen.y);
    canvas()->PushClipRect({left, top}, {left + static_cast<float>(pane.seen.width),
                                         top + static_cast<float>(pane.seen.height)});
    label({right ? x - margin : x + margin, static_cast<float>(ui.area.y) + margin}, caption(ui, pane.which),
          ui.scale, right ? 1 : 0);
    canvas()->PopClipRect();
  }
}

void split_line(const Ui& ui) {
  if (ui.view.layout != Layout::split || !ui.session.outcome()) return;
  const auto x = static_cast<float>(split_column(ui.view, ui.area));
  const auto top = static_cast<float>(ui.area.y), bottom = top + static_cast<float>(ui.area.height);
  const float middle = (top + bottom) / 2, s = ui.scale;
  canvas()->AddLine({x, top}, {x, bottom}, tone(1, 1, 1, 0.9f), 2 * s);
  canvas()->AddCircleFilled({x, middle}, 11 * s, tone(1, 1, 1, 0.95f), 24);
  for (const float side : {-1.0f, 1.0f})
    canvas()->AddTriangleFilled({x + side * 7 * s, middle}, {x + side * 3 * s, middle - 4 * s},
                                {x + side * 3 * s, middle + 4 * s}, tone(0.2f, 0.25f, 0.3f, 1));
}

void middle_line(const Ui& ui) {
  if (ui.view.layout != Layout::side_by_side || !ui.session.outcome()) return;
  const auto x = static_cast<float>(ui.area.x + ui.area.width / 2);
  canvas()->AddLine({x, static_cast<float>(ui.area.y)}, {x, static_cast<float>(ui.area.y + ui.area.height)},
                    tone(0.10f, 0.11f, 0.12f, 0.8f), 2 * ui.scale);
}

/// The scale of the heat colours, in model units and in percent of the diagonal.
void legend(const Ui& ui) {
  if (!ui.view.heat || ui.view.shading == Shading::wires || !ui.session.comparison()) return;
  const float s = ui.scale, line = ImGui::GetFontSize();
  const float width = 15 * s, height = std::min(170 * s, 0.5f * static_cast<float>(ui.area.height));
  const float x = static_cast<float>(ui.area.x) + 22 * s;
  const float top = static_cast<float>(ui.area.y + ui.area.height) - height - 2.2f * line;
  const float text_width = ImGui::CalcTextSize("0.000123 +   0.0000 %").x;
  canvas()->AddRectFilled({x - 10 * s, top - 2.4f * line},
                          {x + width + text_width + 18 * s, top + height + line},
                          tone(0.10f, 0.11f, 0.12f, 0.72f), 5 * s);
  canvas()->AddText({x, top - 2.0f * line}, ImGui::GetColorU32(ImGuiCol_Text), "distance");
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3f c = render::heat_colour((i + 0.5) / kSteps);
    const float bottom = top + height * (1 - static_cast<float>(i) / kSteps);
    canvas()->AddRectFilled({x, bottom - height / kSteps - 0.5f}, {x + width, bottom},
                            tone(c[0], c[1], c[2], 1));
  }
  const double diagonal = ui.session.model()->scale.diagonal;
  for (int i = 0; i <= 4; ++i) {
    const double value = ui.heat_top * i / 4;
    char units[32], percent[32];
    std::snprintf(units, sizeof units, "%.3g%s", value, i == 4 ? " +" : "");
    std::snprintf(percent, sizeof percent, "%.3f %%", diagonal > 0 ? 100 * value / diagonal : 0);
    const float y = top + height * (1 - static_cast<float>(i) / 4) - line / 2, left = x + width + 8 * s;
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    canvas()->AddText({left, y}, ink, units);
    canvas()->AddText({left + text_width - ImGui::CalcTextSize(percent).x, y}, ink, percent);
  }
}

void plan_caption(const Ui& ui) {
  const PlanPicture* plan = ui.session.plan();
  if (!ui.view.plan || !plan || ui.view.layout == Layout::result) return;
  const std::string text = "plan   " + grouped(plan->vertices_gone) + " vertices into " +
                           grouped(plan->targets.size()) + " targets, " + grouped(plan->faces_gone) +
                           " triangles vanish";
  label({static_cast<float>(ui.area.x) + 14 * ui.scale,
         static_cast<float>(ui.area.y) + 14 * ui.scale + 1.9f * ImGui::GetFontSize()},
        text, ui.scale, 0, tone(1, 0.72f, 0.36f, 1));
}

/// What is under way, in words; empty if nothing is.
std::string under_way(const Ui& ui) {
  if (ui.session.loading()) return "loading …";
  if (ui.session.decimating()) {
    const recipe::Progress now = ui.session.progress();
    std::string text = "decimating: " + grouped(now.faces) + " triangles";
    if (now.stages > 1)
      text += ", module " + std::to_string(now.stage + 1) + " of " + std::to_string(now.stages);
    return text;
  }
  if (ui.session.planning()) return "planning …";
  if (ui.session.writing()) return "writing …";
  return ui.session.measuring() ? "measuring …" : "";
}

/// The progress bar. Where the progress is unknown, a part of the bar moves from side to side.
void progress_bar(Ui& ui, ImVec2 right_top) {
  const float width = 13 * ImGui::GetFontSize(), height = 5 * ui.scale;
  const ImVec2 corner(right_top.x - width, right_top.y);
  float first = 0, last = 0;
  if (const auto part = ui.session.part_done()) {
    last = static_cast<float>(*part);
  } else {
    const float swing = 0.5f - 0.5f * std::cos(2.2f * static_cast<float>(ImGui::GetTime()));
    first = 0.75f * swing;
    last = first + 0.25f;
  }
  const auto bar = [&](float from, float to, ImU32 ink) {
    canvas()->AddRectFilled({corner.x + from * width, corner.y}, {corner.x + to * width, corner.y + height},
                            ink, height / 2);
  };
  bar(0, 1, tone(0.10f, 0.11f, 0.12f, 0.9f));
  if (last > first) bar(first, last, ImGui::GetColorU32(colour::accent));
  ui.places["progress"] = {static_cast<int>(corner.x), static_cast<int>(corner.y), static_cast<int>(width),
                           static_cast<int>(height)};
}

}  // namespace

/// What is under way, or a note on what was done.
void draw_progress(Ui& ui) {
  const float margin = 14 * ui.scale, line = ImGui::GetFontSize();
  const ImVec2 corner(static_cast<float>(ui.area.x + ui.area.width) - margin,
                      static_cast<float>(ui.area.y + ui.area.height) - margin);
  const std::string busy = under_way(ui);
  if (!busy.empty()) {
    progress_bar(ui, {corner.x + 6 * ui.scale, corner.y - 5 * ui.scale});
    return label({corner.x, corner.y - 14 * ui.scale - line}, busy, ui.scale, 1);
  }
  std::string text;
  if (!ui.note.empty() && ImGui::GetTime() < ui.note_until)
    text = ui.note;
  else if (ui.session.outcome() && !ui.session.outcome_is_current())
    text = "the result is not yet that of the recipe: Run";
  if (!text.empty()) label({corner.x, corner.y - line}, text, ui.scale, 1);
}

void draw_over_views(Ui& ui) {
  if (!ui.session.model()) {
    if (ui.session.loading()) return;
    return label({static_cast<float>(ui.area.x) + 0.5f * static_cast<float>(ui.area.width),
                  static_cast<float>(ui.area.y) + 0.48f * static_cast<float>(ui.area.height)},
                 "Drop a mesh here: OBJ, PLY, OFF, STL, OM, GLB, glTF", ui.scale, 0.5f);
  }
  middle_line(ui);
  split_line(ui);
  captions(ui);
  legend(ui);
  plan_caption(ui);
}

}  // namespace whittle::viewer
