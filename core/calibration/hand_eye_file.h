#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/calibration/hand_eye.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// Where a hand-eye calibration came from; what is unknown is empty or 0.
struct HandEyeNote {
  std::string date;    ///< ISO 8601
  std::string method;  ///< what solved it
  int pairs = 0;       ///< stations used
  double rms_m = 0.0;
  double rms_rad = 0.0;
  std::optional<double> sigma_m;  ///< of the position
};

/// The camera on what carries it.
struct HandEye {
  CameraMount mount = CameraMount::kInHand;
  RigidTransform X_PC = RigidTransform::Identity();  ///< X_FC in the hand, X_BC beside it
  HandEyeNote calibration;
};

/// Reads `hand_eye.yaml` (format mirrorarm/hand-eye/1): exactly one of the keys flange_from_camera (in the
/// hand) and base_from_camera (beside it). Refused with the line and key: what is unknown, missing or not a
/// pose.
[[nodiscard]] FromFile<HandEye> readHandEye(const std::filesystem::path& file);

/// Writes it, whole or not at all.
[[nodiscard]] Expected<void, std::string> writeHandEye(const std::filesystem::path& file,
                                                       const HandEye& hand_eye);

}  // namespace mirrorarm::calibration
