#include "terminal/Progress.hh"

#include <unistd.h>

#include <cmath>

#include "text/printable.hh"

namespace whittle::terminal {

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

ProgressStyle style_on_stderr(bool quiet) {
  if (quiet) return ProgressStyle::silent;
  return isatty(STDERR_FILENO) == 1 ? ProgressStyle::terminal : ProgressStyle::lines;
}

void Progress::say(const std::string& what) {
  if (style_ == ProgressStyle::terminal) out_ << "\r\033[K" << text::printable(what) << std::flush;
  if (style_ == ProgressStyle::lines) out_ << text::printable(what) << std::endl;
}

void Progress::expect(std::size_t steps) {
  steps_ = steps;
  begun_ = 0;
  start_ = std::chrono::steady_clock::now();
}

void Progress::step(const std::string& what) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const auto done = static_cast<double>(begun_);
  const auto left = static_cast<double>(steps_ - begun_);
  ++begun_;
  std::string text = "[" + std::to_string(begun_) + "/" + std::to_string(steps_) + "] " + what;
  if (done > 0) text += ": about " + duration_text(elapsed.count() / done * left) + " left";
  say(text);
}

void Progress::show(std::size_t done, std::size_t all, const std::string& what) {
  if (style_ != ProgressStyle::terminal) return;
  constexpr std::size_t kWidth = 30;
  const std::size_t filled = all > 0 ? kWidth * done / all : kWidth;
  std::string text = "[" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
                     std::to_string(done) + "/" + std::to_string(all) + " " + what;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (done > 0 && done < all)
    text += ", about " +
            duration_text(elapsed.count() / static_cast<double>(done) * static_cast<double>(all - done)) +
            " left";
  say(text);
}

void Progress::clear() {
  if (style_ == ProgressStyle::terminal) out_ << "\r\033[K" << std::flush;
}

}  // namespace whittle::terminal
