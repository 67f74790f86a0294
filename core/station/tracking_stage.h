#pragma once

#include <array>
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

/// From a stereo frame to tracked targets, with teaching and what the skin does to what was taught. process()
/// belongs to the tracking thread.
class TrackingStage {
 public:
  TrackingStage(const camera::StereoRig& rig, const StationSettings& settings);

  /// One frame: seen, taught from while a lesson runs, tracked. settle() must follow.
  FrameReport process(const camera::StereoFrame& frame);
  /// What can wait until the report is on its way: the skin is learnt from the frame, the next one is
  /// prepared, the whole of this one goes to `for_screen`.
  void settle();

  /// Orders are obeyed at the next frame. Any thread; false when too many wait.
  enum class Order { kBeginLesson, kEndLesson, kForget };
  [[nodiscard]] bool order(Order order) noexcept { return orders_.push(order); }

  LatestValue<std::shared_ptr<const TrackedFrame>> for_screen;  ///< taken by the screen's thread only

 private:
  void obeyOrders();
  void endLesson();
  void learn();
  void track();
  void noteSkin();
  void lookAhead();
  [[nodiscard]] FrameReport report() const;

  const tracking::TeacherSettings teacher_settings_;
  BoundedQueue<Order, 16> orders_;
  vision::StereoVision vision_;
  tracking::Tracker tracker_;
  std::optional<tracking::Teacher> lesson_;
  std::shared_ptr<TrackedFrame> seen_;  ///< the frame being processed
  std::shared_ptr<const tracking::Target> target_;
  std::vector<tracking::CloudPoint> lesson_cloud_;
  std::vector<Eigen::Vector3d> expected_C_;  ///< where the markers should be in the next frame
  std::optional<std::uint64_t> last_sequence_;
  std::uint64_t lost_frames_ = 0;
  int teachings_ = 0;
  int version_ = 0;  ///< of the tracker's model that target_ holds
  std::array<int, tracking::kSkinEventCount> skin_events_{};
  std::optional<tracking::TeachingError> teaching_error_;
};

}  // namespace mirrorarm::station
