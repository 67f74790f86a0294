#include "ui/model/tracking_presenter.h"

#include <algorithm>
#include <numeric>

#include <QStringList>

#include "ui/model/words.h"

namespace mirrorarm::ui {
namespace {

constexpr Seconds kFreshFor{0.150};  // a frame period, its way through vision, and some air
constexpr Seconds kCameraSilentAfter{0.250};
constexpr Seconds kFiguresEvery{0.200};

QString milliseconds(double value) {
  return TrackingPresenter::tr("%1 ms").arg(value, 0, 'f', value < 10.0 ? 1 : 0);
}

void describeTarget(const tracking::TrackedTarget& target, TimePoint now, TrackingState& state) {
  const bool fresh = isFresh(target, now, kFreshFor);
  const bool tracked = fresh && target.status == tracking::TrackStatus::kTracked;
  state.light = tracked ? Light::kGood : fresh ? Light::kWaiting : Light::kBad;
  state.status = fresh ? words(target.status) : words(tracking::TrackStatus::kLost);
  state.detail = words(target.reason);
  state.markers = QStringLiteral("%1 / %2").arg(target.matched_count).arg(target.marker_count);
  if (target.status == tracking::TrackStatus::kTracked)
    state.misfit = TrackingPresenter::tr("%1 mm").arg(target.rms_m * 1e3, 0, 'f', 2);
}

void describeUntaught(const station::TrackedFrame& frame, TrackingState& state) {
  const auto& points = frame.observation.points;
  const auto count = static_cast<int>(std::ranges::count_if(points, &vision::StereoPoint::preferred));
  state.light = Light::kOff;
  state.status = TrackingPresenter::tr("Not taught");
  state.detail = TrackingPresenter::tr("markers in view: %1").arg(count);
  state.markers = QString::number(count);
}

ExposureLine exposureLine(const QString& camera, const vision::Exposure& exposure) {
  if (!exposure.warning) return {false, TrackingPresenter::tr("%1: good light").arg(camera)};
  return {true,
          QStringLiteral("%1: %2 – %3").arg(camera, words(*exposure.warning), advice(*exposure.warning))};
}

QVector<ExposureLine> exposureLines(const vision::Exposure& left, const vision::Exposure& right) {
  if (!left.warning && !right.warning) return {{false, TrackingPresenter::tr("Good light in both images")}};
  return {exposureLine(TrackingPresenter::tr("Left"), left),
          exposureLine(TrackingPresenter::tr("Right"), right)};
}

int refusedCount(const vision::Detection& detection) {
  const auto& counts = detection.rejected;
  const int specks = counts[static_cast<std::size_t>(vision::Rejection::kTooSmall)];
  return std::accumulate(counts.begin(), counts.end(), -specks);
}

/// "Left: 3 too long, 12 too small"; empty when nothing was refused.
QString refusedReasons(const QString& camera, const vision::Detection& detection) {
  QStringList parts;
  for (std::size_t i = 0; i < detection.rejected.size(); ++i)
    if (detection.rejected[i] > 0)
      parts
          << QStringLiteral("%1 %2").arg(detection.rejected[i]).arg(words(static_cast<vision::Rejection>(i)));
  return parts.isEmpty() ? QString() : QStringLiteral("%1: %2").arg(camera, parts.join(QStringLiteral(", ")));
}

void describeImages(const vision::StereoObservation& seen, TrackingState& state) {
  state.exposure = exposureLines(seen.left.exposure, seen.right.exposure);
  state.refused = QString::number(refusedCount(seen.left) + refusedCount(seen.right));
  QStringList lines{refusedReasons(TrackingPresenter::tr("Left"), seen.left),
                    refusedReasons(TrackingPresenter::tr("Right"), seen.right)};
  lines.removeAll(QString());
  state.refused_reasons = lines.join(QLatin1Char('\n'));
}

TrackingState stateOf(const station::TrackedFrame* frame, TimePoint now) {
  TrackingState state;
  state.status = TrackingPresenter::tr("No images");
  state.markers = state.misfit = state.age = state.vision = state.lost_frames = state.refused =
      QStringLiteral("–");
  if (frame == nullptr) return state;
  const Seconds age = now - frame->frame.exposed_at;
  state.age = milliseconds(age.count() * 1e3);
  state.vision = milliseconds(frame->vision_ms + frame->tracking_ms);
  state.lost_frames = QString::number(frame->lost_frames);
  describeImages(frame->observation, state);
  if (age > kCameraSilentAfter) {
    state.light = Light::kBad;
    state.detail = TrackingPresenter::tr("the cameras are silent");
  } else if (frame->targets.empty()) {
    describeUntaught(*frame, state);
  } else {
    describeTarget(frame->targets.front(), now, state);
  }
  return state;
}

}  // namespace

void TrackingPresenter::show(const station::Snapshot& snapshot, TimePoint now) {
  TrackingState next = stateOf(snapshot.frame.get(), now);
  const bool same_light = next.light == state_.light && next.status == state_.status;
  if (same_light && now - figures_at_ < kFiguresEvery) return;
  figures_at_ = now;
  next.accessible = tr("Tracking: %1, markers %2, misfit %3").arg(next.status, next.markers, next.misfit);
  for (const auto& line : next.exposure)
    if (line.warns) next.accessible += QStringLiteral(". ") + line.text;
  if (next == state_) return;
  state_ = std::move(next);
  emit stateChanged(state_);
}

}  // namespace mirrorarm::ui
