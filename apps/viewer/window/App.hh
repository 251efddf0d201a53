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
#include "window/FrameTiming.hh"
#include "window/Pointer.hh"
#include "window/Scene.hh"
#include "window/Views.hh"
#include "window/Window.hh"

namespace whittle::viewer {

/// Waits until all draw calls have finished, and returns the time in milliseconds.
double when_drawn();

class App {
 public:
  /// \param view    what is seen first.
  /// \param budget  milliseconds for which drawing the views may hold up a frame of the window.
  App(Window& window, Session& session, Settings& settings, View view, double budget);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Until the window is closed.
  /// \throw ScriptError, FileError
  void run(std::vector<Command> script);

  /// Waits until nothing is under way.
  /// \throw ScriptError  with what went wrong.
  void settle();

  /// The window's content, or the views alone, at any size.
  /// \throw RenderError
  render::Image picture(int width, int height, bool whole_window);

  const View& view() const { return view_; }

 private:
  /// Waits for news, so many seconds at most, and answers them.
  void step(double longest_wait);
  bool has_more_to_draw() const;
  bool at_rest() const;  ///< nothing is under way or still to be drawn
  void take_input();
  void take_news();
  void show_frame();  ///< a frame of the window
  void work_on();     ///< what goes on between the frames
  /// Lets the panels say what they are and how they are changed; with or without those beside the views.
  void lay_out(int width, int height, bool panels);
  void place_panels(float width, float height);
  void draw_views(int window_height);
  bool paint_views();  ///< a little; true if there is another picture to show
  /// Frames the model if that was asked for, or if the picture has changed its shape under an untouched
  /// camera.
  void keep_framed();
  void serve_requests();
  void follow_scale();
  void write_picture(const std::string& path, int width, int height, bool whole_window);
  std::string picture_caption() const;  ///< the command that makes what is seen; empty without a model

  /// A picture that is being drawn between the frames.
  struct Shot {
    PictureRequest request;
    View view;  ///< when it was requested
    Sight sight;
    render::Framebuffer canvas;
    Painting painting;
  };
  void begin_shot(const PictureRequest& request, View view);
  void go_on_with_shot();
  void finish_shot();
  /// Lays out the views alone as `view` shows them, its camera framed if need be; the window's is left alone.
  void lay_out_picture(View& view, int width, int height);

  /// Does commands of the script until one needs more frames.
  void follow_script();
  bool do_command(const Command& command);
  bool slide(const Command& command);
  bool do_window_command(const Command& command);
  void write_frame_times(const std::string& path);
  void write_places(const std::string& path) const;

  static constexpr int kLayouts = 3;  ///< panels find their sizes over some frames

  Window& window_;
  Session& session_;
  Settings& settings_;
  View view_;
  const double budget_;
  Ui ui_;
  std::optional<Scene> scene_;
  std::optional<Views> views_;
  std::optional<Shot> shot_;
  FrameTiming timing_;
  Pointer pointer_;
  std::deque<Command> script_;
  int slide_step_ = 0;
  int frames_due_ = 3;     ///< after an event: some of ImGui's answers show a frame later
  double last_frame_ = 0;  ///< when, in milliseconds
  Orbit framed_;           ///< the camera as the last framing left it
  double framed_aspect_ = 0;
  std::string grab_;                         ///< where the next frame is to be written
  std::vector<double> busy_;                 ///< milliseconds in which the window did not look at events
  std::size_t sketches_ = 0, pictures_ = 0;  ///< when busy_ was begun
};

}  // namespace whittle::viewer
