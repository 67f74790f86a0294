#pragma once

#include <string>
#include <vector>

namespace mirrorarm::cli {

/// One thing that this machine has or lacks.
struct MachineCheck {
  std::string name;  ///< the key in the JSON object: "display", "memory", ..
  bool ok = false;
  std::string why;  ///< what was found, and what to do where it is not enough
};

/// Looks at everything that the workstation and the pipeline stand on. Leaves
/// nothing behind.
[[nodiscard]] std::vector<MachineCheck> checkMachine();

}  // namespace mirrorarm::cli
