#include "terminal/Progress.hh"

#include <sstream>

#include "catch.hh"

using namespace whittle;
using terminal::ProgressStyle;

namespace {

std::string two_steps(ProgressStyle style) {
  std::ostringstream out;
  terminal::Progress progress(out, style);
  progress.expect(2);
  progress.step("one");
  progress.step("two");
  return out.str();
}

}  // namespace

TEST_CASE("a log gets one plain line a step, with the time left from the second on") {
  CHECK(two_steps(ProgressStyle::lines) == "[1/2] one\n[2/2] two: about 0 s left\n");
}

TEST_CASE("a terminal gets one line that is written over and taken away") {
  std::ostringstream out;
  { terminal::Progress(out, ProgressStyle::terminal).say("one"); }
  CHECK(out.str() == "\r\033[Kone\r\033[K");
  CHECK(two_steps(ProgressStyle::terminal).find('\n') == std::string::npos);
}

TEST_CASE("silent progress writes nothing") {
  CHECK(two_steps(ProgressStyle::silent).empty());
}

TEST_CASE("durations are rounded for people") {
  CHECK(terminal::duration_text(0.4) == "0 s");
  CHECK(terminal::duration_text(59.4) == "59 s");
  CHECK(terminal::duration_text(130.2) == "2 min 10 s");
  CHECK(terminal::duration_text(3.5 * 3600) == "3 h 30 min");
}
