/// \file
/// Progress of several threads, reported to one monitor.
#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>

#include "measure/Monitor.hh"

namespace whittle::measure {

/// Counts work that several threads do, and tells all of them when the monitor has requested a stop.
class Watch {
 public:
  /// \param monitor  may be empty.
  /// \param work  all that will be done, in any unit.
  Watch(const Monitor& monitor, double work) : monitor_(monitor), work_(work) {}

  /// Adds to what is done. May be called from any thread.
  /// \return false: stop.
  bool done(double work) {
    if (!monitor_) return true;
    const std::lock_guard lock(mutex_);
    if (stopped_) return false;
    so_far_ += work;
    stopped_ = !monitor_(std::min(so_far_ / work_, 1.0));
    return !stopped_;
  }

  bool stopped() const { return stopped_; }

  /// \throw Cancelled  if it has been stopped.
  void check() const {
    if (stopped_) throw Cancelled();
  }

 private:
  const Monitor& monitor_;
  const double work_;
  double so_far_ = 0;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
};

}  // namespace whittle::measure
