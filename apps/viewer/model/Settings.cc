#include "model/Settings.hh"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "files/MeshFile.hh"

namespace whittle::viewer {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kRecentFiles = 10;

/// The value of a name if it is there, of the right type; else what stands in `out` already.
template <typename T>
void take(const Json& json, const char* key, T& out) {
  const auto at = json.find(key);
  if (at == json.end()) return;
  try {
    out = at->get<T>();
  } catch (const nlohmann::json::exception&) {
  }
}

void take_view(const Json& json, View& view) {
  std::string layout, shading;
  take(json, "layout", layout);
  take(json, "shading", shading);
  view.layout = layout_named(layout).value_or(view.layout);
  view.shading = shading_named(shading).value_or(view.shading);
  take(json, "heat", view.heat);
  take(json, "plan", view.plan);
  take(json, "feature_angle_degrees", view.feature_angle);
  for (const EdgeSet set : kEdgeSets) take(json, name(set), view.shows(set));
  bool z_up = false;
  take(json, "z_up", z_up);
  view.orbit.set_up(z_up ? Orbit::Up::z : Orbit::Up::y);
}

Json to_json(const View& view) {
  Json json{{"layout", word(view.layout)},
            {"shading", word(view.shading)},
            {"heat", view.heat},
            {"plan", view.plan},
            {"feature_angle_degrees", view.feature_angle},
            {"z_up", view.orbit.up() == Orbit::Up::z}};
  for (const EdgeSet set : kEdgeSets) json[name(set)] = view.shows(set);
  return json;
}

}  // namespace

void Settings::remember(const std::string& path) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(path, error);
  const std::string entry = error ? path : absolute.lexically_normal().string();
  recent.erase(std::remove(recent.begin(), recent.end(), entry), recent.end());
  recent.insert(recent.begin(), entry);
  if (recent.size() > kRecentFiles) recent.resize(kRecentFiles);
}

std::filesystem::path settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config && *config == '/') return std::filesystem::path(config) / "whittle" / "viewer.json";
  const char* home = std::getenv("HOME");
  if (home && *home) return std::filesystem::path(home) / ".config" / "whittle" / "viewer.json";
  return {};
}

Settings load_settings(const std::filesystem::path& path) {
  Settings settings;
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object()) return settings;
  take(json, "recent_files", settings.recent);
  if (settings.recent.size() > kRecentFiles) settings.recent.resize(kRecentFiles);
  take(json, "window_width", settings.width);
  take(json, "window_height", settings.height);
  settings.width = std::clamp(settings.width, 640, 16384);
  settings.height = std::clamp(settings.height, 480, 16384);
  take(json, "text_scale", settings.text_scale);
  settings.text_scale = std::clamp(settings.text_scale, 0.5, 4.0);
  std::string mouse;
  take(json, "mouse", mouse);
  settings.mouse = mouse == "blender" ? MouseStyle::blender : MouseStyle::meshlab;
  take(json, "smooth_edges", settings.smooth_edges);
  take(json, "recipe", settings.recipe);
  if (json.contains("view") && json["view"].is_object()) take_view(json["view"], settings.view);
  return settings;
}

void save_settings(const std::filesystem::path& path, const Settings& settings) {
  std::error_code ignored;  // write_file() has the better message
  std::filesystem::create_directories(path.parent_path(), ignored);
  const Json json{{"recent_files", settings.recent},
                  {"window_width", settings.width},
                  {"window_height", settings.height},
                  {"text_scale", settings.text_scale},
                  {"mouse", settings.mouse == MouseStyle::blender ? "blender" : "meshlab"},
                  {"smooth_edges", settings.smooth_edges},
                  {"recipe", settings.recipe},
                  {"view", to_json(settings.view)}};
  files::write_file(path, json.dump(2) + "\n");
}

}  // namespace whittle::viewer
