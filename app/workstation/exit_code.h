#pragma once

namespace mirrorarm::workstation {

/// What the program tells its caller, as mirrorarm-cli does.
enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUse = 2 };

}  // namespace mirrorarm::workstation
