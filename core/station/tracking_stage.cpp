#include "core/station/tracking_stage.h"

#include <algorithm>

#include "core/common/log.h"

namespace mirrorarm::station {
namespace {

constexpr std::string_view kTargetName = "forearm";
/// Around a tracked marker's predicted place: more than an arm moves between two frames.
constexpr double kLookAheadRadius_m = 0.04;

double radiusOf(const tracking::Target& target) {
  double radius_m = 0.0;
  for (const auto& marker_T : target.markers_T) radius_m = std::max(radius_m, marker_T.norm());
  return radius_m;
}

double millisecondsSince(TimePoint start) { return 1e3 * secondsBetween(start, Clock::now()); }

}  // namespace

TrackingStage::TrackingStage(const camera::StereoRig& rig, const StationSettings& settings)
    : teacher_settings_(settings.teacher),
      vision_(rig, settings.finder, settings.matcher),
      tracker_(settings.tracker) {
  expected_C_.reserve(tracking::kMaxMarkers);
  tracker_.setRig(rig);
}

FrameReport TrackingStage::process(const camera::StereoFrame& frame) {
  if (last_sequence_ && frame.sequence > *last_sequence_ + 1)
    lost_frames_ += frame.sequence - *last_sequence_ - 1;
  last_sequence_ = frame.sequence;
  obeyOrders();

  seen_ = std::make_shared<TrackedFrame>();
  seen_->frame = frame;
  seen_->lost_frames = lost_frames_;
  const auto vision_start = Clock::now();
  seen_->observation = vision_.observe(frame);
  seen_->vision_ms = millisecondsSince(vision_start);

  const auto tracking_start = Clock::now();
  if (lesson_) learn();
  if (target_) track();
  seen_->tracking_ms = millisecondsSince(tracking_start);
  return report();
}

void TrackingStage::settle() {
  if (target_) noteSkin();
  seen_->target = target_;
  seen_->reteachings = target_ ? tracker_.version(0) : 0;
  seen_->skin_events = skin_events_;
  lookAhead();
  for_screen.put(std::move(seen_));
}

void TrackingStage::obeyOrders() {
  while (const auto order = orders_.pop()) {
    switch (*order) {
      case Order::kBeginLesson:
        lesson_.emplace(teacher_settings_);
        break;
      case Order::kEndLesson:
        endLesson();
        break;
      case Order::kForget:
        lesson_.reset();
        target_.reset();
        skin_events_ = {};
        break;
    }
  }
}

void TrackingStage::endLesson() {
  if (!lesson_) return;
  const auto taught = lesson_->finish(kTargetName);
  lesson_.reset();
  ++teachings_;
  teaching_error_.reset();
  if (!taught) {
    teaching_error_ = taught.error();
    return;
  }
  target_ = std::make_shared<const tracking::Target>(taught->target);
  tracker_.setTargets({target_.get(), 1});
  version_ = 0;
  skin_events_ = {};
}

void TrackingStage::learn() {
  tracking::collectCloud(seen_->observation.points, lesson_cloud_);
  lesson_->add(lesson_cloud_);
  if (lesson_->isDone()) endLesson();
}

void TrackingStage::track() {
  const auto tracked = tracker_.track(seen_->observation.points, seen_->frame.exposed_at);
  seen_->targets.assign(tracked.begin(), tracked.end());
}

void TrackingStage::noteSkin() {
  tracker_.learn();
  const auto event = tracker_.event(0);
  ++skin_events_[static_cast<std::size_t>(event)];
  if (event != tracking::SkinEvent::kNone)
    log(LogLevel::kWarning, "tracking: skin: " + std::string(id(event)));
  if (tracker_.version(0) == version_) return;
  version_ = tracker_.version(0);
  target_ = std::make_shared<const tracking::Target>(tracker_.target(0));
}

// Search only where the taught markers are expected, hidden ones too; a lost target may be anywhere.
void TrackingStage::lookAhead() {
  expected_C_.clear();
  const auto& targets = seen_->targets;
  if (!lesson_ && !targets.empty() && targets.front().status == tracking::TrackStatus::kTracked)
    for (const auto& marker_T : target_->markers_T) expected_C_.push_back(targets.front().X_CT * marker_T);
  vision_.expect(expected_C_, kLookAheadRadius_m);
}

FrameReport TrackingStage::report() const {
  FrameReport report;
  report.exposed_at = seen_->frame.exposed_at;
  report.sequence = seen_->frame.sequence;
  report.has_target = target_ != nullptr;
  if (target_) report.target_radius_m = radiusOf(*target_);
  if (!seen_->targets.empty()) report.target = seen_->targets.front();
  report.taught_markers = lesson_ ? lesson_->markers() : 0;
  report.taught_sigma_m = lesson_ ? lesson_->sigma_m() : 0.0;
  report.teachings = teachings_;
  report.teaching_error = teaching_error_;
  return report;
}

}  // namespace mirrorarm::station
