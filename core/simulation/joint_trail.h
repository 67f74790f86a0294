#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/common/time.h"
#include "core/robot/joints.h"

namespace mirrorarm::simulation {

/// Where an arm was in the last 4096 moments. One thread adds, without waiting or allocating; any thread
/// asks.
class JointTrail {
 public:
  JointTrail(TimePoint time, const robot::Joints& start);

  /// As many angles as at the start. A time not after the newest one is ignored.
  void add(TimePoint time, const robot::Joints& q_rad) noexcept;
  /// Interpolated; the oldest or newest where `time` lies outside what is kept.
  [[nodiscard]] robot::Joints at(TimePoint time) const noexcept;

 private:
  static constexpr std::uint64_t kKept = 4096;
  static constexpr std::uint64_t kSlots = kKept + 512;  // so many may be added while somebody looks
  struct Slot {
    std::atomic<Clock::rep> time{};
    std::array<std::atomic<double>, robot::kMaxJoints> q_rad{};
  };
  [[nodiscard]] const Slot& slot(std::uint64_t moment) const noexcept { return slots_[moment % kSlots]; }
  [[nodiscard]] TimePoint timeOf(std::uint64_t moment) const noexcept;
  [[nodiscard]] robot::Joints anglesOf(std::uint64_t moment) const noexcept;
  [[nodiscard]] robot::Joints between(std::uint64_t oldest, std::uint64_t newest,
                                      TimePoint time) const noexcept;

  const Eigen::Index joints_;
  TimePoint newest_ = TimePoint::min();  ///< the adding thread's
  std::array<Slot, kSlots> slots_;
  std::atomic<std::uint64_t> count_{0};  ///< moments added so far
};

}  // namespace mirrorarm::simulation
