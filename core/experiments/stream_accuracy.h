#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "core/calibration/clock_offset.h"
#include "core/common/expected.h"

namespace mirrorarm::experiments {

/// The accuracy experiment on recorded poses: a robot that carries the cameras stands still at many places,
/// an object lies still.
struct StreamAccuracy {
  Eigen::Vector3d std_mm =
      Eigen::Vector3d::Zero();  ///< of the object's place along the axes of the truth's base
  double rms_mm = 0.0;          ///< distance from its mean place
  double turn_rms_deg = 0.0;
  std::size_t standstills = 0;
  std::size_t poses = 0;         ///< of the camera, at those standstills
  double clock_offset_s = 0.0;   ///< added to the camera's times
  bool solved_hand_eye = false;  ///< X_FC was solved from the same streams
};

/// `truth`: the robot's flange, or the tool of a second tracker that is fixed to the camera; `camera`: the
/// object as tracked, X_CT. Without `X_FC`, as for a second tracker, camera place and clocks are solved from
/// the two streams first. Poses count where the truth moved by less than 0.1 mm within 0.1 s before and
/// after; the mean of a standstill's poses stands for it. At least 8 standstills. The error says what is
/// missing.
[[nodiscard]] Expected<StreamAccuracy, std::string> accuracyOfStreams(
    std::span<const calibration::TimedPose> truth, std::span<const calibration::TimedPose> camera,
    const std::optional<RigidTransform>& X_FC);

}  // namespace mirrorarm::experiments
