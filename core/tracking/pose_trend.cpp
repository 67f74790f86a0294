#include "core/tracking/pose_trend.h"

#include <algorithm>

namespace mirrorarm::tracking {
namespace {

constexpr Seconds kMaxStep{0.15};  // poses farther apart say nothing about a velocity
constexpr double kRest_m = 0.004;
constexpr double kSpeed_m_s = 1.0;
constexpr double kAcceleration_m_s2 = 10.0;

}  // namespace

void PoseTrend::add(TimePoint time, const RigidTransform& X_CT) {
  const Seconds step = time - time_;
  moving_ = known_ && step > Seconds::zero() && step <= kMaxStep;
  if (moving_) {
    velocity_C_ = (X_CT.translation() - X_CT_.translation()) / step.count();
    turn_rate_C_ = rotationVector(X_CT.linear() * X_CT_.linear().transpose()) / step.count();
  }
  known_ = true;
  time_ = time;
  X_CT_ = X_CT;
}

Seconds PoseTrend::ageAt(TimePoint time) const { return std::max(Seconds(time - time_), Seconds::zero()); }

RigidTransform PoseTrend::at(TimePoint time) const {
  if (!moving_) return X_CT_;
  const double age = ageAt(time).count();
  const double angle = turn_rate_C_.norm() * age;
  const Eigen::AngleAxisd turn(angle, angle > 0.0 ? Eigen::Vector3d(turn_rate_C_.normalized())
                                                  : Eigen::Vector3d(Eigen::Vector3d::UnitX()));
  return makeTransform(Eigen::Matrix3d(turn.toRotationMatrix() * X_CT_.linear()),
                       Eigen::Vector3d(X_CT_.translation() + age * velocity_C_));
}

double PoseTrend::uncertaintyAt(TimePoint time) const {
  const double age = ageAt(time).count();
  return kRest_m + (moving_ ? 0.5 * kAcceleration_m_s2 * age * age : kSpeed_m_s * age);
}

}  // namespace mirrorarm::tracking
