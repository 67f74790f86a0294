#pragma once

#include "core/calibration/validity.h"
#include "core/station/equipment.h"

namespace mirrorarm::station {

/// `devices` with the calibrations in force in place of their own, and whether they allow a session.
/// Simulated devices bring exact calibrations and need none in force; once one is, the rules are those of
/// real ones.
[[nodiscard]] Equipment calibrated(Equipment devices, const calibration::InForce& in_force,
                                   const calibration::Validity& validity);

}  // namespace mirrorarm::station
