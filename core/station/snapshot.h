#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/camera/stereo_frame.h"
#include "core/control/follower.h"
#include "core/control/servo_loop.h"
#include "core/station/command.h"
#include "core/therapy/session_measures.h"
#include "core/therapy/session_phase.h"
#include "core/tracking/skin_event.h"
#include "core/tracking/target.h"
#include "core/tracking/tracked_target.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::station {

/// What the tracking thread says of one frame: images, markers, targets. Made once, shared, never changed.
struct TrackedFrame {
  camera::StereoFrame frame;
  vision::StereoObservation observation;
  std::vector<tracking::TrackedTarget> targets;    ///< empty before a target is taught
  std::shared_ptr<const tracking::Target> target;  ///< the taught model; nullptr before
  double vision_ms = 0.0;                          ///< from images to points
  double tracking_ms = 0.0;                        ///< from points to poses
  std::uint64_t lost_frames = 0;  ///< by the source or because tracking was busy, since the start
  int reteachings = 0;            ///< how often the model was taught anew in this session
  /// How often the target's skin showed what, in this session: indexed by tracking::SkinEvent.
  std::array<int, tracking::kSkinEventCount> skin_events{};
};

/// What the control thread says at one time.
struct ControlState {
  TimePoint time{};
  therapy::Phase phase = therapy::Phase::kPrepare;
  control::ServoState servo;
  control::Help help;  ///< as it is wanted; servo.assist says how it is
  control::FollowOutcome follow = control::FollowOutcome::kHeld;
  std::optional<robot::Contact>
      contact;               ///< what stands in the way, where following is blocked and it is known
  bool gaze_kept = false;    ///< the goal would have lost the target: the arm stays behind it
  double follow_ms = 0.0;    ///< that the newest goal took, from the target's pose to a checked motion
  double arm_delay_s = 0.0;  ///< by which the arm trails its commands, as measured; 0 before it moved
  RigidTransform X_BF = RigidTransform::Identity();       ///< flange, measured
  RigidTransform X_BT = RigidTransform::Identity();       ///< target in base, good while `target_fresh`
  RigidTransform X_BE_goal = RigidTransform::Identity();  ///< good while `has_goal`
  bool target_fresh = false;
  bool has_goal = false;
  robot::Trajectory trajectory;            ///< in force, for drawing
  double session_s = 0.0;                  ///< since the session began, 0 before
  Answer last_answer = Answer::kAccepted;  ///< to the newest command taken from the queue
  std::uint32_t answers = 0;               ///< commands answered since the start
  int taught_markers = 0;                  ///< while teaching: markers so far
  double taught_sigma_m = 0.0;             ///< while teaching: of the least sure one; infinite as long
                                           ///< as it is not known
  std::uint64_t lost_reports = 0;          ///< frames that reached neither control nor record
};

/// How the record stands.
enum class Recording : std::uint8_t {
  kIdle,      ///< no session yet, or nothing is to be recorded
  kWriting,   ///< on the disc but for the last moment
  kComplete,  ///< finished; the report can be made
  kFailed,    ///< the store refuses; what was written before stays
};
/// "idle", "writing", "complete", "failed".
[[nodiscard]] std::string_view id(Recording recording);

struct RecordState {
  Recording recording = Recording::kIdle;
  std::int64_t session = 0;           ///< its id in the store, 0 before
  therapy::SessionMeasures measures;  ///< of the last seconds while writing, of the session when complete
  std::uint64_t lost_samples = 0;     ///< samples that did not reach the store
};

/// All that a screen needs, taken at its own beat.
struct Snapshot {
  std::shared_ptr<const TrackedFrame> frame;  ///< nullptr before the first one
  ControlState control;
  RecordState record;
};

}  // namespace mirrorarm::station
