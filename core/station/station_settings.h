#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "core/control/assist.h"
#include "core/control/follower.h"
#include "core/control/force_watch.h"
#include "core/control/supervisor.h"
#include "core/robot/planner.h"
#include "core/tracking/teacher.h"
#include "core/tracking/tracker.h"
#include "core/vision/marker_finder.h"
#include "core/vision/stereo_matcher.h"

namespace mirrorarm::station {

/// How a station works. Defaults are the paper's where it names a figure.
struct StationSettings {
  vision::FinderSettings finder;
  vision::MatcherSettings matcher;
  tracking::TrackerSettings tracker;
  /// Five seconds at least, so that a lesson that ends by itself has seen the arm move.
  tracking::TeacherSettings teacher{.min_frames = 120};
  control::FollowerSettings follower;
  control::SupervisorSettings supervisor;
  control::ForceSettings force;  ///< what the arm in the sling may feel
  control::AssistPlan assist;    ///< heeded where the robot gives way to forces
  robot::PlannerSettings planner;
  std::string limits_profile = "therapy";
  Eigen::Vector3d midplane_normal_B = Eigen::Vector3d::UnitY();  ///< of the patient's body, for the mirror

  std::filesystem::path store_file;        ///< records; empty: nothing is recorded
  std::filesystem::path black_box_folder;  ///< where a stop leaves its last seconds; empty: nowhere
  std::int64_t patient_id = 0;             ///< in the store; 0: a patient without a name is made
  std::string exercise = "free";           ///< for the record
};

}  // namespace mirrorarm::station
