#include "core/tracking/arm_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "core/tracking/functional_axes.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Error = ArmCalibrationError;
using Poses = std::vector<RigidTransform>;

constexpr std::size_t kLeastFrames = 10;
constexpr double kSeriesStart_rad = 0.35;  // turned by so much, a movement shows which way it began

Poses forearmInUpperArm(const std::vector<ArmFrame>& frames) {
  Poses X_UF;
  for (const ArmFrame& frame : frames) X_UF.push_back(frame.X_CU.inverse() * frame.X_CF);
  return X_UF;
}

Poses upperArmInReference(const std::vector<ArmFrame>& frames) {
  Poses X_RU;
  for (const ArmFrame& frame : frames) X_RU.push_back(frame.X_CR.inverse() * frame.X_CU);
  return X_RU;
}

/// The axis about which the movement began: turned from the first pose the positive way.
Vector3d asBegun(const Vector3d& axis_P, const Poses& X_PC) {
  for (const auto& X : X_PC) {
    const double turned = axis_P.dot(rotationVector(X.linear() * X_PC.front().linear().transpose()));
    if (std::abs(turned) > kSeriesStart_rad) return turned > 0.0 ? axis_P : Vector3d(-axis_P);
  }
  return axis_P;
}

/// A hinge seen from both its bodies.
struct Hinge {
  Vector3d axis_U = Vector3d::UnitZ();  ///< as the movement began
  Vector3d axis_F = Vector3d::UnitZ();
  Vector3d point_U = Vector3d::Zero();  ///< a point of it
  Vector3d point_F = Vector3d::Zero();
  RotationSpread spread;
};

Expected<Hinge, Error> hingeOf(const Poses& X_UF, double least_range_rad, double max_across, Error too_small,
                               Error no_hinge) {
  if (X_UF.size() < kLeastFrames) return unexpected(too_small);
  Hinge hinge;
  hinge.spread = rotationSpread(X_UF);
  if (hinge.spread.range_rad < least_range_rad) return unexpected(too_small);
  // Of an even movement the rms turn is the range over sqrt(12).
  if (hinge.spread.across_rms_rad > max_across * hinge.spread.range_rad / std::sqrt(12.0))
    return unexpected(no_hinge);
  hinge.axis_U = asBegun(hinge.spread.axis_P, X_UF);
  hinge.axis_F = hinge.spread.mean_R_PC.transpose() * hinge.axis_U;
  const auto centre = rotationCentre(X_UF, hinge.spread.axis_P);
  if (!centre) return unexpected(no_hinge);
  hinge.point_U = centre->in_P;
  hinge.point_F = centre->in_C;
  return hinge;
}

/// The point of the line (p, a) nearest to the line (q, b).
Vector3d nearestOn(const Vector3d& p, const Vector3d& a, const Vector3d& q, const Vector3d& b) {
  const double cosine = a.dot(b), sine2 = std::max(1.0 - cosine * cosine, 1e-6);
  const Vector3d apart = q - p;
  return p + (apart.dot(a) - cosine * apart.dot(b)) / sine2 * a;
}

/// Axes with this y and a z as near to `z_like` as can be.
Matrix3d axesOf(const Vector3d& y, const Vector3d& z_like) {
  Matrix3d R;
  R.col(1) = y.normalized();
  R.col(0) = R.col(1).cross(z_like).normalized();
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

Expected<RotationCentre, Error> shoulderOf(const std::vector<ArmFrame>& circles,
                                           const ArmCalibrationSettings& settings) {
  if (circles.size() < kLeastFrames) return unexpected(Error::kSmallCircles);
  const Poses X_RU = upperArmInReference(circles);
  if (rotationSpread(X_RU).across_rms_rad < settings.min_cone_rad) return unexpected(Error::kSmallCircles);
  const auto centre = rotationCentre(X_RU);
  if (!centre) return unexpected(Error::kSmallCircles);
  if (centre->rms_m > settings.max_strain_m) return unexpected(Error::kShoulderMoved);
  return *centre;
}

/// Mean orientation of the reference posture's humerus in the reference: the thorax' axes.
Matrix3d thoraxOf(const std::vector<ArmFrame>& posture, const Matrix3d& R_Uh) {
  const Poses X_RU = upperArmInReference(posture);
  const Matrix3d mean = X_RU.size() == 1 ? Matrix3d(X_RU.front().linear()) : rotationSpread(X_RU).mean_R_PC;
  return mean * R_Uh;
}

/// The forearm's axes: y up along the axis of its rotation, pronation zero where the rotation began.
Matrix3d forearmOf(const Hinge& rotation, const RigidTransform& X_UF_begin, const Matrix3d& R_Uh, Side side) {
  const Vector3d up_F = side == Side::kRight ? rotation.axis_F : Vector3d(-rotation.axis_F);
  return axesOf(up_F, X_UF_begin.linear().transpose() * R_Uh.col(2));
}

}  // namespace

std::string_view id(ArmCalibrationError error) {
  constexpr std::array<std::string_view, 9> kNames{
      "no_posture",        "small_flexion", "flexion_not_hinge", "small_rotation",  "rotation_not_hinge",
      "rotation_reversed", "small_circles", "shoulder_moved",    "upper_arm_length"};
  return kNames[static_cast<std::size_t>(error)];
}

Expected<CalibratedArm, Error> calibrateArm(const ArmMovements& movements, Side side,
                                            const ArmCalibrationSettings& settings) {
  if (movements.posture.empty()) return unexpected(Error::kNoPosture);
  const auto flexion = hingeOf(forearmInUpperArm(movements.flexion), settings.min_flexion_rad,
                               settings.max_across, Error::kSmallFlexion, Error::kFlexionNotHinge);
  if (!flexion) return unexpected(flexion.error());
  const Poses turning = forearmInUpperArm(movements.rotation);
  const auto rotation = hingeOf(turning, settings.min_rotation_rad, settings.max_across,
                                Error::kSmallRotation, Error::kRotationNotHinge);
  if (!rotation) return unexpected(rotation.error());
  const auto shoulder = shoulderOf(movements.circles, settings);
  if (!shoulder) return unexpected(shoulder.error());

  CalibratedArm arm;
  ArmModel& model = arm.model;
  model.side = side;
  model.shoulder_U = shoulder->in_C;
  model.elbow_U = nearestOn(flexion->point_U, flexion->axis_U, rotation->point_U, rotation->axis_U);
  const Vector3d humerus_U = model.shoulder_U - model.elbow_U;
  if (humerus_U.norm() < settings.min_upper_arm_m || humerus_U.norm() > settings.max_upper_arm_m)
    return unexpected(Error::kUpperArmLength);
  model.R_Uh = axesOf(humerus_U, flexion->axis_U);
  model.R_Ff = forearmOf(*rotation, turning.front(), model.R_Uh, side);
  model.R_Rt = thoraxOf(movements.posture, model.R_Uh);
  // The elbow lies up the forearm from its target.
  const Vector3d elbow_F = turning.front().inverse() * model.elbow_U;
  if (model.R_Ff.col(1).dot(elbow_F) < 0.0) return unexpected(Error::kRotationReversed);
  arm.quality = {flexion->spread.range_rad,
                 flexion->spread.across_rms_rad,
                 rotation->spread.range_rad,
                 rotation->spread.across_rms_rad,
                 shoulder->rms_m,
                 humerus_U.norm()};
  return arm;
}

}  // namespace mirrorarm::tracking
