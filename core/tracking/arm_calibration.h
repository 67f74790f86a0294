#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/common/expected.h"
#include "core/tracking/arm_joints.h"

namespace mirrorarm::tracking {

/// Where the arm's targets were in one frame; X_CR is the thorax target, or the camera itself.
struct ArmFrame {
  RigidTransform X_CR = RigidTransform::Identity();
  RigidTransform X_CU = RigidTransform::Identity();
  RigidTransform X_CF = RigidTransform::Identity();
};

/// What the person does while the targets are followed, each from its named start.
struct ArmMovements {
  /// Standing still and upright: upper arm hanging at the side, elbow bent to a right angle, forearm straight
  /// ahead. This posture is the thorax' axes: elevation 0, and the way the forearm points is forward.
  std::vector<ArmFrame> posture;
  /// From the straight elbow: bent and stretched, some times.
  std::vector<ArmFrame> flexion;
  /// Elbow bent, from palm up (pronation 0): palm down and up again, some times.
  std::vector<ArmFrame> rotation;
  /// The straight arm swung in a cone about the shoulder, trunk still.
  std::vector<ArmFrame> circles;
};

struct ArmCalibrationSettings {
  double min_flexion_rad = 0.87;  ///< 50 degrees
  double min_rotation_rad = 0.87;
  double max_across = 0.25;       ///< turn across a hinge's axis, of the turn about it
  double min_cone_rad = 0.12;     ///< rms turn of the circles about their second axis: 7 degrees
  double max_strain_m = 0.02;     ///< how far a centre of rotation may stray
  double min_upper_arm_m = 0.15;  ///< between the centres of elbow and shoulder
  double max_upper_arm_m = 0.5;
};

/// Why no model came out; the operator can mend each by repeating a movement. In the order of the checks.
enum class ArmCalibrationError : std::uint8_t {
  kNoPosture,         ///< no frame of the reference posture
  kSmallFlexion,      ///< the elbow was bent too little, or too few frames show it
  kFlexionNotHinge,   ///< it did not turn about one axis: targets loose, or another movement
  kSmallRotation,     ///< the forearm was turned too little
  kRotationNotHinge,  ///< it did not turn about one axis
  kRotationReversed,  ///< it first turned outward, or the side is the other one
  kSmallCircles,      ///< the arm was swung too little or in a plane only
  kShoulderMoved,     ///< no point stayed: the trunk moved, or targets are loose
  kUpperArmLength,    ///< elbow and shoulder came out too near or too far from each other
};
/// "no_posture", "small_flexion", ...
[[nodiscard]] std::string_view id(ArmCalibrationError error);

/// How good the movements were.
struct ArmCalibrationQuality {
  double flexion_range_rad = 0.0, flexion_across_rad = 0.0;  ///< across: rms about another axis
  double rotation_range_rad = 0.0, rotation_across_rad = 0.0;
  double shoulder_rms_m = 0.0;  ///< straying of the centre
  double upper_arm_m = 0.0;     ///< elbow to shoulder
};

struct CalibratedArm {
  ArmModel model;  ///< names are left empty
  ArmCalibrationQuality quality;
};

/// Finds the bones in the targets from movements alone: the elbow's axis as the mean helical axis of its
/// flexion, the forearm's long axis as that of pro- and supination, the shoulder as the centre of the
/// circles; the humerus' y from elbow to shoulder, its z along the elbow's axis (ISB's second option), the
/// forearm's y along its axis with its x ahead of the elbow's when the rotation began. Sources: Wu et al.
/// 2005; Cutti et al., Med. Biol. Eng. Comput. 46, 2008.
[[nodiscard]] Expected<CalibratedArm, ArmCalibrationError> calibrateArm(
    const ArmMovements& movements, Side side, const ArmCalibrationSettings& settings = {});

}  // namespace mirrorarm::tracking
