/// \file
/// What the panels share: what they show, what they change, and what they ask the program to do.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "model/Session.hh"
#include "model/Settings.hh"
#include "model/View.hh"
#include "model/panes.hh"

namespace whittle::viewer {

enum class Dialog { none, open, export_result, picture, load_recipe, save_recipe, help };

/// A requested picture of the views.
struct PictureRequest {
  std::string path;
  int width = 0, height = 0;
};

struct Ui {
  Ui(Session& a_session, View& a_view, Settings& some_settings)
      : session(a_session), view(a_view), settings(some_settings) {}

  Session& session;
  View& view;
  Settings& settings;

  float scale = 1;           ///< pixels of the screen for one of an ordinary screen
  Rect area;                 ///< what the panels leave to the views
  std::size_t selected = 0;  ///< the module whose threshold a histogram picks

  Dialog dialog = Dialog::none;  ///< open now
  std::string path;              ///< in the dialog's field
  bool ascii = false;            ///< of an export
  int picture_width = 1920, picture_height = 1080;

  std::string note;  ///< a short word on what was done, for some seconds
  double note_until = 0;
  std::optional<double> original_frame_ms, result_frame_ms;
  double heat_top = 0;                 ///< of the scale as it is drawn
  std::map<std::string, Rect> places;  ///< where sliders, histograms and the progress are, for scripts

  // Requests, done and cleared after the frame.
  bool frame_wanted = false;  ///< see the whole model
  std::optional<PictureRequest> picture;
  std::string clipboard;

  void open_dialog(Dialog which, std::string first_path = {});
  void say(const std::string& text);
  void note_place(const std::string& name);  ///< of the last item
  /// The name of the open file without folder and extension; "model" if none is open.
  std::string stem() const;
};

/// Each draws one part of the window and changes what its user changes.
/// \{
void draw_toolbar(Ui& ui, const Rect& place);
void draw_recipe_panel(Ui& ui, const Rect& place);
void draw_numbers_panel(Ui& ui, const Rect& place);
void draw_histograms(Ui& ui);
void draw_over_views(Ui& ui);  ///< names, the split line, the legend
void draw_progress(Ui& ui);    ///< over the views, too
void draw_dialogs(Ui& ui);
/// \}

/// Turns, pans and zooms by mouse over the views; drags the split line.
void handle_mouse(Ui& ui);
/// Does what a key does.
/// \param key  `F`, `?`, `Escape`, `Ctrl+Z`, …
/// \return false: no such key.
bool press_key(Ui& ui, const std::string& key);

}  // namespace whittle::viewer
