#include "report/Progress.hh"

#include <cmath>

namespace whittle::bench {

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

void Progress::say(const std::string& what) {
  if (style_ == ProgressStyle::terminal) out_ << "\r\033[K" << what << std::flush;
  if (style_ == ProgressStyle::lines) out_ << what << std::endl;
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

void Progress::clear() {
  if (style_ == ProgressStyle::terminal) out_ << "\r\033[K" << std::flush;
}

}  // namespace whittle::bench
