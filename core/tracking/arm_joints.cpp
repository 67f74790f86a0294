#include "core/tracking/arm_joints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSingular_rad = 10.0 * std::numbers::pi / 180.0;
constexpr double kLeastSine = 1e-6;
constexpr double kAnyAngle_rad = std::numbers::pi / std::numbers::sqrt3;  // deviation of an angle unknown

/// A turn of one bone against another, with its covariance as a small turn in the second's frame.
struct Turn {
  Matrix3d R = Matrix3d::Identity();
  Matrix3d covariance = Matrix3d::Zero();
};

/// From bone a in target A to bone b in target B.
Turn turnBetween(const Orientation& A, const Matrix3d& R_Aa, const Orientation& B, const Matrix3d& R_Bb) {
  Turn turn;
  turn.R = (A.R_C * R_Aa).transpose() * B.R_C * R_Bb;
  const Matrix3d a_to_b = turn.R.transpose() * R_Aa.transpose();
  turn.covariance = R_Bb.transpose() * B.covariance * R_Bb + a_to_b * A.covariance * a_to_b.transpose();
  return turn;
}

/// The same joint seen in a mirror: z becomes -z, and a turn's x and y components change their sign.
Turn mirrored(const Turn& turn) {
  const Eigen::DiagonalMatrix<double, 3> mirror(1.0, 1.0, -1.0), of_turns(-1.0, -1.0, 1.0);
  return {mirror * turn.R * mirror, of_turns * turn.covariance * of_turns};
}

/// Standard deviations of three angles whose small changes make a turn about these axes, in the second
/// bone's frame.
Vector3d deviations(const Matrix3d& axes, const Matrix3d& covariance) {
  const Matrix3d inverse = axes.inverse();
  const Vector3d variances = (inverse * covariance * inverse.transpose()).diagonal();
  return variances.cwiseMax(0.0).cwiseSqrt().cwiseMin(kAnyAngle_rad);
}

/// Away from zero by at least the least sine, so that a singular posture gives large numbers, no infinite
/// ones.
double kept(double value) { return std::copysign(std::max(std::abs(value), kLeastSine), value); }

void store(ArmAngles& angles, ArmAngle first, const Vector3d& value, const Vector3d& sigma) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    angles.value_rad[first + static_cast<std::size_t>(k)] = value[k];
    angles.sigma_rad[first + static_cast<std::size_t>(k)] = sigma[k];
  }
}

/// Rz(a) Rx(b) Ry(c).
void solveElbow(const Turn& turn, ArmAngles& angles) {
  const Matrix3d& R = turn.R;
  const double a = std::atan2(-R(0, 1), R(1, 1));
  const double b = std::asin(std::clamp(R(2, 1), -1.0, 1.0));
  const double c = std::atan2(-R(2, 0), R(2, 2));
  const double cos_b = kept(std::cos(b));
  Matrix3d axes;
  axes.col(0) << -cos_b * std::sin(c), std::sin(b), cos_b * std::cos(c);
  axes.col(1) << std::cos(c), 0.0, std::sin(c);
  axes.col(2) << 0.0, 1.0, 0.0;
  store(angles, kElbowFlexion, {a, b, c}, deviations(axes, turn.covariance));
  angles.elbow_singular = std::abs(std::cos(b)) < std::sin(kSingular_rad);
}

/// Ry(a) Rx(-b) Ry(c), b >= 0.
void solveShoulder(const Turn& turn, ArmAngles& angles) {
  const Matrix3d& R = turn.R;
  const double b = std::acos(std::clamp(R(1, 1), -1.0, 1.0));
  const double a = std::atan2(-R(0, 1), -R(2, 1));
  const double c = std::atan2(-R(1, 0), R(1, 2));
  const double sin_b = kept(std::sin(b));
  Matrix3d axes;
  axes.col(0) << -sin_b * std::sin(c), std::cos(b), sin_b * std::cos(c);
  axes.col(1) << -std::cos(c), 0.0, -std::sin(c);
  axes.col(2) << 0.0, 1.0, 0.0;
  store(angles, kPlaneOfElevation, {a, b, c}, deviations(axes, turn.covariance));
  angles.shoulder_singular = std::sin(b) < std::sin(kSingular_rad);
}

}  // namespace

std::string_view id(Side side) { return side == Side::kLeft ? "left" : "right"; }

std::string_view id(ArmAngle angle) {
  constexpr std::array<std::string_view, kArmAngles> kNames{
      "elbow_flexion", "carrying_angle", "pronation", "plane_of_elevation", "elevation", "axial_rotation"};
  return kNames[angle];
}

ArmAngles armAngles(const ArmModel& model, const Orientation& upper_arm, const Orientation& forearm,
                    const Orientation& reference) {
  Turn elbow = turnBetween(upper_arm, model.R_Uh, forearm, model.R_Ff);
  Turn shoulder = turnBetween(reference, model.R_Rt, upper_arm, model.R_Uh);
  if (model.side == Side::kLeft) {
    elbow = mirrored(elbow);
    shoulder = mirrored(shoulder);
  }
  ArmAngles angles;
  solveElbow(elbow, angles);
  solveShoulder(shoulder, angles);
  return angles;
}

}  // namespace mirrorarm::tracking
