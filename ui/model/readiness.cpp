#include "ui/model/readiness.h"

#include <algorithm>

#include <QCoreApplication>

#include "ui/model/calibration_words.h"
#include "ui/model/standing_lines.h"

namespace mirrorarm::ui {
namespace {

struct Readiness {
  Q_DECLARE_TR_FUNCTIONS(Readiness)
};

constexpr Seconds kFreshFor{0.5};
constexpr int kFewestMarkers = 3;

QVector<Check> exactCalibration(const std::string& date) {
  const QString text = date.empty() ? Readiness::tr("Calibration without a date")
                                    : Readiness::tr("Calibrated %1").arg(QString::fromStdString(date));
  return {{text, !date.empty()}};
}

/// Lenses and hand-eye in any case, the others where they do not hold: a clock offset may be missing.
QVector<Check> calibrationsInForce(const calibration::Validity& validity) {
  using calibration::CalibrationKind;
  const auto lines = standingLines(validity);
  QVector<Check> checks;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto job = static_cast<station::CalibrationJob>(i);
    const auto kind = kindOf(job);
    const bool holds = lines[i].light == Light::kGood;
    const bool missing = lines[i].light == Light::kOff;
    const bool always = kind == CalibrationKind::kRig || kind == CalibrationKind::kHandEye;
    if (kind == CalibrationKind::kClock && missing) continue;
    if (kind == CalibrationKind::kDrift && missing)
      checks.push_back({Readiness::tr("Calibrations not checked today"), false});
    else if (always || !holds)
      checks.push_back({QStringLiteral("%1: %2").arg(words(job), lines[i].text), holds});
  }
  return checks;
}

}  // namespace

QVector<Check> readinessOf(const station::Snapshot& snapshot, const Workplace& workplace, TimePoint now) {
  const auto* frame = snapshot.frame.get();
  const auto& robot = snapshot.control.servo.measured;
  const int markers = frame != nullptr ? static_cast<int>(std::ranges::count_if(
                                             frame->observation.points, &vision::StereoPoint::preferred))
                                       : 0;
  const bool images = frame != nullptr && now - frame->frame.exposed_at < kFreshFor;
  const bool answers =
      robot.q_rad.size() == workplace.arm.jointCount() && now - robot.measured_at < kFreshFor;
  QVector<Check> checks{
      {Readiness::tr("Cameras deliver images"), images},
      {Readiness::tr("Robot answers and rests"), answers && snapshot.control.servo.at_rest}};
  checks += workplace.calibrations ? calibrationsInForce(*workplace.calibrations)
                                   : exactCalibration(workplace.rig.calibration.date);
  checks.push_back({Readiness::tr("Markers in view: %1").arg(markers), markers >= kFewestMarkers});
  return checks;
}

}  // namespace mirrorarm::ui
