#include "model/Worker.hh"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace whittle::viewer {
namespace {

/// Lets the window's thread go first where there are fewer cores than work. The threads that this one starts
/// do so, too.
void give_way() {
#ifdef __linux__
  constexpr int kNice = 5;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
#endif
}

}  // namespace

Worker::Worker() : thread_([this] { work(); }) {}

Worker::~Worker() {
  cancel();
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  news_.notify_one();
  thread_.join();
}

void Worker::submit(Task task) {
  {
    const std::lock_guard lock(mutex_);
    if (running_) *running_->cancelled_ = true;
    waiting_ = std::move(task);
  }
  news_.notify_one();
}

void Worker::cancel() {
  const std::lock_guard lock(mutex_);
  if (running_) *running_->cancelled_ = true;
  waiting_ = nullptr;
}

bool Worker::idle() const {
  const std::lock_guard lock(mutex_);
  return !running_ && !waiting_;
}

void Worker::work() {
  give_way();
  std::unique_lock lock(mutex_);
  while (true) {
    news_.wait(lock, [this] { return ending_ || waiting_; });
    if (ending_) return;
    const Task task = std::exchange(waiting_, nullptr);
    const Wanted wanted = running_.emplace();
    lock.unlock();
    task(wanted);
    lock.lock();
    running_.reset();
  }
}

}  // namespace whittle::viewer
