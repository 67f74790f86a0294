#include "core/simulation/joint_trail.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::simulation {

JointTrail::JointTrail(TimePoint time, const robot::Joints& start) : joints_(start.size()) {
  add(time, start);
}

// Each store releases what was stored before it: whoever reads an angle of a later moment also sees that
// `count_` had come so far, and looks again.
void JointTrail::add(TimePoint time, const robot::Joints& q_rad) noexcept {
  assert(q_rad.size() == joints_);
  if (time <= newest_) return;
  newest_ = time;
  const std::uint64_t count = count_.load(std::memory_order_relaxed);
  Slot& next = slots_[count % kSlots];
  next.time.store(time.time_since_epoch().count(), std::memory_order_release);
  for (Eigen::Index i = 0; i < joints_; ++i)
    next.q_rad[static_cast<std::size_t>(i)].store(q_rad[i], std::memory_order_release);
  count_.store(count + 1, std::memory_order_release);
}

robot::Joints JointTrail::at(TimePoint time) const noexcept {
  for (;;) {
    const std::uint64_t count = count_.load(std::memory_order_acquire);
    const robot::Joints q_rad = between(count - std::min(count, kKept), count - 1, time);
    if (count_.load(std::memory_order_acquire) - count < kSlots - kKept) return q_rad;
  }
}

TimePoint JointTrail::timeOf(std::uint64_t moment) const noexcept {
  return TimePoint(Clock::duration(slot(moment).time.load(std::memory_order_acquire)));
}

robot::Joints JointTrail::anglesOf(std::uint64_t moment) const noexcept {
  robot::Joints q_rad(joints_);
  for (Eigen::Index i = 0; i < joints_; ++i)
    q_rad[i] = slot(moment).q_rad[static_cast<std::size_t>(i)].load(std::memory_order_acquire);
  return q_rad;
}

robot::Joints JointTrail::between(std::uint64_t oldest, std::uint64_t newest, TimePoint time) const noexcept {
  if (time <= timeOf(oldest)) return anglesOf(oldest);
  if (time >= timeOf(newest)) return anglesOf(newest);
  while (newest - oldest > 1) {
    const std::uint64_t middle = (oldest + newest) / 2;
    (timeOf(middle) <= time ? oldest : newest) = middle;
  }
  const robot::Joints before = anglesOf(oldest), after = anglesOf(newest);
  const double share = secondsBetween(timeOf(oldest), time) / secondsBetween(timeOf(oldest), timeOf(newest));
  return before + share * (after - before);
}

}  // namespace mirrorarm::simulation
