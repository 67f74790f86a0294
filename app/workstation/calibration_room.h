#pragma once

#include "app/workstation/leaving.h"
#include "app/workstation/workstation_order.h"
#include "core/common/expected.h"
#include "ui/views/theme.h"

namespace mirrorarm::workstation {

/// Opens the bench with the calibration plate, its station and the wizards' window, and closes them all
/// again. The error is the reason why it could not be opened.
[[nodiscard]] Expected<Leaving, NotOpened> runCalibration(const WorkstationOrder& order,
                                                          const ui::Themes& themes);

}  // namespace mirrorarm::workstation
