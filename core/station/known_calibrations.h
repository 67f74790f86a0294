#pragma once

#include <optional>

#include "core/calibration/calibration_folder.h"
#include "core/station/equipment.h"

namespace mirrorarm::station {

/// What a calibration job starts from: what is in force, and where nothing is what the equipment is built to.
struct KnownCalibrations {
  std::optional<camera::StereoRig> rig;  ///< nothing: not even from a data sheet
  RigidTransform X_FC = RigidTransform::Identity();
  Seconds clock_offset{0.0};
  bool rig_in_force = false;
  bool hand_eye_in_force = false;
};

[[nodiscard]] KnownCalibrations knownFrom(const Equipment& equipment, const calibration::InForce& in_force);

}  // namespace mirrorarm::station
