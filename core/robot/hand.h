#pragma once

#include <filesystem>
#include <vector>

#include "core/common/file_error.h"
#include "core/robot/arm_description.h"

namespace mirrorarm::robot {

/// What is screwed to an arm's flange: the stereo camera on its bar and the sling. Nominal, as constructed;
/// the hand-eye calibration says better where the camera is.
struct Hand {
  RigidTransform X_FC = RigidTransform::Identity();  ///< left camera
  RigidTransform X_FE = RigidTransform::Identity();  ///< sling
  /// Their shapes, in the flange's frame; `link` is of no meaning yet.
  std::vector<Capsule> shapes_F;
};

/// Reads a file of the format mirrorarm/hand/1 (docs/formats-own.md).
[[nodiscard]] FromFile<Hand> readHand(const std::filesystem::path& file);

/// The hand's shapes as shapes of the arm's last link.
[[nodiscard]] std::vector<Capsule> attachedTo(const ArmDescription& arm, const Hand& hand);

}  // namespace mirrorarm::robot
