/// \file
/// The program: a window with panels around the views, frame after frame.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "model/Script.hh"
#include "panels/Ui.hh"
#include "render/Image.hh"
#include "window/Pointer.hh"
#include "window/Scene.hh"
#include "window/Window.hh"

namespace whittle::viewer {

class App {
 public:
  /// \param view  what is seen first.
  App(Window& window, Session& session, Settings& settings, View view);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Until the window is closed. \throw ScriptError, FileError
  void run(std::vector<Command> script);

  /// Waits until nothing is under way. \throw ScriptError  with what went wrong.
  void settle();

  /// The window's content, or the views alone, at any size. \throw RenderError
  render::Image picture(int width, int height, bool whole_window);

  const View& view() const { return view_; }

 private:
  void step(double longest_wait);
  bool at_rest() const;  ///< nothing is under way or still to be drawn
  void take_input();
  void take_news();
  /// One frame into the bound framebuffer of this size in pixels, panels or not.
  void draw(int width, int height, double pixels_a_unit, bool panels);
  void lay_out(float width, float height, bool panels);
  /// Frames the model if that was asked for, or if the picture has changed its shape under an untouched
  /// camera.
  void keep_framed();
  void serve_requests();
  void set_scale();
  void write_picture(const std::string& path, int width, int height, bool whole_window);

  /// Does commands of the script until one needs more frames.
  void follow_script();
  bool do_command(const Command& command);
  bool do_window_command(const Command& command);

  Window& window_;
  Session& session_;
  Settings& settings_;
  View view_;
  Ui ui_;
  std::optional<Scene> scene_;
  Pointer pointer_;
  std::deque<Command> script_;
  int slide_step_ = 0;
  int frames_due_ = 3;  ///< after an event: some of ImGui's answers show a frame later
  bool more_to_time_ = false;
  Orbit framed_;  ///< the camera as the last framing left it
  double framed_aspect_ = 0;
};

}  // namespace whittle::viewer
