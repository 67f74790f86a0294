#pragma once

#include <string>

namespace mirrorarm::camera {

/// Why an image with so deep pixels is refused, and what to do: their scale only their writer knows.
[[nodiscard]] inline std::string tooDeep(unsigned bits, bool real) {
  return "has " + std::to_string(bits) + (real ? "-bit real" : "-bit") +
         " pixels, not 8-bit ones: convert it, choosing which grey becomes white";
}

}  // namespace mirrorarm::camera
