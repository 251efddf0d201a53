#include "panels/file_field.hh"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "panels/widgets.hh"

namespace whittle::viewer {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMost = 500;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::vector<std::string> completions(const std::string& path, const std::vector<std::string>& extensions) {
  const fs::path typed(path);
  const fs::path folder = typed.has_parent_path() ? typed.parent_path() : fs::path(".");
  const std::string begin = lower(typed.filename().string());
  std::error_code error;
  std::vector<std::string> folders, files;
  std::vector<std::string> all_folders, all_files;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end && all_files.size() + all_folders.size() < kMost; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.empty() || name[0] == '.') continue;
    const bool begins = lower(name).rfind(begin, 0) == 0;
    const std::string whole = typed.has_parent_path() ? (folder / name).string() : name;
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      all_folders.push_back(whole + "/");
      if (begins) folders.push_back(whole + "/");
    } else if (std::find(extensions.begin(), extensions.end(), lower(entry->path().extension().string())) !=
               extensions.end()) {
      all_files.push_back(whole);
      if (begins) files.push_back(whole);
    }
  }
  // A whole name typed already: show its neighbours.
  if (files.size() + folders.size() <= 1) {
    files = all_files;
    folders = all_folders;
  }
  std::sort(folders.begin(), folders.end());
  std::sort(files.begin(), files.end());
  folders.insert(folders.end(), files.begin(), files.end());
  return folders;
}

bool file_field(Ui& ui, const std::vector<std::string>& extensions) {
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  bool done = input_text("##path", ui.path, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::BeginChild("entries", {0, ImGui::GetFontSize() * 10}, true);
  static std::string listed_for;
  static std::vector<std::string> entries;
  if (listed_for != ui.path || ImGui::IsWindowAppearing()) {
    entries = completions(ui.path, extensions);
    listed_for = ui.path;
  }
  const fs::path folder = fs::path(ui.path).parent_path();
  if (folder.has_relative_path() && ImGui::Selectable("../"))
    ui.path = folder.has_parent_path() ? (folder.parent_path() / "").string() : "";
  for (const std::string& entry : entries) {
    const bool is_folder = entry.back() == '/';
    const std::string shown = is_folder ? fs::path(entry).parent_path().filename().string() + "/"
                                        : fs::path(entry).filename().string();
    if (ImGui::Selectable(shown.c_str(), entry == ui.path, ImGuiSelectableFlags_AllowDoubleClick)) {
      ui.path = entry;
      done = done || (!is_folder && ImGui::IsMouseDoubleClicked(0));
    }
  }
  ImGui::EndChild();
  return done;
}

}  // namespace whittle::viewer
