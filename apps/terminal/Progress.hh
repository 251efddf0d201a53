/// \file
/// Progress of a long run on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace whittle::terminal {

/// `terminal` overwrites one line; `lines` is for log files; `silent` writes nothing.
enum class ProgressStyle { silent, lines, terminal };

/// Silent on request; else by whether standard error is a terminal.
ProgressStyle style_on_stderr(bool quiet);

class Progress {
 public:
  Progress(std::ostream& out, ProgressStyle style) : out_(out), style_(style) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Something short is under way.
  void say(const std::string& what);

  /// So many steps of about equal length follow.
  void expect(std::size_t steps);

  /// The next of them begins. From the second on the remaining time is shown.
  void step(const std::string& what);

  /// How much of the work is done and how much time is left; only on a terminal, where it may be called
  /// often.
  void show(std::size_t done, std::size_t all, const std::string& what);

  /// Takes the line on the terminal away.
  void clear();

 private:
  std::ostream& out_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_;
  std::size_t steps_ = 0, begun_ = 0;
};

/// Rounded for people: "2 min 10 s".
std::string duration_text(double seconds);

}  // namespace whittle::terminal
