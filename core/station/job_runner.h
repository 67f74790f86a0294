#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace mirrorarm::station {

/// Runs what takes too long for a stage's beat, one job after another. A job must not throw.
class JobRunner {
 public:
  virtual ~JobRunner() = default;
  /// Control thread.
  virtual void run(std::function<void()> job) = 0;
};

/// At once, on the caller's thread: for runs that must be the same each time.
class JobsAtOnce final : public JobRunner {
 public:
  void run(std::function<void()> job) override { job(); }
};

/// On a thread of its own. Destroying it waits for the job that runs and drops those that wait.
class JobsBeside final : public JobRunner {
 public:
  JobsBeside();
  ~JobsBeside() override;
  void run(std::function<void()> job) override;

 private:
  void work(const std::stop_token& stop);
  std::mutex mutex_;
  std::condition_variable_any came_;
  std::deque<std::function<void()>> jobs_;  ///< guarded by mutex_
  std::jthread thread_;                     ///< last member: joined first
};

}  // namespace mirrorarm::station
