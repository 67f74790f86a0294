#pragma once

#include <string>

#include "app/workstation/exit_code.h"

namespace mirrorarm::workstation {

/// What the workstation opens; one after another, for they share the devices.
enum class Room { kNone, kSession, kCalibration };

/// How a room was left.
struct Leaving {
  int exit_code = kDone;
  Room next = Room::kNone;
  bool dark = false;  ///< the theme that the next room takes over
};

/// Why a room could not be opened.
struct NotOpened {
  std::string reason;
  ExitCode exit_code = kWrongUse;
};

}  // namespace mirrorarm::workstation
