#include "core/devices/replayed_frames.h"

#include <algorithm>
#include <vector>

#include "core/common/wait_until.h"

namespace mirrorarm::devices {
namespace {

double rateOf(const Recording& recording) {
  if (recording.size() < 2) return 0.0;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < recording.size(); ++i)
    intervals.push_back(secondsBetween(recording.exposedAt(i - 1), recording.exposedAt(i)));
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>((intervals.size() - 1) / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return 1.0 / *middle;
}

}  // namespace

ReplayedFrames::ReplayedFrames(Recording recording, Pace pace, const TimeSource& time)
    : recording_(std::move(recording)), pace_(pace), time_(time), rate_hz_(rateOf(recording_)) {}

Expected<camera::StereoFrame, camera::NoFrame> ReplayedFrames::next(Seconds timeout) {
  if (failure_) return unexpected(camera::NoFrame::kFailed);
  if (next_ == recording_.size()) return unexpected(camera::NoFrame::kEnded);
  TimePoint exposed_at = recording_.exposedAt(next_);
  if (pace_ == Pace::kRecorded) {
    if (!shift_) shift_ = time_.now() - exposed_at;
    exposed_at += *shift_;
    if (!waitUntil(time_, exposed_at, timeout)) return unexpected(camera::NoFrame::kTimeout);
  }
  auto frame = recording_.frame(next_);
  if (!frame) {
    failure_ = frame.error();
    return unexpected(camera::NoFrame::kFailed);
  }
  ++next_;
  frame->exposed_at = exposed_at;
  return std::move(*frame);
}

}  // namespace mirrorarm::devices
