#include "ui/model/capture_lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <QCoreApplication>

namespace mirrorarm::ui {
namespace {

using calibration::CaptureVerdict;
using calibration::Coverage;
using station::CalibrationJob;

struct CaptureLights {
  Q_DECLARE_TR_FUNCTIONS(CaptureLights)
};

constexpr double kGoodShare = 0.7;

QString percent(double share) {
  return CaptureLights::tr("%1 %").arg(static_cast<int>(std::lround(100.0 * share)));
}

Light lightOf(double share) { return share >= kGoodShare ? Light::kGood : Light::kWaiting; }

QualityLight seenBy(const QString& text, const station::BoardFrame* frame, std::size_t camera,
                    std::size_t points) {
  if (frame == nullptr) return {Light::kOff, text, {}};
  const std::size_t seen = frame->view.seen[camera].size();
  return {seen > 0 ? Light::kGood : Light::kBad, text, CaptureLights::tr("%1 of %2").arg(seen).arg(points)};
}

/// Good once the verdict has got beyond `fault`, waiting while that is what is wrong, off before.
Light beyond(const station::BoardFrame* frame, CaptureVerdict fault) {
  if (frame == nullptr || frame->verdict < fault) return Light::kOff;
  return frame->verdict == fault ? Light::kWaiting : Light::kGood;
}

QualityLight enoughViews(const station::CalibrationSnapshot& snapshot) {
  const std::size_t taken = snapshot.views ? snapshot.views->size() : 0;
  return {taken >= snapshot.views_wanted ? Light::kGood : Light::kWaiting, CaptureLights::tr("Enough views"),
          CaptureLights::tr("%1 of %2").arg(taken).arg(snapshot.views_wanted)};
}

QualityLight spreadOverImages(const Coverage& coverage) {
  const double share = std::min(coverage.imageShare(0), coverage.imageShare(1));
  return {lightOf(share), CaptureLights::tr("Spread over both images"), percent(share)};
}

QualityLight tilts(const Coverage& coverage) {
  const auto holds = [](const auto& row) { return std::accumulate(row.begin(), row.end(), 0) > 0; };
  const auto held = std::ranges::count_if(coverage.pose, holds);
  return {held + 1 >= Coverage::kTilts ? Light::kGood : Light::kWaiting, CaptureLights::tr("Tilts"),
          CaptureLights::tr("%1 of %2").arg(held).arg(Coverage::kTilts)};
}

QualityLight distances(const Coverage& coverage) {
  int held = 0;
  for (std::size_t column = 0; column < Coverage::kDistances; ++column)
    held += std::ranges::any_of(coverage.pose, [column](const auto& row) { return row[column] > 0; }) ? 1 : 0;
  return {held + 1 >= Coverage::kDistances ? Light::kGood : Light::kWaiting, CaptureLights::tr("Distances"),
          CaptureLights::tr("%1 of %2").arg(held).arg(Coverage::kDistances)};
}

QVector<QualityLight> movementLights(const station::CalibrationSnapshot& snapshot) {
  return {{snapshot.progress >= 1.0 ? Light::kGood : Light::kWaiting, CaptureLights::tr("Enough movement"),
           percent(std::clamp(snapshot.progress, 0.0, 1.0))}};
}

QVector<QualityLight> viewLights(const station::CalibrationSnapshot& snapshot) {
  const auto* frame = snapshot.frame.get();
  QVector<QualityLight> lights{{beyond(frame, CaptureVerdict::kMoving), CaptureLights::tr("Held still"), {}},
                               {beyond(frame, CaptureVerdict::kNotNew), CaptureLights::tr("A new view"), {}},
                               enoughViews(snapshot)};
  if (snapshot.job == CalibrationJob::kStereo) lights << spreadOverImages(snapshot.coverage);
  if (snapshot.job != CalibrationJob::kDrift) lights << tilts(snapshot.coverage);
  if (snapshot.job == CalibrationJob::kStereo) lights << distances(snapshot.coverage);
  return lights;
}

}  // namespace

QVector<QualityLight> captureLights(const station::CalibrationSnapshot& snapshot) {
  const auto* frame = snapshot.frame.get();
  const std::size_t points = calibration::boardPoints(snapshot.board).size();
  QVector<QualityLight> lights{seenBy(CaptureLights::tr("Seen by the left camera"), frame, 0, points),
                               seenBy(CaptureLights::tr("Seen by the right camera"), frame, 1, points)};
  lights += snapshot.job == CalibrationJob::kClock ? movementLights(snapshot) : viewLights(snapshot);
  return lights;
}

}  // namespace mirrorarm::ui
