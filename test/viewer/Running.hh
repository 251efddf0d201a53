/// \file
/// The viewer while it runs, so that a test can act in between.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "Display.hh"

namespace viewing {

/// Started with its construction, ended with its destruction at the latest.
class Running {
 public:
  Running(const Display& display, std::vector<std::string> arguments, const std::string& script)
      : errors_(display.folder / "errors.txt") {
    whittle::files::write_file(display.folder / "script.txt", script);
    arguments.insert(arguments.begin(), WHITTLE_VIEWER_PROGRAM);
    arguments.insert(arguments.end(), {"--script", display.folder / "script.txt"});
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    child_ = fork();
    REQUIRE(child_ >= 0);
    if (child_ > 0) return;
    dup2(open(errors_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
    execv(WHITTLE_VIEWER_PROGRAM, pointers.data());
    _exit(127);
  }
  ~Running() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Until the viewer has written a file; then what is in it.
  nlohmann::json wait_for(const std::string& path) {
    while (!std::filesystem::exists(path)) {
      INFO(programs::contents(errors_));
      const pid_t ended = waitpid(child_, nullptr, WNOHANG);
      if (ended == child_) child_ = -1;
      REQUIRE(child_ > 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return read_json(path);
  }

  /// Its exit code.
  int finish() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    UNSCOPED_INFO(programs::contents(errors_));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  std::string errors_;
  pid_t child_ = -1;
};

}  // namespace viewing
