#include "ui/model/tracking_presenter.h"

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
  const auto count = static_cast<int>(frame.observation.points.size());
  state.light = Light::kOff;
  state.status = TrackingPresenter::tr("Not taught");
  state.detail = TrackingPresenter::tr("markers in view: %1").arg(count);
  state.markers = QString::number(count);
}

TrackingState stateOf(const station::TrackedFrame* frame, TimePoint now) {
  TrackingState state;
  state.status = TrackingPresenter::tr("No images");
  state.markers = state.misfit = state.age = state.vision = state.lost_frames = QStringLiteral("–");
  if (frame == nullptr) return state;
  const Seconds age = now - frame->frame.exposed_at;
  state.age = milliseconds(age.count() * 1e3);
  state.vision = milliseconds(frame->vision_ms + frame->tracking_ms);
  state.lost_frames = QString::number(frame->lost_frames);
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
  if (next == state_) return;
  state_ = std::move(next);
  emit stateChanged(state_);
}

}  // namespace mirrorarm::ui
