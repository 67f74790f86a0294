#include "ui/report/course_envelope.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace mirrorarm::ui::report {

Envelope envelopeOf(std::span<const double> time_s, std::span<const double> values, const TimeSpan& span,
                    int intervals) {
  assert(time_s.size() == values.size() && intervals > 0 && span.to_s > span.from_s);
  const double width_s = (span.to_s - span.from_s) / intervals;
  const std::vector<double> unknown(static_cast<std::size_t>(intervals),
                                    std::numeric_limits<double>::quiet_NaN());
  Envelope envelope{unknown, unknown, unknown};
  for (int i = 0; i < intervals; ++i)
    envelope.time_s[static_cast<std::size_t>(i)] = span.from_s + (i + 0.5) * width_s;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i]) || time_s[i] < span.from_s || time_s[i] > span.to_s) continue;
    const int last = intervals - 1;
    const auto at =
        static_cast<std::size_t>(std::min(static_cast<int>((time_s[i] - span.from_s) / width_s), last));
    // fmin and fmax take the number where the other is NaN.
    envelope.low[at] = std::fmin(envelope.low[at], values[i]);
    envelope.high[at] = std::fmax(envelope.high[at], values[i]);
  }
  return envelope;
}

}  // namespace mirrorarm::ui::report
