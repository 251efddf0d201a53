/// \file
/// Work off the window's thread: a thread that only ever cares for the newest task.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace whittle::viewer {

/// Whether the task that was handed this is still wanted.
class Wanted {
 public:
  bool operator()() const { return !*cancelled_; }

 private:
  friend class Worker;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
};

/// Runs one task at a time. A newer task cancels the one that runs and takes the place of one that waits.
/// A task must not throw.
class Worker {
 public:
  using Task = std::function<void(const Wanted&)>;

  Worker();
  ~Worker();  ///< cancels, and waits for the task to notice
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void submit(Task task);
  void cancel();
  bool idle() const;

 private:
  void work();

  mutable std::mutex mutex_;
  std::condition_variable news_;
  Task waiting_;
  std::optional<Wanted> running_;
  bool ending_ = false;
  std::thread thread_;
};

/// Where a worker leaves the newest thing for another thread.
template <typename T>
class Mailbox {
 public:
  void put(T item) {
    const std::lock_guard lock(mutex_);
    item_ = std::move(item);
  }
  std::optional<T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(item_, std::nullopt);
  }
  bool empty() const {
    const std::lock_guard lock(mutex_);
    return !item_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<T> item_;
};

}  // namespace whittle::viewer
