#include "panels/Ui.hh"

#include <imgui.h>

#include <filesystem>
#include <utility>

namespace whittle::viewer {

void Ui::open_dialog(Dialog which, std::string first_path) {
  dialog = which;
  path = std::move(first_path);
}

void Ui::say(const std::string& text) {
  note = text;
  note_until = ImGui::GetTime() + 4;
}

void Ui::note_place(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  places[name] = {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(size.x),
                  static_cast<int>(size.y)};
}

std::string Ui::stem() const {
  if (!session.model()) return "model";
  return std::filesystem::path(session.model()->path).stem().string();
}

}  // namespace whittle::viewer
