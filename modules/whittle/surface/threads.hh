/// \file
/// A pool of threads for many short rounds of work.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace whittle::detail {

/// So many threads; for 0 as many as the machine runs at once.
inline std::size_t thread_count(std::size_t wanted) {
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// The calling thread and its helpers. Late helpers are not waited for. Waiting threads spin briefly,
/// yielding, before they block, as blocking and waking take longer than many a round.
class Crew {
 public:
  /// \param n_threads  with the calling one; fewer where the system grants no more
  explicit Crew(std::size_t n_threads) {
    for (std::size_t i = 1; i < n_threads; ++i) try {
        helpers_.emplace_back([this] { help(); });
      } catch (const std::system_error&) {
        break;
      }
  }
  ~Crew() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    begun_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  std::size_t size() const { return helpers_.size() + 1; }  ///< threads, with the calling one

  /// Calls `work(i)` for each i below n, on any of the threads.
  /// \throw  what the work of the least i that throws does
  void each(std::size_t n, const std::function<void(std::size_t)>& work);

  /// Calls `work(begin, end)` for ranges of at most `at_once` that together are 0 .. n, on any of the
  /// threads.
  /// \throw  what the work of the least range that throws does
  template <typename Work>
  void each_range(std::size_t n, std::size_t at_once, const Work& work) {
    each((n + at_once - 1) / at_once,
         [&](std::size_t i) { work(i * at_once, std::min(n, (i + 1) * at_once)); });
  }

 private:
  void help();
  void take_items();
  template <typename IsOver>
  static void spin(IsOver is_over) {
    constexpr int kTimes = 200;  // one to two hundred microseconds
    for (int i = 0; i < kTimes && !is_over(); ++i) std::this_thread::yield();
  }

  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  // Changed under the mutex; spinning threads read them without.
  std::atomic<std::size_t> round_{0}, active_{0};  // rounds begun; helpers at work
  std::atomic<bool> ending_{false};
  bool open_ = false;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t n_ = 0;
  std::atomic<std::size_t> next_{0};
  std::vector<std::exception_ptr> errors_;
};

inline void Crew::each(std::size_t n, const std::function<void(std::size_t)>& work) {
  if (helpers_.empty() || n < 2) {
    for (std::size_t i = 0; i < n; ++i) work(i);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    n_ = n;
    next_ = 0;
    errors_.assign(n, nullptr);
    open_ = true;
    ++round_;
  }
  begun_.notify_all();
  take_items();
  spin([&] { return active_ == 0; });
  std::unique_lock lock(mutex_);
  open_ = false;
  ended_.wait(lock, [&] { return active_ == 0; });
  for (const std::exception_ptr& error : errors_)
    if (error) std::rethrow_exception(error);
}

inline void Crew::take_items() {
  for (std::size_t i = next_++; i < n_; i = next_++) try {
      (*work_)(i);
    } catch (...) {
      errors_[i] = std::current_exception();
    }
}

inline void Crew::help() {
  for (std::size_t seen = 0;;) {
    spin([&] { return ending_ || round_ != seen; });
    std::unique_lock lock(mutex_);
    begun_.wait(lock, [&] { return ending_ || (open_ && round_ != seen); });
    if (ending_) return;
    seen = round_;
    ++active_;
    lock.unlock();
    take_items();
    lock.lock();
    if (--active_ == 0) ended_.notify_one();
  }
}

}  // namespace whittle::detail
