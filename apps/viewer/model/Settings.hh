/// \file
/// What the viewer remembers from one run to the next.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/View.hh"

namespace whittle::viewer {

/// Whose habits the mouse follows. The wheel zooms towards the cursor in both, the left button turns, the
/// right one pans. The middle button pans (MeshLab) or turns, and pans with Shift (Blender).
enum class MouseStyle { meshlab, blender };

struct Settings {
  std::vector<std::string> recent;  ///< files, the newest first
  int width = 1440, height = 900;   ///< of the window
  double text_scale = 1;            ///< of the user's own, besides the screen's
  MouseStyle mouse = MouseStyle::meshlab;
  bool smooth_edges = true;  ///< several samples a pixel
  std::string recipe;        ///< the last, as options
  View view;                 ///< without the camera and the split line

  /// Puts a file in front; keeps ten.
  void remember(const std::string& path);
};

/// `$XDG_CONFIG_HOME/whittle/viewer.json`, or under `~/.config`; empty where neither is known.
std::filesystem::path settings_path();

/// Anything missing or malformed is as it is by default: settings must never keep the viewer from starting.
Settings load_settings(const std::filesystem::path& path);

/// \throw FileError
void save_settings(const std::filesystem::path& path, const Settings& settings);

}  // namespace whittle::viewer
