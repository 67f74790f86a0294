#include "core/station/calibrated_equipment.h"

namespace mirrorarm::station {

Equipment calibrated(Equipment devices, const calibration::InForce& in_force,
                     const calibration::Validity& validity) {
  if (in_force.empty() && devices.simulated) return devices;
  const bool in_hand = in_force.hand_eye && in_force.hand_eye->mount == calibration::CameraMount::kInHand;
  devices.calibration_holds = in_hand && validity.allowsSession();
  if (in_force.rig) devices.rig = *in_force.rig;
  if (in_hand) devices.X_FC = in_force.hand_eye->X_PC;
  if (in_force.clock) devices.clock_offset = Seconds(in_force.clock->offset_s);
  return devices;
}

}  // namespace mirrorarm::station
