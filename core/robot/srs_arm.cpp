#include "core/robot/srs_arm.h"

#include <cmath>

namespace mirrorarm::robot {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 1e-7;
constexpr double kShortestLink_m = 0.01;

/// A joint's axis in the base, at angle zero.
struct Axis {
  Vector3d point, direction;
};

struct Stretched {
  std::array<Axis, kSrsJoints> axes;
  RigidTransform X_BF;
};

Stretched stretched(const ArmDescription& arm) {
  Stretched zero;
  RigidTransform X = RigidTransform::Identity();
  for (std::size_t i = 0; i < zero.axes.size(); ++i) {
    X = X * arm.joints[i].X_parent;
    zero.axes[i] = {X.translation(), X.linear() * arm.joints[i].axis};
  }
  zero.X_BF = X * arm.X_last_F;
  return zero;
}

bool areParallel(const Axis& one, const Axis& other) {
  return one.direction.cross(other.direction).norm() <= kTolerance;
}

bool isOn(const Axis& line, const Vector3d& point) {
  return (point - line.point).cross(line.direction).norm() <= kTolerance;
}

bool isOneLine(const Axis& one, const Axis& other) {
  return areParallel(one, other) && isOn(one, other.point);
}

/// Where `across` meets the line, when it does so at a right angle.
std::optional<Vector3d> crossing(const Axis& line, const Axis& across) {
  if (std::abs(line.direction.dot(across.direction)) > kTolerance) return std::nullopt;
  const Vector3d foot = line.point + (across.point - line.point).dot(line.direction) * line.direction;
  if (!isOn(across, foot)) return std::nullopt;
  return foot;
}

/// x of the base without its part along z of U; y where that leaves nothing.
Vector3d aheadIn(const Eigen::Matrix3d& R_UB) {
  for (const int axis : {0, 1}) {
    const Vector3d level(R_UB(0, axis), R_UB(1, axis), 0.0);
    if (level.norm() > 0.1) return level.normalized();
  }
  return Vector3d::UnitX();
}

}  // namespace

std::optional<SrsArm> srsArm(const ArmDescription& arm) {
  if (arm.jointCount() != kSrsJoints) return std::nullopt;
  const auto [axes, X_BF] = stretched(arm);
  const bool along =
      isOneLine(axes[0], axes[2]) && isOneLine(axes[0], axes[4]) && isOneLine(axes[0], axes[6]);
  const bool across = areParallel(axes[1], axes[3]) && areParallel(axes[1], axes[5]);
  const auto shoulder = crossing(axes[0], axes[1]), elbow = crossing(axes[0], axes[3]),
             wrist = crossing(axes[0], axes[5]);
  if (!along || !across || !shoulder || !elbow || !wrist) return std::nullopt;

  SrsArm srs;
  const Vector3d z = (*wrist - *shoulder).normalized();
  const Vector3d x = axes[1].direction.cross(z).normalized(), y = z.cross(x);
  srs.upper_arm_m = (*elbow - *shoulder).dot(z);
  srs.forearm_m = (*wrist - *elbow).dot(z);
  if (!(srs.upper_arm_m > kShortestLink_m && srs.forearm_m > kShortestLink_m)) return std::nullopt;
  for (std::size_t i = 0; i < axes.size(); ++i)
    srs.sign[i] = axes[i].direction.dot(i % 2 == 0 ? z : y) > 0.0 ? 1.0 : -1.0;
  Eigen::Matrix3d R_BU;
  R_BU << x, y, z;
  srs.X_UB = makeTransform(R_BU, *shoulder).inverse();
  srs.X_FW = X_BF.inverse() * makeTransform(R_BU, *wrist);
  srs.ahead_U = aheadIn(srs.X_UB.linear());
  return srs;
}

}  // namespace mirrorarm::robot
