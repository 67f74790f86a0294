#pragma once

#include <optional>
#include <variant>

#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/control/arm_delay.h"
#include "core/control/follower.h"
#include "core/control/gaze.h"
#include "core/control/servo_loop.h"
#include "core/station/equipment.h"
#include "core/station/frame_report.h"
#include "core/station/recorder_stage.h"
#include "core/station/servo_digest.h"
#include "core/station/snapshot.h"
#include "core/station/station_settings.h"
#include "core/station/stop_log.h"
#include "core/station/tracking_stage.h"
#include "core/therapy/movement_mapping.h"
#include "core/tracking/motion_predictor.h"

namespace mirrorarm::station {

/// The session's mind: takes commands and frame reports, keeps the phase, turns target poses into goals and
/// goals into trajectories, samples for the record. step() belongs to the control thread.
class ControlStage {
 public:
  ControlStage(const Equipment& equipment, const StationSettings& settings, const robot::MotionLimits& limits,
               control::ServoLoop& servo, control::PlanningDesk& desk, TrackingStage& tracking,
               RecorderStage& recorder);

  /// Any thread.
  [[nodiscard]] Answer request(const Command& command) noexcept {
    return wishes_.push(command) ? Answer::kAccepted : Answer::kQueueFull;
  }
  [[nodiscard]] Answer changeHelp(const control::Help& help) noexcept {
    return wishes_.push(help) ? Answer::kAccepted : Answer::kQueueFull;
  }
  /// Tracking thread.
  void report(const FrameReport& report) noexcept;

  /// At every frame report, so that the robot learns of it at once, and a few times in between.
  void step(TimePoint now);
  /// After the last step: what is still to be kept is handed to the recorder.
  void end();

  LatestValue<ControlState> for_screen;  ///< taken by the screen's thread only

 private:
  void drainServo();
  void noteStop(const StopNews& news);
  void takeReports();
  void takeReport(const FrameReport& report);
  void endTeaching(const FrameReport& report);
  void sample(const FrameReport& report, TimePoint exposed_at, const RigidTransform& X_BF);
  void obeyWishes();
  void take(const Command& command);
  void take(const control::Help& help);
  [[nodiscard]] Answer obey(const Command& command);
  [[nodiscard]] Answer change(const control::Help& help);
  [[nodiscard]] Answer align(therapy::Mapping mapping);
  [[nodiscard]] Answer start();
  void pause();
  void answer(Answer given);
  void noteTarget(const FrameReport& report, TimePoint exposed_at, const RigidTransform& X_BF);
  void follow();
  void obey(const control::FollowStep& step);
  [[nodiscard]] control::Sight sight() const;
  [[nodiscard]] control::ToolGoal goalAt(TimePoint time) const;
  void tellServo();
  void publish();
  [[nodiscard]] bool stopLatched() const;
  [[nodiscard]] double sessionTime(TimePoint time) const;
  void recordEvent(std::string_view event);
  void recordHelp();

  const RigidTransform X_FC_;
  const RigidTransform X_FE_;
  const Clock::duration clock_offset_;  ///< of the robot's clock against the cameras'
  const bool calibration_holds_;
  const Eigen::Vector3d midplane_normal_B_;
  const Seconds fresh_for_;
  const Seconds handover_;
  control::ServoLoop& servo_;
  control::PlanningDesk& desk_;
  TrackingStage& tracking_;
  RecorderStage& recorder_;
  control::Follower follower_;
  control::Gaze gaze_;
  ServoDigest digest_;
  BoundedQueue<std::variant<Command, control::Help>, 16> wishes_;
  BoundedQueue<FrameReport, 64> reports_;
  std::atomic<std::uint64_t> lost_reports_{0};

  // Control thread only.
  TimePoint now_{};
  ControlState state_;
  therapy::Alignment alignment_;
  therapy::Mapping mapping_ = therapy::Mapping::kFollow;
  tracking::TrackedTarget target_;
  control::ServoLoop::Tracking seen_;
  tracking::MotionPredictor target_motion_;  ///< of the target in base, tracked poses only
  control::ArmDelay arm_delay_;
  bool target_moved_on_ = false;  ///< a tracked pose came since the last step
  double target_radius_m_ = 0.0;
  std::optional<RigidTransform> X_BE_at_target_;  ///< end effector when the target was last seen
  std::optional<TimePoint> session_start_;
  StopLog stops_;
  int teachings_ = 0;
};

}  // namespace mirrorarm::station
