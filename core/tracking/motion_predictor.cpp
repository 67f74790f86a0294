#include "core/tracking/motion_predictor.h"

#include <algorithm>
#include <cassert>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLongestStep_s = 0.5;
constexpr double kLeastVariance = 1e-12;  // of a covariance that was not told

Vector3d variances(const Matrix3d& covariance) { return covariance.diagonal().cwiseMax(kLeastVariance); }

}  // namespace

void MotionPredictor::add(TimePoint time, const UncertainPose& pose) {
  const Matrix3d R_CT = pose.X_CT.linear();
  const Vector3d shift_variance =
      variances(R_CT * pose.covariance.bottomRightCorner<3, 3>() * R_CT.transpose());
  const Vector3d turn_variance = variances(pose.covariance.topLeftCorner<3, 3>());
  const double step_s = secondsBetween(last_, time);
  if (!known_ || step_s <= 0.0 || step_s > kLongestStep_s) {
    R_CT_ = R_CT;
    shift_.start(pose.X_CT.translation(), shift_variance);
    turn_.start(Vector3d::Zero(), turn_variance);
  } else {
    shift_.add(step_s, pose.X_CT.translation(), shift_variance);
    turn_.add(step_s, rotationVector(R_CT_.transpose() * R_CT), turn_variance);
    const Vector3d turned = turn_.at(0.0).mean;
    turn_.moveOrigin(turned);
    R_CT_ = Eigen::Quaterniond(R_CT_ * turnBy(turned)).normalized().toRotationMatrix();
  }
  known_ = true;
  last_ = time;
}

void MotionPredictor::moveTo(TimePoint time, const RigidTransform& X_CT) {
  const RigidTransform expected_CT = at(time).X_CT;
  shift_.moveOrigin(expected_CT.translation() - X_CT.translation());
  const Matrix3d turn = R_CT_.transpose() * expected_CT.linear();
  R_CT_ = Eigen::Quaterniond(Matrix3d(X_CT.linear() * turn.transpose())).normalized().toRotationMatrix();
}

Seconds MotionPredictor::ageAt(TimePoint time) const {
  return std::max(Seconds(time - last_), Seconds::zero());
}

UncertainPose MotionPredictor::at(TimePoint time) const {
  assert(known_);
  const double step_s = secondsBetween(last_, time);
  const auto shift = shift_.at(step_s);
  const auto turn = turn_.at(step_s);
  UncertainPose pose;
  pose.X_CT = makeTransform(Matrix3d(R_CT_ * turnBy(turn.mean)), shift.mean);
  const Matrix3d R_TC = pose.X_CT.linear().transpose();
  pose.covariance.topLeftCorner<3, 3>() = turn.covariance;
  pose.covariance.bottomRightCorner<3, 3>() = R_TC * shift.covariance * R_TC.transpose();
  return pose;
}

}  // namespace mirrorarm::tracking
