#pragma once

#include "app/workstation/workstation_order.h"

namespace mirrorarm::workstation {

/// Opens the workstation and gives the program's exit code: 0 done, 2 wrong input, 1 where the tour or the
/// station failed; one line on standard error says why.
[[nodiscard]] int runWorkstation(const WorkstationOrder& order, int argc, char** argv);

}  // namespace mirrorarm::workstation
