#include <imgui.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>

#include "model/RecipeText.hh"
#include "panels/Ui.hh"
#include "panels/file_field.hh"
#include "panels/help.hh"
#include "panels/widgets.hh"
#include "window/theme.hh"

namespace whittle::viewer {
namespace {

/// Runs an action and shows what it throws.
template <typename Action>
bool try_to(Ui& ui, Action action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    ui.session.errors.push_back(error.what());
    return false;
  }
}

/// The row with the button that does it, and Cancel. True if it is to be done.
bool decide(Ui& ui, const char* label, bool enter) {
  ImGui::Spacing();
  ImGui::BeginDisabled(ui.path.empty());
  const bool done = ImGui::Button(label, {ImGui::GetFontSize() * 7, 0}) || (enter && !ui.path.empty());
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {ImGui::GetFontSize() * 7, 0})) ui.dialog = Dialog::none;
  return done;
}

void open_dialog(Ui& ui) {
  quiet_text("A mesh: OBJ, PLY, OFF, STL, OM, GLB or glTF. You can also drop a file on the window.");
  const bool chosen = file_field(ui, files::readable_extensions());
  if (!ui.settings.recent.empty()) {
    heading("Recent files");
    for (const std::string& file : ui.settings.recent)
      if (ImGui::Selectable(file.c_str(), file == ui.path)) ui.path = file;
  }
  if (decide(ui, "Open", chosen)) {
    ui.session.open(ui.path);
    ui.dialog = Dialog::none;
  }
}

void export_dialog(Ui& ui) {
  quiet_text("The extension says the format");
  const bool enter = file_field(ui, files::writable_extensions());
  for (const std::string& extension : files::writable_extensions()) {
    const std::filesystem::path path = ui.path;
    if (toggle(extension.c_str(), path.extension() == extension))
      ui.path = std::filesystem::path(path).replace_extension(extension).string();
    ImGui::SameLine();
  }
  ImGui::Checkbox("as text (PLY, STL)", &ui.ascii);
  if (decide(ui, "Export", enter) && try_to(ui, [&] { ui.session.begin_export(ui.path, ui.ascii); }))
    ui.dialog = Dialog::none;
}

void picture_dialog(Ui& ui) {
  quiet_text("What the views show, without the panels");
  const bool enter = file_field(ui, {".png"});
  int size[] = {ui.picture_width, ui.picture_height};
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 12);
  if (ImGui::InputInt2("pixels", size)) {
    ui.picture_width = std::clamp(size[0], 16, 16384);
    ui.picture_height = std::clamp(size[1], 16, 16384);
  }
  if (decide(ui, "Write", enter)) {
    ui.picture = PictureRequest{ui.path, ui.picture_width, ui.picture_height};
    ui.dialog = Dialog::none;
  }
}

void recipe_dialog(Ui& ui, bool save) {
  quiet_text("A recipe is a text file with the options of whittle simplify");
  const bool enter = file_field(ui, {".recipe", ".txt"});
  if (!decide(ui, save ? "Save" : "Load", enter)) return;
  const bool done = try_to(ui, [&] {
    if (save)
      save_recipe(ui.path, ui.session.recipe());
    else
      ui.session.change(load_recipe(ui.path));
  });
  if (done) {
    ui.say((save ? "Saved: " : "Loaded: ") + ui.path);
    ui.dialog = Dialog::none;
  }
}

const char* title(Dialog dialog) {
  constexpr const char* kTitles[] = {
      "", "Open a mesh", "Export the result", "Write a picture", "Load a recipe", "Save the recipe", "Help"};
  return kTitles[static_cast<std::size_t>(dialog)];
}

void place_in_the_middle(float width) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y * 0.48f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {0.96f * screen.x, 0.94f * screen.y});
  ImGui::SetNextWindowSize({width, 0});
}

constexpr ImGuiWindowFlags kModal = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;

constexpr const char* kErrorTitle = "Something went wrong";

/// A popup that is open but no longer wanted would go on to block everything else.
void close_popup(const char* name) {
  if (!ImGui::IsPopupOpen(name) || !ImGui::BeginPopupModal(name, nullptr, kModal)) return;
  ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void draw_error(Ui& ui) {
  if (!ImGui::IsPopupOpen(kErrorTitle)) ImGui::OpenPopup(kErrorTitle);
  place_in_the_middle(ImGui::GetFontSize() * 34);
  if (!ImGui::BeginPopupModal(kErrorTitle, nullptr, kModal)) return;
  ImGui::Spacing();
  ImGui::TextWrapped("%s", ui.session.errors.front().c_str());
  ImGui::Spacing();
  if (ImGui::Button("OK", {ImGui::GetFontSize() * 7, 0})) ui.session.errors.pop_front();
  if (ui.session.errors.empty()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void draw_inside(Ui& ui) {
  switch (ui.dialog) {
    case Dialog::open:
      return open_dialog(ui);
    case Dialog::export_result:
      return export_dialog(ui);
    case Dialog::picture:
      return picture_dialog(ui);
    case Dialog::load_recipe:
      return recipe_dialog(ui, false);
    case Dialog::save_recipe:
      return recipe_dialog(ui, true);
    case Dialog::help:
      return help(ui);
    case Dialog::none:
      return;
  }
}

}  // namespace

void draw_dialogs(Ui& ui) {
  const bool error = !ui.session.errors.empty();
  for (const Dialog dialog : {Dialog::open, Dialog::export_result, Dialog::picture, Dialog::load_recipe,
                              Dialog::save_recipe, Dialog::help})
    if (error || dialog != ui.dialog) close_popup(title(dialog));
  if (error) return draw_error(ui);
  close_popup(kErrorTitle);
  if (ui.dialog == Dialog::none) return;

  const char* name = title(ui.dialog);
  if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  place_in_the_middle(ImGui::GetFontSize() * (ui.dialog == Dialog::help ? 44.0f : 40.0f));
  bool open = true;
  if (!ImGui::BeginPopupModal(name, &open, kModal)) return;
  draw_inside(ui);
  if (ui.dialog == Dialog::none || !open) {
    ui.dialog = Dialog::none;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace whittle::viewer
