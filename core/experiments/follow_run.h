#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/common/expected.h"
#include "core/simulation/held_motion.h"

namespace mirrorarm::experiments {

/// The workstation follows a target that a second robot holds (paper, section 3.2): the whole program in
/// lockstep on the simulated bench, from light on two sensors to the arm.
struct FollowRunSettings {
  std::filesystem::path resources;
  simulation::HeldMotion::Path path;  ///< must rest until kFollowingFrom_s
  double duration_s = 0.0;
  double rate_hz = 24.0;
  std::uint64_t seed = 1;
};

/// From then on the arm follows: what is before is for teaching and aligning.
inline constexpr double kFollowingFrom_s = 12.0;

/// The bench's movements take half a second to run evenly: the path's phase stays behind the time by so much.
inline constexpr double kPhaseBehind_s = 0.25;

/// Where both truly were: shifts since the start, in the first robot's base.
struct FollowMoment {
  double time_s = 0.0;
  Eigen::Vector3d target_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d tool_m = Eigen::Vector3d::Zero();  ///< end effector of the robot that follows
};

struct FollowRun {
  std::vector<FollowMoment> moments;  ///< 2 ms apart, from kFollowingFrom_s on
  double exposure_s = 0.0;            ///< of a frame
  double transfer_s = 0.0;            ///< from the end of the exposure on
  double arm_delay_s = 0.0;           ///< by which the arm trails its commands, as the station measured it
  double handover_s = 0.0;            ///< from planning to the first servo cycle of a motion
  /// Computing times of every frame, in this run on this machine.
  std::vector<double> vision_ms, tracking_ms, follow_ms;
};

/// The error is the reason, in one line.
[[nodiscard]] Expected<FollowRun, std::string> runFollowing(const FollowRunSettings& settings);

}  // namespace mirrorarm::experiments
