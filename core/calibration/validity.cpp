#include "core/calibration/validity.h"

#include "core/common/calendar.h"

namespace mirrorarm::calibration {
namespace {

/// Clocks of two computers may differ by that.
constexpr std::chrono::minutes kClockTolerance{5};

CalibrationStatus statusOf(const std::string& date, std::chrono::system_clock::time_point now,
                           std::chrono::hours limit) {
  CalibrationStatus status{Standing::kUndated, date, std::chrono::minutes(0)};
  const auto then = timeOfIsoUtc(date);
  if (!then || *then > now + kClockTolerance) return status;
  status.age =
      std::max(std::chrono::minutes(0), std::chrono::duration_cast<std::chrono::minutes>(now - *then));
  status.standing = status.age > limit ? Standing::kExpired : Standing::kValid;
  return status;
}

CalibrationStatus driftStatus(const DriftRecord& drift, std::chrono::system_clock::time_point now,
                              std::chrono::hours limit) {
  auto status = statusOf(drift.date, now, limit);
  if (drift.findings.verdict == DriftVerdict::kFailed) status.standing = Standing::kFailed;
  if (drift.findings.verdict == DriftVerdict::kDoubtful && status.standing == Standing::kValid)
    status.standing = Standing::kDoubtful;
  return status;
}

}  // namespace

std::string_view id(Standing standing) {
  constexpr std::array<std::string_view, 6> kIds = {"valid",   "missing",  "undated",
                                                    "expired", "doubtful", "failed"};
  return kIds[static_cast<std::size_t>(standing)];
}

bool Validity::allowsSession() const {
  const auto is = [this](CalibrationKind kind, Standing standing) { return of(kind).standing == standing; };
  return is(CalibrationKind::kRig, Standing::kValid) && is(CalibrationKind::kHandEye, Standing::kValid) &&
         (is(CalibrationKind::kClock, Standing::kValid) || is(CalibrationKind::kClock, Standing::kMissing)) &&
         (is(CalibrationKind::kDrift, Standing::kValid) || is(CalibrationKind::kDrift, Standing::kDoubtful));
}

Validity validityOf(const InForce& in_force, std::chrono::system_clock::time_point now,
                    const ValidityLimits& limits) {
  Validity validity;
  auto& [rig, hand_eye, clock, drift] = validity.status;
  if (in_force.rig) rig = statusOf(in_force.rig->calibration.date, now, limits.rig);
  if (in_force.hand_eye) hand_eye = statusOf(in_force.hand_eye->calibration.date, now, limits.hand_eye);
  if (in_force.clock) clock = statusOf(in_force.clock->date, now, limits.clock);
  if (in_force.drift) drift = driftStatus(*in_force.drift, now, limits.drift);
  return validity;
}

}  // namespace mirrorarm::calibration
