#include "window/Window.hh"

#include <epoxy/gl.h>
// GLFW after epoxy, which brings the OpenGL header.
#include <GLFW/glfw3.h>

#include <cctype>
#include <utility>

namespace whittle::viewer {
namespace {

std::string glfw_reason() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  std::string text = reason ? reason : "no reason given";
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

/// Letters by what the keyboard's layout prints on them; empty for a key without a name here.
std::string key_name(int key, int scancode, int mods) {
  std::string name;
  if (key == GLFW_KEY_ESCAPE) {
    name = "Escape";
  } else if (const char* printed = glfwGetKeyName(key, scancode)) {
    name = printed;
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  if (name.empty() || name == "?") return {};
  if (mods & GLFW_MOD_SHIFT) name.insert(0, "Shift+");
  if (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) name.insert(0, "Ctrl+");
  return name;
}

}  // namespace

Window::Window(int width, int height, const std::string& title, bool visible) : visible_(visible) {
  if (!glfwInit())
    throw WindowError("no display: " + glfw_reason() + "; to draw without one use whittle-bench");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = glfw_reason();
    glfwTerminate();
    throw WindowError("no window with OpenGL 3.3: " + reason);
  }
  glfwMakeContextCurrent(window_);
  if (epoxy_gl_version() < 33) {
    const std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    glfwDestroyWindow(window_);
    glfwTerminate();
    throw WindowError("OpenGL is too old: needs 3.3, the driver has " + version);
  }
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  listen();
}

Window& Window::stirred(GLFWwindow* handle) {
  auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
  self.stirred_ = true;
  return self;
}

void Window::listen() {
  glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
    auto& dropped = stirred(handle).dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* handle, double, double) { stirred(handle); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* handle, int, int) { stirred(handle); });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* handle, float, float) { stirred(handle); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* handle) { stirred(handle); });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* handle) { stirred(handle); });
  // ImGui has callbacks of its own for these, which call ours.
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* handle, int) { stirred(handle); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* handle, int) { stirred(handle); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* handle, int, int, int) { stirred(handle); });
  glfwSetScrollCallback(window_, [](GLFWwindow* handle, double, double) { stirred(handle); });
  glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int scancode, int action, int mods) {
    auto& self = stirred(handle);
    if (action != GLFW_PRESS) return;
    const std::string name = key_name(key, scancode, mods);
    if (!name.empty()) self.keys_.push_back(name);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* handle, unsigned code) {
    auto& self = stirred(handle);
    if (code == '?') self.keys_.push_back("?");
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

int Window::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return height;
}

void Window::resize(int width, int height) {
  glfwSetWindowSize(window_, width, height);
}

double Window::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0.5f ? double(x) : 1;
}

double Window::pixels_a_unit() const {
  int units = 0, unused = 0;
  glfwGetWindowSize(window_, &units, &unused);
  return units > 0 ? double(width()) / units : 1;
}

bool Window::wants_to_close() const {
  return glfwWindowShouldClose(window_) != 0;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::set_clipboard(const std::string& text) {
  glfwSetClipboardString(window_, text.c_str());
}

void Window::swap() {
  glfwSwapBuffers(window_);
}

void Window::wait(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

void Window::wake() {
  glfwPostEmptyEvent();
}

std::vector<std::string> Window::take_dropped() {
  return std::exchange(dropped_, {});
}

std::vector<std::string> Window::take_keys() {
  return std::exchange(keys_, {});
}

bool Window::take_stir() {
  return std::exchange(stirred_, false);
}

}  // namespace whittle::viewer
