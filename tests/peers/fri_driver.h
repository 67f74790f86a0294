#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/robot/robot_link.h"
#include "core/robot/urdf.h"

namespace mirrorarm::peers {

inline const robot::Joints kHome = (robot::Joints(7) << 0.1, 0.5, -0.2, 1.2, 0.0, -0.7, 0.3).finished();

inline robot::ArmDescription lbr() {
  const auto arm = robot::readUrdf(std::filesystem::path(RESOURCES) / "robots/lbr4plus.urdf");
  EXPECT_TRUE(arm) << describe(arm.error());
  return *arm;
}

/// The least that a servo loop does with a link: takes over from rest, holds for a while, then swings all
/// joints at up to 0.2 rad/s; the first fault is kept and answered by halt() in every cycle until reset().
class FriDriver {
 public:
  explicit FriDriver(robot::RobotLink& link) : link_(link) {}

  void cycle() {
    const auto read = link_.read();
    const bool silent = !read && read.error() == robot::LinkFault::kNoAnswer;
    quiet_ = silent ? quiet_ + 1 : 0;
    if (!read && (!silent || quiet_ > kQuietCycles)) fail(read.error());
    if (fault_ != robot::LinkFault::kNone) return link_.halt();
    if (!read && !driven_) return;
    if (!driven_) {
      if (read->v_rad_s.cwiseAbs().maxCoeff() > 1e-2) return;
      driven_ = true;
      begin_ = read->q_rad;
      time_s_ = 0.0;
    }
    time_s_ += link_.period().count();
    const double swing_s = std::max(0.0, time_s_ - kHold_s);
    const robot::Joints q = begin_.array() +
                            0.2 * (swing_s - std::sin(2.0 * swing_s) / 2.0) * (swing_s < M_PI ? 0.5 : 0.0) +
                            (swing_s < M_PI ? 0.0 : 0.1 * M_PI);
    const auto sent = link_.command({q, {}});
    if (!sent && sent.error() != robot::LinkFault::kNoAnswer) fail(sent.error());
  }
  /// As the operator does.
  void stop() { fail(robot::LinkFault::kNotReady); }
  void reset() { fault_ = robot::LinkFault::kNone; }
  [[nodiscard]] robot::LinkFault fault() const { return fault_; }
  [[nodiscard]] bool isSwinging() const { return driven_ && time_s_ > kHold_s + 0.2; }

 private:
  static constexpr double kHold_s = 0.5;
  static constexpr int kQuietCycles = 50;
  void fail(robot::LinkFault fault) {
    fault_ = fault;
    driven_ = false;
  }

  robot::RobotLink& link_;
  robot::LinkFault fault_ = robot::LinkFault::kNone;
  robot::Joints begin_;
  double time_s_ = 0.0;
  bool driven_ = false;
  int quiet_ = 0;
};

}  // namespace mirrorarm::peers
