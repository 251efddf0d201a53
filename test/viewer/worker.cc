#include "model/Worker.hh"

#include "catch.hh"

using namespace whittle::viewer;

namespace {

void wait_for(const Worker& worker) {
  while (!worker.idle()) std::this_thread::yield();
}

}  // namespace

TEST_CASE("a worker runs its task on another thread") {
  Worker worker;
  Mailbox<std::thread::id> answer;
  worker.submit([&](const Wanted&) { answer.put(std::this_thread::get_id()); });
  wait_for(worker);
  CHECK(*answer.take() != std::this_thread::get_id());
  CHECK(answer.empty());
}

TEST_CASE("a newer task cancels the one that runs and replaces the one that waits") {
  Worker worker;
  std::atomic<bool> begun{false}, cancelled{false}, second{false}, third{false};
  worker.submit([&](const Wanted& wanted) {
    begun = true;
    while (wanted()) std::this_thread::yield();
    cancelled = true;
  });
  while (!begun) std::this_thread::yield();
  // The first still runs, so the second waits until the third takes its place: or it has begun and is
  // cancelled.
  worker.submit([&](const Wanted& wanted) { second = wanted(); });
  worker.submit([&](const Wanted& wanted) { third = wanted(); });
  wait_for(worker);
  CHECK(cancelled);
  CHECK(third);
}

TEST_CASE("a worker's destructor cancels the running task and drops the waiting one") {
  std::atomic<int> runs{0};
  {
    Worker worker;
    worker.submit([&](const Wanted& wanted) {
      ++runs;
      while (wanted()) std::this_thread::yield();
    });
    while (runs == 0) std::this_thread::yield();
  }
  CHECK(runs == 1);
}
