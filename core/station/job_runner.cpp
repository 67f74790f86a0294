#include "core/station/job_runner.h"

namespace mirrorarm::station {

JobsBeside::JobsBeside() : thread_([this](const std::stop_token& stop) { work(stop); }) {}
JobsBeside::~JobsBeside() = default;

void JobsBeside::run(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  came_.notify_one();
}

void JobsBeside::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (came_.wait(lock, stop, [this] { return !jobs_.empty(); }) && !stop.stop_requested()) {
    const auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
}

}  // namespace mirrorarm::station
