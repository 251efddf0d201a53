#include "panels/module_card.hh"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/RecipeEdit.hh"
#include "model/number.hh"
#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

using recipe::Key;
using recipe::KeyKind;
using recipe::Spec;

/// Where a parameter stands in the session.
struct Knob {
  Ui& ui;
  std::size_t place;
  const Spec& spec;
  const Key& key;

  bool given() const { return spec.has(key.name); }
  std::string value() const { return spec.word(key.name).value_or(""); }
  std::string tag() const { return std::to_string(place + 1) + "." + key.name; }
  recipe::Scale scale() const {
    return ui.session.model() ? ui.session.model()->scale : recipe::Scale{0.001, 1};
  }
  void set(const std::string& text, bool dragging) const {
    ui.session.change(with_value(ui.session.recipe(), place, key.name, text), dragging ? tag() : "");
  }
};

bool slider(const char* label, double& value, const recipe::Slider& range, const char* format) {
  const ImGuiSliderFlags flags = range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &range.low, &range.high, format, flags);
}

void length_knob(const Knob& knob) {
  const recipe::Scale scale = knob.scale();
  const Length length = knob.given() ? recipe::parse_length(knob.value()) : Length{0, Unit::edges};
  const recipe::Slider range = slider_of(knob.key, length.unit, scale);
  double amount = knob.given() ? length.amount : range.start;
  const float unit_width = ImGui::GetFontSize() * 6.6f;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - unit_width - ImGui::GetStyle().ItemSpacing.x);
  const bool moved = slider("##amount", amount, range, "%.4g");
  knob.ui.note_place(knob.tag());
  if (moved) knob.set(Length{std::max(0.0, rounded(amount, 3)), length.unit}.text(), true);
  if (just_released()) knob.ui.session.end_of_drag();
  const double model = Length{amount, length.unit}.in(scale);
  const double edge = Length{1, Unit::edges}.in(scale);
  tip(figure(model) + " model units = " + figure(edge > 0 ? model / edge : 0) +
      " mean edges = " + figure(scale.diagonal > 0 ? 100 * model / scale.diagonal : 0) +
      " % of the diagonal. Ctrl+click to type.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(unit_width);
  if (!ImGui::BeginCombo("##unit", name(length.unit), ImGuiComboFlags_NoArrowButton)) return;
  for (const Unit unit : {Unit::edges, Unit::model, Unit::percent})
    if (ImGui::Selectable(name(unit), unit == length.unit))
      knob.set(in_unit({amount, length.unit}, unit, scale).text(), false);
  ImGui::EndCombo();
}

void number_knob(const Knob& knob) {
  const recipe::Slider range = slider_of(knob.key, Unit::model, knob.scale());
  double amount = knob.given() ? knob.spec.number(knob.key.name).value_or(range.start) : range.start;
  const bool whole = knob.key.kind == KeyKind::integer;
  const char* format = whole                                               ? "%.0f"
                       : knob.key.measure == recipe::Measure::degrees      ? "%.4g degrees"
                       : knob.key.measure == recipe::Measure::square_units ? "%.3g square units"
                                                                           : "%.4g";
  ImGui::SetNextItemWidth(-1);
  const bool moved = slider("##amount", amount, range, format);
  knob.ui.note_place(knob.tag());
  if (moved) {
    amount = whole ? std::round(amount) : rounded(amount, 3);
    knob.set(text::shortest(std::clamp(amount, knob.key.min, knob.key.max)), true);
  }
  if (just_released()) knob.ui.session.end_of_drag();
  tip(knob.key.help());
}

void choice_knob(const Knob& knob) {
  const std::string now = knob.given() ? knob.value() : knob.key.choices.front();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##choice", now.c_str())) {
    for (const std::string& choice : knob.key.choices)
      if (ImGui::Selectable(choice.c_str(), choice == now)) knob.set(choice, false);
    ImGui::EndCombo();
  }
  tip(knob.key.help());
}

void draw_knob(const Knob& knob) {
  ImGui::PushID(knob.key.name.c_str());
  ImGui::AlignTextToFramePadding();
  if (knob.given()) {
    ImGui::TextUnformatted(knob.key.name.c_str());
  } else {
    ImGui::TextDisabled("%s", knob.key.name.c_str());
  }
  tip(knob.key.help());
  if (knob.given() && ImGui::BeginPopupContextItem("reset")) {
    if (ImGui::Selectable("Back to the default")) knob.set("", false);
    ImGui::EndPopup();
  }
  ImGui::SameLine(ImGui::GetFontSize() * 5.4f);
  if (!knob.given()) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.6f);
  const bool dimmed = !knob.given();
  if (knob.key.kind == KeyKind::length)
    length_knob(knob);
  else if (knob.key.kind == KeyKind::choice)
    choice_knob(knob);
  else
    number_knob(knob);
  if (dimmed) ImGui::PopStyleVar();
  ImGui::PopID();
}

/// Whether a key is shown at once; the others are under "More parameters".
bool is_main(const Spec& spec, const Key& key) {
  return key.is_main || spec.has(key.name);
}

bool module_combo(Ui& ui, std::size_t place, const Spec& spec, float width) {
  bool changed = false;
  ImGui::SetNextItemWidth(width);
  if (!ImGui::BeginCombo("##module", spec.name.c_str())) return false;
  for (const auto& module : recipe::catalogue()) {
    if (ImGui::Selectable(module.name.c_str(), module.name == spec.name, 0, {ImGui::GetFontSize() * 8, 0})) {
      ui.session.change(with_module(ui.session.recipe(), place, fresh_module(module.name).text()));
      changed = true;
    }
    ImGui::SameLine(ImGui::GetFontSize() * 9);
    ImGui::TextDisabled("%s", module.meaning.c_str());
  }
  ImGui::EndCombo();
  return changed;
}

/// The row with the module's name and the buttons that move and remove it.
bool title_row(Ui& ui, std::size_t place, const Spec& spec) {
  const std::size_t n = ui.session.recipe().modules.size();
  const float button = ImGui::GetFrameHeight(), space = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = ImGui::GetContentRegionAvail().x - 3 * (button + space);
  if (module_combo(ui, place, spec, width)) return true;
  tip(recipe::find_module(spec.name).meaning);
  bool changed = false;
  const auto small_button = [&](const char* id, ImGuiDir arrow, bool enabled) {
    ImGui::SameLine(0, space);
    ImGui::BeginDisabled(!enabled);
    const bool pressed =
        arrow != ImGuiDir_None ? ImGui::ArrowButton(id, arrow) : ImGui::Button(id, {button, 0});
    ImGui::EndDisabled();
    return pressed;
  };
  if (small_button("up", ImGuiDir_Up, place > 0)) {
    ui.session.change(with_moved(ui.session.recipe(), place, place - 1));
    changed = true;
  } else if (small_button("down", ImGuiDir_Down, place + 1 < n)) {
    ui.session.change(with_moved(ui.session.recipe(), place, place + 1));
    changed = true;
  } else if (small_button("x", ImGuiDir_None, n > 1)) {
    ui.session.change(without(ui.session.recipe(), place));
    changed = true;
  }
  return changed;
}

float card_height(const Spec& spec, bool more) {
  std::size_t main = 0, rest = 0;
  for (const Key& key : recipe::find_module(spec.name).keys) ++(is_main(spec, key) ? main : rest);
  const float knobs = static_cast<float>(1 + main + (more ? rest : 0));
  const float more_row = rest > 0 ? ImGui::GetTextLineHeightWithSpacing() : 0;
  const ImGuiStyle& style = ImGui::GetStyle();
  return knobs * ImGui::GetFrameHeightWithSpacing() + more_row + 2 * style.WindowPadding.y -
         style.ItemSpacing.y;
}

}  // namespace

bool draw_module_card(Ui& ui, std::size_t place) {
  const Spec spec = ui.session.recipe().modules[place];  // a copy: knobs change the recipe
  ImGui::PushID(static_cast<int>(place));
  const ImGuiID more_id = ImGui::GetID("more");
  const bool more = ImGui::GetStateStorage()->GetBool(more_id);
  const bool chosen = place == ui.selected && ui.session.recipe().modules.size() > 1;
  if (chosen) ImGui::PushStyleColor(ImGuiCol_ChildBg, {0.20f, 0.225f, 0.255f, 1});
  ImGuiStorage* storage = ImGui::GetStateStorage();
  ImGui::BeginChild("card", {0, card_height(spec, more)}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && ImGui::IsMouseClicked(0))
    ui.selected = place;
  const bool changed = title_row(ui, place, spec);
  if (!changed) {
    bool has_rest = false;
    for (const Key& key : recipe::find_module(spec.name).keys) {
      if (is_main(spec, key))
        draw_knob({ui, place, spec, key});
      else
        has_rest = true;
    }
    if (has_rest && ImGui::Selectable(more ? "Fewer parameters" : "More parameters"))
      storage->SetBool(more_id, !more);
    if (more)
      for (const Key& key : recipe::find_module(spec.name).keys)
        if (!is_main(spec, key)) draw_knob({ui, place, spec, key});
  }
  ImGui::EndChild();
  if (chosen) ImGui::PopStyleColor();
  ImGui::PopID();
  return changed;
}

}  // namespace whittle::viewer
