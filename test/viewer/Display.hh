/// \file
/// An X display of the test's own, in memory, and the viewer on it.
#pragma once

#include <fcntl.h>
#include <png.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../programs/Process.hh"
#include "catch.hh"
#include "files/MeshFile.hh"
#include "render/Image.hh"

namespace viewing {

/// Xvfb on a free display, gone at the end. Sets DISPLAY.
class Display {
 public:
  Display() {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    child_ = fork();
    REQUIRE(child_ >= 0);
    if (child_ == 0) {
      const std::string number = std::to_string(ends[1]);
      close(ends[0]);
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, 2);
      execl(XVFB, "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "2400x1600x24", "-nolisten", "tcp",
            static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    std::string name = ":";
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) name += c;
    close(ends[0]);
    REQUIRE(name.size() > 1);
    setenv("DISPLAY", name.c_str(), 1);
    // GLX unloads what it has leaked itself, so that no suppression can name it; the rest of the program is
    // searched for leaks by the tests of its parts.
    const char* const options = ::getenv("ASAN_OPTIONS");
    ::setenv("ASAN_OPTIONS", ((options ? options : "") + std::string(":detect_leaks=0")).c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("XDG_CONFIG_HOME", folder / "config", 1);
  }
  ~Display() {
    kill(child_, SIGTERM);
    waitpid(child_, nullptr, 0);
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Runs the viewer on a model with a script, in a small window.
  programs::Outcome view(const std::string& model, const std::string& script,
                         std::vector<std::string> more = {}) const {
    whittle::files::write_file(folder / "script.txt", script);
    std::vector<std::string> arguments{"--size", "900x600", "--script", folder / "script.txt"};
    if (!model.empty()) arguments.insert(arguments.begin(), model);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return programs::run(WHITTLE_VIEWER_PROGRAM, arguments);
  }

  programs::Folder folder;

 private:
  static void setenv(const char* name, const std::string& value, int) { ::setenv(name, value.c_str(), 1); }

  pid_t child_ = -1;
};

inline whittle::render::Image read_png(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  INFO(path);
  REQUIRE(png_image_begin_read_from_file(&png, path.c_str()));
  png.format = PNG_FORMAT_RGBA;
  whittle::render::Image image{static_cast<int>(png.width), static_cast<int>(png.height),
                               std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  REQUIRE(png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr));
  return image;
}

inline nlohmann::json read_json(const std::string& path) {
  return nlohmann::json::parse(programs::contents(path));
}

}  // namespace viewing
