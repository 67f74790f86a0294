#pragma once

#include <memory>
#include <optional>

#include "core/camera/stereo_rig.h"
#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/station/frame_report.h"
#include "core/station/snapshot.h"
#include "core/station/station_settings.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::station {

/// From a stereo frame to tracked targets, with teaching and re-teaching. process() belongs to the tracking
/// thread.
class TrackingStage {
 public:
  TrackingStage(const camera::StereoRig& rig, const StationSettings& settings);

  /// One frame: seen, taught from while a lesson runs, tracked; the whole of it goes to `for_screen`.
  FrameReport process(const camera::StereoFrame& frame);

  /// Orders are obeyed at the next frame. Any thread; false when too many wait.
  enum class Order { kBeginLesson, kEndLesson, kForget };
  [[nodiscard]] bool order(Order order) noexcept { return orders_.push(order); }

  LatestValue<std::shared_ptr<const TrackedFrame>> for_screen;  ///< taken by the screen's thread only

 private:
  void obeyOrders();
  void endLesson();
  void learn(const TrackedFrame& seen);
  void track(TrackedFrame& seen);
  void reteach(const TrackedFrame& seen);
  void lookAhead(const TrackedFrame& seen);
  [[nodiscard]] FrameReport reportOf(const TrackedFrame& seen) const;

  const tracking::TeacherSettings teacher_settings_;
  const tracking::TrackerSettings tracker_settings_;
  BoundedQueue<Order, 16> orders_;
  vision::StereoVision vision_;
  tracking::Tracker tracker_;
  std::optional<tracking::Teacher> lesson_;
  std::shared_ptr<const tracking::Target> target_;
  tracking::TrackedTarget last_tracked_;
  std::vector<Eigen::Vector3d> cloud_C_;
  std::optional<std::uint64_t> last_sequence_;
  std::uint64_t lost_frames_ = 0;
  int teachings_ = 0;
  int reteachings_ = 0;
  std::optional<tracking::TeachingError> teaching_error_;
};

}  // namespace mirrorarm::station
