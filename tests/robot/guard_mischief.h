#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>

#include "core/robot/motion_guard.h"

namespace mirrorarm::robot::testing {

/// Wishes that nobody in his senses would send, in runs of one kind.
class Mischief {
 public:
  enum class Kind {
    kAnywhere,   ///< a new place every cycle
    kShaking,    ///< about where the arm is
    kNonsense,   ///< not a number, infinite or enormous now and then
    kUpwards,    ///< beyond all upper ends
    kDownwards,  ///< beyond all lower ends
    kFlipping,   ///< to and fro, every few cycles or every one
    kSprinting,  ///< as fast as allowed, one way
    kBanging,    ///< full jerk to and fro, each joint at its own times: a wish that keeps all joint limits
    kCornering,  ///< full jerk of all joints in the direction in which the flange gains most
    kSwinging,   ///< sines too fast for the arm
  };
  static constexpr int kKinds = 10;
  static constexpr std::array<std::string_view, kKinds> kNames = {
      "anywhere", "shaking",   "nonsense", "upwards",   "downwards",
      "flipping", "sprinting", "banging",  "cornering", "swinging"};

  explicit Mischief(unsigned seed) : random_(seed) {}

  /// Changes the kind every few hundred cycles.
  MotionState wish(int cycle, const Commanded& last, const Jacobian& J, double period_s,
                   const MotionLimits& limits) {
    if (cycle % 400 == 0) choose(static_cast<Kind>(random_() % kKinds), last.q_rad.size());
    return wishOf(cycle, last, J, period_s, limits);
  }
  [[nodiscard]] Kind kind() const { return kind_; }

  void choose(Kind kind, Eigen::Index joints) {
    kind_ = kind;
    flip_ = 1 + static_cast<int>(random_() % 2 == 0 ? 0 : random_() % 60);
    direction_ = Eigen::Vector3d(any(1.0), any(1.0), any(1.0)).normalized();
    sign_ = Joints::NullaryExpr(joints, [&] { return random_() % 2 == 0 ? 1.0 : -1.0; });
  }

  MotionState wishOf(int cycle, const Commanded& last, const Jacobian& J, double period_s,
                     const MotionLimits& limits) {
    if (kind_ == Kind::kBanging || kind_ == Kind::kCornering) return pushed(cycle, last, J, period_s, limits);
    const Eigen::Index n = last.q_rad.size();
    MotionState wish{last.q_rad, Joints::Zero(n), Joints::Zero(n)};
    for (Eigen::Index j = 0; j < n; ++j) bend(wish, j, cycle, period_s, limits);
    return wish;
  }

 private:
  void bend(MotionState& wish, Eigen::Index j, int cycle, double period_s, const MotionLimits& limits) {
    const double middle = 0.5 * (limits.lower_rad[j] + limits.upper_rad[j]);
    double& q = wish.q_rad[j];
    switch (kind_) {
      case Kind::kAnywhere:
        q = any(3.0);
        break;
      case Kind::kShaking:
        q += any(0.01);
        break;
      case Kind::kNonsense:
        q = random_() % 40 == 0 ? nonsense() : q + any(0.002);
        break;
      case Kind::kUpwards:
        q = limits.upper_rad[j] + 0.5;
        break;
      case Kind::kDownwards:
        q = limits.lower_rad[j] - 0.5;
        break;
      case Kind::kFlipping:
        q = middle + (cycle / flip_ % 2 == 0 ? 1.0 : -1.0);
        break;
      case Kind::kSprinting:
        q += sign_[j] * 1.02 * limits.max_speed_rad_s[j] * period_s;
        wish.v_rad_s[j] = sign_[j] * limits.max_speed_rad_s[j];
        return;
      default:
        q = middle + 0.3 * std::sin((3.0 + static_cast<double>(j)) * cycle * period_s);
        return;
    }
    wish.v_rad_s[j] = random_() % 3 == 0 ? any(100.0) : random_() % 50 == 0 ? nonsense() : any(0.3);
    wish.a_rad_s2[j] = random_() % 3 == 0 ? any(100.0) : random_() % 50 == 0 ? nonsense() : any(0.8);
  }

  /// From where the arm is, with full jerk, as far as the joints' own limits let it.
  MotionState pushed(int cycle, const Commanded& last, const Jacobian& J, double period_s,
                     const MotionLimits& limits) {
    MotionState wish{last.q_rad, last.v_rad_s, last.a_rad_s2};
    for (Eigen::Index j = 0; j < last.q_rad.size(); ++j) {
      if (kind_ == Kind::kCornering)
        sign_[j] = J.block<3, 1>(0, j).dot(direction_) > 0.0 ? 1.0 : -1.0;
      else if ((cycle + 7 * j) % flip_ == 0)
        sign_[j] = random_() % 2 == 0 ? 1.0 : -1.0;
      const double a_max = limits.max_acceleration_rad_s2[j], v_max = limits.max_speed_rad_s[j];
      double& a = wish.a_rad_s2[j];
      a = std::clamp(a + sign_[j] * limits.max_jerk_rad_s3[j] * period_s, -a_max, a_max);
      if (std::abs(last.v_rad_s[j] + period_s * a) > v_max)
        a = (std::copysign(v_max, last.v_rad_s[j]) - last.v_rad_s[j]) / period_s;
      wish.v_rad_s[j] += period_s * a;
      wish.q_rad[j] += period_s * wish.v_rad_s[j];
      wish.v_rad_s[j] += 0.5 * period_s * a;  // of the moment; the wire's is the cycle's mean
    }
    return wish;
  }

  double any(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  double nonsense() {
    const std::array all = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300};
    return all[random_() % all.size()];
  }

  std::mt19937 random_;
  Kind kind_ = Kind::kAnywhere;
  int flip_ = 1;
  Joints sign_;
  Eigen::Vector3d direction_ = Eigen::Vector3d::UnitX();
};

}  // namespace mirrorarm::robot::testing
