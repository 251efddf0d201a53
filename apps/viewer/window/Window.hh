/// \file
/// A window with an OpenGL context, by GLFW.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

struct GLFWwindow;

namespace whittle::viewer {

/// There is no display, or OpenGL is too old; `what()` is one line.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One window with a context of OpenGL 3.3 core, current on the thread that makes it. Only one may exist.
class Window {
 public:
  /// \param width, height  in pixels of an ordinary screen; a screen twice as fine shows twice as many.
  /// \param visible  false for pictures alone.
  /// \throw WindowError
  Window(int width, int height, const std::string& title, bool visible);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }

  /// In pixels. 0 by 0 while it is minimised.
  int width() const;
  int height() const;
  void resize(int width, int height);
  double content_scale() const;  ///< 1 on ordinary screens, 2 where everything is twice as fine
  /// Pixels for one unit of the mouse's coordinates, which some systems count in larger ones.
  double pixels_a_unit() const;
  bool visible() const { return visible_; }

  bool wants_to_close() const;
  void close();
  void set_title(const std::string& title);
  void set_clipboard(const std::string& text);
  void swap();

  /// Handles what has happened; waits for something to happen, so many seconds at most.
  void wait(double seconds);
  static void wake();  ///< ends a wait; from any thread

  /// What came since the last call: files dropped on the window; keys by name, as `F`, `?`, `Ctrl+Shift+Z`;
  /// anything at all that the window should answer.
  /// \{
  std::vector<std::string> take_dropped();
  std::vector<std::string> take_keys();
  bool take_stir();
  /// \}

 private:
  void listen();
  static Window& stirred(GLFWwindow* handle);  ///< the window of an event

  GLFWwindow* window_ = nullptr;
  bool visible_;
  bool stirred_ = false;
  std::vector<std::string> dropped_, keys_;
};

}  // namespace whittle::viewer
