#include "core/station/known_calibrations.h"

namespace mirrorarm::station {

KnownCalibrations knownFrom(const Equipment& equipment, const calibration::InForce& in_force) {
  KnownCalibrations known;
  known.rig_in_force = in_force.rig.has_value();
  if (in_force.rig)
    known.rig = in_force.rig;
  else if (equipment.rig.left.intrinsics().width_px > 0)
    known.rig = equipment.rig;
  known.hand_eye_in_force =
      in_force.hand_eye && in_force.hand_eye->mount == calibration::CameraMount::kInHand;
  known.X_FC = known.hand_eye_in_force ? in_force.hand_eye->X_PC : equipment.X_FC;
  known.clock_offset = in_force.clock ? Seconds(in_force.clock->offset_s) : equipment.clock_offset;
  return known;
}

}  // namespace mirrorarm::station
