#pragma once

#include "app/workstation/leaving.h"
#include "app/workstation/workstation_order.h"
#include "core/common/expected.h"
#include "ui/views/theme.h"

namespace mirrorarm::workstation {

/// Opens the bench with the patient, its station and the session's window, and closes them all again. The
/// error is the reason why it could not be opened.
[[nodiscard]] Expected<Leaving, NotOpened> runSession(const WorkstationOrder& order,
                                                      const ui::Themes& themes);

}  // namespace mirrorarm::workstation
