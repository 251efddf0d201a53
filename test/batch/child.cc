#include "batch/Child.hh"

#include <signal.h>

#include <thread>

#include "catch.hh"

using namespace whittle::batch;

namespace {

Ending end_of(const std::string& script, const Limits& limits = {}) {
  Child child({"/bin/sh", "-c", script}, limits);
  for (;;) {
    if (const auto ending = child.poll()) return *ending;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

TEST_CASE("a child reports how it ended and its last line") {
  CHECK(end_of("exit 0").succeeded());
  const Ending bad = end_of("echo first >&2; echo 'the last word' >&2; exit 7");
  CHECK(bad.how == Ending::How::exited);
  CHECK(bad.code == 7);
  CHECK(bad.message == "the last word");
  CHECK_FALSE(bad.succeeded());
  const Ending killed = end_of("kill -9 $$");
  CHECK(killed.how == Ending::How::signalled);
  CHECK(killed.code == SIGKILL);
  CHECK(end_of("true", {}).message.empty());
}

TEST_CASE("a child with much output does not hang, and its last line is shortened") {
  const Ending ending = end_of(
      "i=0; while [ $i -lt 5000 ]; do echo 'line after line after line' >&2; i=$((i+1)); done; "
      "head -c 5000 /dev/zero | tr '\\0' x >&2; exit 3");
  CHECK(ending.code == 3);
  CHECK(ending.message.size() < 600);
  CHECK(ending.message[0] == 'x');
}

TEST_CASE("a child is killed when its time is over, with what it has started") {
  const Ending ending = end_of("sleep 100", {0.1, {}});
  CHECK(ending.how == Ending::How::timed_out);
  CHECK(ending.seconds < 50);
}

TEST_CASE("a child gets no more memory than allowed") {
  // The shell grows a variable until it may not.
  const Ending ending = end_of("x=0123456789; while true; do x=$x$x; done", {60.0, 64});
  CHECK(ending.how != Ending::How::timed_out);
  CHECK_FALSE(ending.succeeded());
}

TEST_CASE("a child whose program is missing ends like any other") {
  Child child({"/no/such/program"}, {});
  for (;;)
    if (const auto ending = child.poll()) {
      CHECK(ending->code == 127);
      break;
    }
}
