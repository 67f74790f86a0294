#include "ui/model/standing_lines.h"

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

using calibration::Standing;

struct StandingWords {
  Q_DECLARE_TR_FUNCTIONS(StandingLines)
};

constexpr std::chrono::hours kInHoursBelow{48};

QString ageOf(std::chrono::minutes age) {
  if (age < std::chrono::hours(1)) return StandingWords::tr("%1 min old").arg(age.count());
  const auto hours = std::chrono::duration_cast<std::chrono::hours>(age);
  if (hours < kInHoursBelow) return StandingWords::tr("%1 h old").arg(hours.count());
  return StandingWords::tr("%1 days old").arg(hours.count() / 24);
}

}  // namespace

StandingLine standingLine(const calibration::CalibrationStatus& status) {
  switch (status.standing) {
    case Standing::kValid:
      return {Light::kGood, StandingWords::tr("in force, %1").arg(ageOf(status.age))};
    case Standing::kMissing:
      return {Light::kOff, StandingWords::tr("none in force")};
    case Standing::kUndated:
      return {Light::kBad, StandingWords::tr("of unknown age")};
    case Standing::kExpired:
      return {Light::kBad, StandingWords::tr("expired, %1").arg(ageOf(status.age))};
    case Standing::kDoubtful:
      return {Light::kWaiting, StandingWords::tr("doubtful, %1").arg(ageOf(status.age))};
    case Standing::kFailed:
      return {Light::kBad, StandingWords::tr("failed, %1").arg(ageOf(status.age))};
  }
  return {};
}

calibration::CalibrationKind kindOf(station::CalibrationJob job) {
  switch (job) {
    case station::CalibrationJob::kStereo:
      return calibration::CalibrationKind::kRig;
    case station::CalibrationJob::kHandEye:
      return calibration::CalibrationKind::kHandEye;
    case station::CalibrationJob::kClock:
      return calibration::CalibrationKind::kClock;
    case station::CalibrationJob::kDrift:
      return calibration::CalibrationKind::kDrift;
  }
  return calibration::CalibrationKind::kRig;
}

StandingLines standingLines(const calibration::Validity& validity) {
  StandingLines lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = standingLine(validity.of(kindOf(static_cast<station::CalibrationJob>(i))));
  return lines;
}

}  // namespace mirrorarm::ui
