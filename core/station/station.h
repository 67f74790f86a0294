#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/control/follower.h"
#include "core/control/supervisor.h"
#include "core/records/store.h"
#include "core/station/command.h"
#include "core/station/equipment.h"
#include "core/station/snapshot.h"
#include "core/tracking/teacher.h"
#include "core/tracking/tracker.h"
#include "core/vision/stereo_vision.h"

namespace mirrorarm::station {

struct StationSettings {
  vision::FinderSettings finder;
  vision::MatcherSettings matcher;
  tracking::TrackerSettings tracker;
  tracking::TeacherSettings teacher;
  control::FollowerSettings follower;
  control::SupervisorSettings supervisor;
  robot::PlannerSettings planner;
  std::string limits_profile = "therapy";
  std::filesystem::path store_file;  ///< records; empty: nothing is recorded
  std::filesystem::path black_box_folder;  ///< where a stop leaves its last seconds; empty: nowhere
  std::int64_t patient_id = 0;       ///< in the store; 0: a patient "unnamed" is made
  std::string exercise = "free";
};

/// Owns the threads and joins the rooms: acquisition, tracking, control, servo and recorder thread. The rest of
/// the program sees commands in, snapshots out. Destroying it stops the robot and closes the record.
class Station {
 public:
  /// Real time on threads of its own. Throws std::runtime_error where the store cannot be opened.
  Station(const Equipment& equipment, const StationSettings& settings);
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Any thread. kQueueFull or kAccepted at once; whether the phase allows it is said in the snapshot's
  /// `last_answer`.
  [[nodiscard]] Answer request(const Command& command);

  /// Brings the robot to rest, past every queue. Any thread, any time, as often as wanted.
  void stop(control::StopReason reason = control::StopReason::kOperator) noexcept;
  /// Frees a latched stop; the session stays paused. Any thread.
  void resetStop() noexcept;

  /// The newest snapshot. One thread, the screen's.
  [[nodiscard]] Snapshot snapshot();

  /// The record's id in the store, 0 while no session was begun.
  [[nodiscard]] std::int64_t sessionId() const;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::station
