#pragma once

#include <span>
#include <vector>

#include "ui/report/report_contents.h"

namespace mirrorarm::ui::report {

/// Smallest and largest values of a course, interval by interval; NaN where an interval knows none.
struct Envelope {
  std::vector<double> time_s;  ///< middle of each interval
  std::vector<double> low;
  std::vector<double> high;
};

/// `span` in `intervals` > 0 equal parts. Times and values are equally many; values outside the span or NaN
/// are left out.
[[nodiscard]] Envelope envelopeOf(std::span<const double> time_s, std::span<const double> values,
                                  const TimeSpan& span, int intervals);

}  // namespace mirrorarm::ui::report
