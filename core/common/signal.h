#pragma once

#include <condition_variable>
#include <mutex>

#include "core/common/time.h"

namespace mirrorarm {

/// Wakes one waiting thread; a notification that nobody waits for is kept (once).
class Signal {
 public:
  /// Any thread.
  void notify() {
    {
      const std::lock_guard lock(mutex_);
      set_ = true;
    }
    changed_.notify_one();
  }

  /// Waits up to `timeout`; true when it was notified since the last wait.
  bool waitFor(Seconds timeout) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [this] { return set_; });
    const bool was_set = set_;
    set_ = false;
    return was_set;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool set_ = false;  // guarded by mutex_
};

}  // namespace mirrorarm
