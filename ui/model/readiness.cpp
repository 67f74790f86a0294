#include "ui/model/readiness.h"

#include <algorithm>

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

struct Readiness {
  Q_DECLARE_TR_FUNCTIONS(Readiness)
};

constexpr Seconds kFreshFor{0.5};
constexpr int kFewestMarkers = 3;

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
  const auto& calibrated = workplace.rig.calibration.date;
  return {{Readiness::tr("Cameras deliver images"), images},
          {Readiness::tr("Robot answers and rests"), answers && snapshot.control.servo.at_rest},
          {calibrated.empty() ? Readiness::tr("Calibration without a date")
                              : Readiness::tr("Calibrated %1").arg(QString::fromStdString(calibrated)),
           !calibrated.empty()},
          {Readiness::tr("Markers in view: %1").arg(markers), markers >= kFewestMarkers}};
}

}  // namespace mirrorarm::ui
