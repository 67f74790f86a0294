#pragma once

#include <array>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "core/geometry/rigid_transform.h"

namespace mirrorarm::tracking {

enum class Side : std::uint8_t { kLeft, kRight };
/// "left", "right".
[[nodiscard]] std::string_view id(Side side);

/// How an arm's bones lie in the targets on it. Anatomical axes after Wu et al., J. Biomechanics 38, 2005, of
/// a body that stands upright: x forward, y up the bone (towards the trunk), z to the body's right, on either
/// side of the body. The reference R, against which the shoulder turns, is a target on the thorax or, without
/// one, the camera: then camera and trunk must not turn against each other.
struct ArmModel {
  Side side = Side::kRight;
  std::string upper_arm;  ///< name of the target U on the upper arm
  std::string forearm;    ///< name of the target F on the forearm
  std::string thorax;     ///< name of the target on the thorax; empty: the camera is the reference
  Eigen::Matrix3d R_Uh = Eigen::Matrix3d::Identity();    ///< humerus in U
  Eigen::Matrix3d R_Ff = Eigen::Matrix3d::Identity();    ///< forearm in F
  Eigen::Matrix3d R_Rt = Eigen::Matrix3d::Identity();    ///< thorax in R
  Eigen::Vector3d shoulder_U = Eigen::Vector3d::Zero();  ///< centre of the shoulder in U [m]
  Eigen::Vector3d elbow_U = Eigen::Vector3d::Zero();     ///< centre of the elbow in U [m]
};

/// Angles of shoulder and elbow [rad], ISB's joint coordinate systems. Left arms are mirrored first, so that
/// the same numbers mean the same on both sides.
enum ArmAngle : std::size_t {
  kElbowFlexion,      ///< about the humerus' z; 0 straight
  kCarryingAngle,     ///< about the floating axis
  kPronation,         ///< about the forearm's y; 0 where the calibration began, palm up; negative: supination
  kPlaneOfElevation,  ///< about the thorax' y; 0 sideways, 90 degrees forward
  kElevation,         ///< 0 arm hanging .. 180 degrees
  kAxialRotation,     ///< about the humerus' y; inward positive
  kArmAngles
};
/// "elbow_flexion", ... as tables name them.
[[nodiscard]] std::string_view id(ArmAngle angle);

struct ArmAngles {
  std::array<double, kArmAngles> value_rad{};
  std::array<double, kArmAngles> sigma_rad{};  ///< from the poses' covariances; at most that of any angle
  /// Elevation within 10 degrees of 0 or 180: plane of elevation and axial rotation turn about the same line,
  /// only their sum (at 180 degrees: difference) means something.
  bool shoulder_singular = false;
  /// Carrying angle within 10 degrees of a right angle: so of flexion and pronation.
  bool elbow_singular = false;
};

/// Turn of a target in the camera, with its covariance as a small turn in the target's frame [rad^2].
struct Orientation {
  Eigen::Matrix3d R_C = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The angles at one instant. `reference` is the thorax target's orientation, or default-made when the camera
/// is the reference. Elbow: R_hf = Rz(flexion) Rx(carrying) Ry(pronation); shoulder:
/// R_th = Ry(plane) Rx(-elevation) Ry(axial). Source: Wu et al. 2005, sections 2.4.7 and 3.4.1; Grood and
/// Suntay, J. Biomechanical Engineering 105, 1983.
[[nodiscard]] ArmAngles armAngles(const ArmModel& model, const Orientation& upper_arm,
                                  const Orientation& forearm, const Orientation& reference);

}  // namespace mirrorarm::tracking
