#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/Histogram.hh"
#include "model/RecipeEdit.hh"
#include "model/number.hh"
#include "panels/Ui.hh"
#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

/// As scripts name it.
const char* place_of(Quantity quantity) {
  return quantity == Quantity::edge_length  ? "edge-length"
         : quantity == Quantity::face_angle ? "face-angle"
                                            : "quality";
}

/// Parts of all values, so that meshes of different sizes compare; the root lifts the small bins.
float bar(const Histogram& h, std::size_t bin, double tallest) {
  return tallest > 0 ? static_cast<float>(std::sqrt(static_cast<double>(h.bins[bin]) / tallest)) : 0;
}

double tallest_of(const Histogram& h) {
  return static_cast<double>(*std::max_element(h.bins.begin(), h.bins.end()));
}

void pick(Ui& ui, const recipe::Spec& spec, Quantity quantity, const std::string& key, double value) {
  std::string text = text::shortest(rounded(value, 3));
  if (quantity == Quantity::edge_length) {
    const Unit unit = spec.has(key) ? recipe::parse_length(*spec.word(key)).unit : Unit::model;
    text = in_unit({rounded(value, 4), Unit::model}, unit, ui.session.model()->scale).text();
  }
  ui.session.change(with_value(ui.session.recipe(), ui.selected, key, text), "pick." + key);
}

void bars(ImDrawList* list, const HistogramPair& pair, ImVec2 corner, ImVec2 size) {
  const ImU32 before =
      ImGui::GetColorU32({colour::original.x, colour::original.y, colour::original.z, 0.32f});
  const ImU32 after = ImGui::GetColorU32(colour::accent);
  const std::size_t n_bins = pair.original.bins.size();
  const float step = size.x / static_cast<float>(n_bins);
  const double first = tallest_of(pair.original), second = tallest_of(pair.result);
  for (std::size_t i = 0; i < n_bins; ++i) {
    const float left = corner.x + step * static_cast<float>(i), bottom = corner.y + size.y;
    const float h = size.y * bar(pair.original, i, first), r = size.y * bar(pair.result, i, second);
    list->AddRectFilled({left, bottom - h}, {left + step - 1, bottom}, before);
    if (second > 0)
      list->AddRectFilled({left + step * 0.25f, bottom - r}, {left + step * 0.75f, bottom}, after);
  }
}

void draw(Ui& ui, Quantity quantity) {
  const HistogramPair& pair = ui.session.histograms(quantity);
  const auto& modules = ui.session.recipe().modules;
  ui.selected = std::min(ui.selected, modules.empty() ? 0 : modules.size() - 1);
  const recipe::Spec spec = modules.empty() ? recipe::Spec{} : modules[ui.selected];
  const std::string key = modules.empty() ? "" : picked_key(spec, quantity);
  ImGui::TextColored(colour::quiet, "%s", name(quantity));
  if (quantity == Quantity::edge_length) {
    ImGui::SameLine();
    ImGui::TextDisabled("model units");
  } else if (quantity == Quantity::face_angle) {
    ImGui::SameLine();
    ImGui::TextDisabled("degrees");
  }

  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 4.4f);
  ImGui::InvisibleButton(name(quantity), size);
  ui.note_place(place_of(quantity));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                      3);
  bars(list, pair, corner, size);
  const double high = pair.original.high;
  const auto x_of = [&](double value) { return corner.x + size.x * static_cast<float>(value / high); };
  if (const auto now = picked_value(spec, key, ui.session.model()->scale); now && *now <= high) {
    const float x = x_of(*now);
    list->AddLine({x, corner.y}, {x, corner.y + size.y}, ImGui::GetColorU32(colour::warning), 2 * ui.scale);
  }
  const double under = high * std::clamp(double((ImGui::GetMousePos().x - corner.x) / size.x), 0.0, 1.0);
  // Not while the mouse rests: the axis may change under it with the result.
  const bool moved = ImGui::IsItemActivated() || (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0);
  if (!key.empty() && moved && under > 0) pick(ui, spec, quantity, key, under);
  if (ImGui::IsItemDeactivated()) ui.session.end_of_drag();
  if (ImGui::IsItemHovered())
    tip(figure(under) + (key.empty() ? "" : "\nClick or drag: sets " + key + " of " + spec.name));

  const std::string last = figure(high);
  ImGui::TextDisabled("0");
  ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(last.c_str()).x +
                  ImGui::GetStyle().WindowPadding.x);
  ImGui::TextDisabled("%s", last.c_str());
}

}  // namespace

void draw_histograms(Ui& ui) {
  heading("Distributions");
  quiet_text("grey: original, blue: result; heights by the square root");
  for (const Quantity quantity : kQuantities) draw(ui, quantity);
}

}  // namespace whittle::viewer
