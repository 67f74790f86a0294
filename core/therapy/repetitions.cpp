#include "core/therapy/repetitions.h"

#include <algorithm>

namespace mirrorarm::therapy {

int countRepetitions(std::span<const double> excursion, double least_range) {
  if (excursion.empty()) return 0;
  const double range = std::ranges::max(excursion);
  if (range < least_range) return 0;
  int repetitions = 0;
  bool is_out = false;
  for (const double distance : excursion) {
    if (!is_out && distance > 0.7 * range) {
      is_out = true;
    } else if (is_out && distance < 0.3 * range) {
      is_out = false;
      ++repetitions;
    }
  }
  return repetitions;
}

}  // namespace mirrorarm::therapy
