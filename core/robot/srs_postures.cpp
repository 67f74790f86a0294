#include "core/robot/srs_postures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirrorarm::robot {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kRoundOff = 1e-11;     // of the reach: a pose of the stretched arm is still one
constexpr double kAligned = 1e-12;      // sine of a bend, below which only the sum of its neighbours is known
constexpr double kSmallestSine = 1e-6;  // for rates, which have no bound where the arm is aligned

Matrix3d crossMatrix(const Vector3d& w) {
  Matrix3d W;
  W << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
  return W;
}

/// Where the elbow points at arm angle 0, across `w`. Singular where the wrist is right behind the shoulder,
/// alone.
Vector3d reference(const Vector3d& ahead, const Vector3d& w) {
  const Vector3d k = (w + ahead).cross(Vector3d::UnitZ());
  const Vector3d across = k.cross(w);
  const double length = across.norm();
  const Vector3d n = length > 1e-9 ? Vector3d(across / length) : Vector3d::UnitZ();
  return (n - n.dot(w) * w).normalized();
}

/// R = Rz(first) Ry(middle) Rz(last), middle 0..pi. The last angle is read off what the others leave, so the
/// product holds also where the middle one vanishes.
struct Zyz {
  double first, middle, last;
};

Zyz zyz(const Matrix3d& R) {
  const double across = std::hypot(R(0, 2), R(1, 2));
  const double c = across > kAligned ? R(0, 2) / across : 1.0, s = across > kAligned ? R(1, 2) / across : 0.0;
  return {std::atan2(s, c), std::atan2(across, R(2, 2)),
          std::atan2(c * R(1, 0) - s * R(0, 0), c * R(1, 1) - s * R(0, 1))};
}

/// Speeds of the first, middle and last angle of a z-y-z joint that turns with `w`.
Vector3d zyzRates(double first, double middle, const Vector3d& w) {
  const double c = std::cos(first), s = std::sin(first);
  const double sine = std::sin(middle);
  const double safe = std::copysign(std::max(std::abs(sine), kSmallestSine), sine);
  const double last = (c * w.x() + s * w.y()) / safe;
  return {w.z() - last * std::cos(middle), c * w.y() - s * w.x(), last};
}

double halfTurn(double angle) { return angle > 0.0 ? angle - kPi : angle + kPi; }

Matrix3d aboutZ(double angle) { return AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); }
Matrix3d aboutY(double angle) { return AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix(); }

}  // namespace

std::optional<SrsPostures> SrsPostures::at(const SrsArm& arm, const RigidTransform& X_BF) {
  const RigidTransform X_UW = arm.X_UB * X_BF * arm.X_FW;
  const double reach = X_UW.translation().norm();
  const double a = arm.upper_arm_m, b = arm.forearm_m;
  const double slack = kRoundOff * (a + b);
  if (!(reach <= a + b + slack && reach >= std::abs(a - b) - slack) || reach < slack) return std::nullopt;

  SrsPostures all(arm);
  const double spare = std::max(0.0, (a + b - reach) * (a + b + reach));
  const double folded = std::max(0.0, (reach - a + b) * (reach + a - b));
  all.elbow_ = 2.0 * std::atan2(std::sqrt(spare), std::sqrt(folded));
  const double sine = b * std::sin(all.elbow_) / reach, cosine = (a + b * std::cos(all.elbow_)) / reach;

  const Vector3d w = X_UW.translation() / reach;
  const Vector3d n = reference(arm.ahead_U, w);
  Matrix3d R_03;
  R_03 << sine * w - cosine * n, n.cross(w), cosine * w + sine * n;
  const Matrix3d R_04 = R_03 * aboutY(all.elbow_), R_07 = X_UW.linear();
  const Matrix3d along = w * w.transpose(), across = Matrix3d::Identity() - along, turn = crossMatrix(w);
  all.towards_wrist_U = w;
  all.turn_4_ = -(R_04.transpose() * w);
  all.shoulder_ = {along * R_03, across * R_03, turn * R_03};
  all.wrist_ = {R_04.transpose() * along * R_07, R_04.transpose() * across * R_07,
                -(R_04.transpose() * turn * R_07)};
  return all;
}

Joints SrsPostures::firstBranch(double arm_angle) const {
  const double c = std::cos(arm_angle), s = std::sin(arm_angle);
  const Zyz shoulder = zyz(shoulder_.at(c, s)), wrist = zyz(wrist_.at(c, s));
  return (Joints(kSrsJoints) << shoulder.first, shoulder.middle, shoulder.last, elbow_, wrist.first,
          wrist.middle, wrist.last)
      .finished();
}

Joints SrsPostures::turnedOver(const Joints& canonical, int branch) const {
  Joints q = canonical;
  for (int bit = 0; bit < 3; ++bit) {
    if ((branch >> bit & 1) == 0) continue;
    const int middle = 2 * bit + 1;
    q[middle - 1] = halfTurn(q[middle - 1]);
    q[middle] = -q[middle];
    q[middle + 1] = halfTurn(q[middle + 1]);
  }
  for (int i = 0; i < kSrsJoints; ++i) q[i] *= sign_[static_cast<std::size_t>(i)];
  return q;
}

Joints SrsPostures::posture(double arm_angle, int branch) const {
  return turnedOver(firstBranch(arm_angle), branch);
}

std::array<Joints, kSrsBranches> SrsPostures::branches(double arm_angle) const {
  const Joints first = firstBranch(arm_angle);
  std::array<Joints, kSrsBranches> all;
  for (int branch = 0; branch < kSrsBranches; ++branch)
    all[static_cast<std::size_t>(branch)] = turnedOver(first, branch);
  return all;
}

Joints SrsPostures::rates(const Joints& q) const {
  Joints c = q;
  for (int i = 0; i < kSrsJoints; ++i) c[i] *= sign_[static_cast<std::size_t>(i)];
  const double over = c[3] < 0.0 ? -1.0 : 1.0;  // an elbow turned over looks at the hand from behind
  Joints rates(kSrsJoints);
  rates << zyzRates(c[0], c[1], towards_wrist_U), 0.0,
      zyzRates(c[4], c[5], {over * turn_4_.x(), over * turn_4_.y(), turn_4_.z()});
  for (int i = 0; i < kSrsJoints; ++i) rates[i] *= sign_[static_cast<std::size_t>(i)];
  return rates;
}

SrsWrist srsWrist(const SrsArm& arm, const Joints& q) {
  Joints c = q;
  for (int i = 0; i < kSrsJoints; ++i) c[i] *= arm.sign[static_cast<std::size_t>(i)];
  const Matrix3d R_03 = aboutZ(c[0]) * aboutY(c[1]) * aboutZ(c[2]);
  const Matrix3d R_04 = R_03 * aboutY(c[3]);
  SrsWrist wrist;
  wrist.X_UW = makeTransform(Matrix3d(R_04 * aboutZ(c[4]) * aboutY(c[5]) * aboutZ(c[6])),
                             arm.upper_arm_m * R_03.col(2) + arm.forearm_m * R_04.col(2));
  const Vector3d w = wrist.X_UW.translation().normalized();
  const Vector3d n = reference(arm.ahead_U, w);
  // The elbow's axis says how far the plane of the arm is turned, also when the arm is stretched.
  const Vector3d axis = c[3] < 0.0 ? Vector3d(-R_03.col(1)) : Vector3d(R_03.col(1));
  wrist.arm_angle = std::atan2(axis.dot(n), -axis.dot(w.cross(n)));
  return wrist;
}

}  // namespace mirrorarm::robot
