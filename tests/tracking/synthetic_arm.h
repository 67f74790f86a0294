#pragma once

#include "core/tracking/arm_calibration.h"
#include "tests/tracking/world.h"

namespace mirrorarm::tracking::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Eigen::Matrix3d about(const Vector3d& axis, double angle_deg) {
  return Eigen::AngleAxisd(angle_deg * kDegree, axis.normalized()).toRotationMatrix();
}

/// A joint as ISB's angles say it, of the body's right side.
struct Posture {
  double flexion_deg = 0.0, carrying_deg = 8.0, pronation_deg = 0.0;
  double plane_deg = 0.0, elevation_deg = 0.0, axial_deg = 0.0;
};

/// An arm of known bones, its targets put on anyhow. Poses have noise, and the skin shifts and turns the
/// targets against the bones as the joints move.
struct SyntheticArm {
  Side side = Side::kRight;
  double turn_noise_rad = 0.0005;
  double skin_rad = 0.0;  ///< turn of a target against its bone at a right angle of the joint
  RigidTransform X_Ct = makeTransform(about({1.0, 0.2, 0.1}, 170.0), Vector3d(0.05, -0.2, 0.9));
  RigidTransform X_hU = makeTransform(about({0.3, -0.5, 0.8}, 75.0), Vector3d(0.02, -0.15, 0.05));
  RigidTransform X_fF = makeTransform(about({-0.7, 0.4, 0.2}, 130.0), Vector3d(0.03, -0.14, 0.02));
  double upper_arm_m = 0.3;
  Noise noise{11};

  /// A turn seen in the mirror for a left arm.
  Eigen::Matrix3d onSide(const Eigen::Matrix3d& R) const {
    if (side == Side::kRight) return R;
    const Eigen::DiagonalMatrix<double, 3> mirror(1.0, 1.0, -1.0);
    return mirror * R * mirror;
  }

  RigidTransform measured(const RigidTransform& X) {
    return X * makeTransform(turned(noise.gaussian(turn_noise_rad)), noise.gaussian(0.0001));
  }
  static Eigen::Matrix3d turned(const Vector3d& v) {
    return v.norm() > 0.0 ? about(v, v.norm() / kDegree) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  }

  ArmFrame at(const Posture& p) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    const Eigen::Matrix3d R_th =
        onSide(about(y, p.plane_deg) * about(x, -p.elevation_deg) * about(y, p.axial_deg));
    const Eigen::Matrix3d R_hf =
        onSide(about(z, p.flexion_deg) * about(x, p.carrying_deg) * about(y, p.pronation_deg));
    const RigidTransform X_th = makeTransform(R_th, Vector3d(0.0, 0.0, side == Side::kRight ? 0.18 : -0.18));
    const RigidTransform X_hf = makeTransform(R_hf, Vector3d(0.0, -upper_arm_m, 0.0));
    const auto skin = [this](double joint_deg) {
      return makeTransform(turned(skin_rad * std::sin(joint_deg * kDegree) * Vector3d(0.6, 0.5, -0.6)),
                           Vector3d(0.0, 0.003 * skin_rad / 0.05 * std::sin(joint_deg * kDegree), 0.0));
    };
    ArmFrame frame;
    frame.X_CR = measured(X_Ct);
    frame.X_CU = measured(X_Ct * X_th * X_hU * skin(p.axial_deg));
    frame.X_CF = measured(X_Ct * X_th * X_hf * X_fF * skin(p.pronation_deg));
    return frame;
  }

  ArmMovements movements() {
    ArmMovements moves;
    for (int i = 0; i < 30; ++i) moves.posture.push_back(at({.flexion_deg = 90.0}));
    for (int i = 0; i < 120; ++i) {
      const double swing = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * i / 60.0);
      moves.flexion.push_back(at({.flexion_deg = 5.0 + 110.0 * swing, .pronation_deg = 10.0}));
      moves.rotation.push_back(at({.flexion_deg = 85.0, .pronation_deg = 130.0 * swing}));
      const double round = 2.0 * std::numbers::pi * i / 60.0;
      moves.circles.push_back(at({.flexion_deg = 5.0,
                                  .plane_deg = 60.0 + 35.0 * std::cos(round),
                                  .elevation_deg = 45.0 + 25.0 * std::sin(round)}));
    }
    return moves;
  }
};

inline ArmAngles anglesOf(const ArmModel& model, const ArmFrame& frame, double turn_sigma_rad = 0.0) {
  const Eigen::Matrix3d covariance = turn_sigma_rad * turn_sigma_rad * Eigen::Matrix3d::Identity();
  return armAngles(model, {frame.X_CU.linear(), covariance}, {frame.X_CF.linear(), covariance},
                   {frame.X_CR.linear(), covariance});
}

}  // namespace mirrorarm::tracking::test
