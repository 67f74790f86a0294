#pragma once

#include <optional>
#include <span>

#include "core/geometry/rigid_transform.h"
#include "core/robot/joints.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::therapy {

/// One instant of a session as it is recorded: a camera frame and what the robot did at its time.
struct Sample {
  double time_s = 0.0;    ///< since the session's start, at the middle of the exposure
  bool training = false;  ///< the robot was following
  tracking::TrackStatus status = tracking::TrackStatus::kLost;
  int matched = 0;
  double rms_m = 0.0;
  double sigma_t_m = 0.0;    ///< largest standard deviation of the target's shift in the camera
  double sigma_r_rad = 0.0;  ///< and of its turn
  RigidTransform X_CT = RigidTransform::Identity();       ///< target in camera; good unless lost
  RigidTransform X_BT = RigidTransform::Identity();       ///< target in robot base; good unless lost
  RigidTransform X_BE = RigidTransform::Identity();       ///< end effector, measured
  RigidTransform X_BE_goal = RigidTransform::Identity();  ///< where it belonged; good while training
  robot::Joints q_rad;                                    ///< measured
  robot::Joints v_rad_s;   ///< largest that went to the robot since the sample before
  robot::Joints a_rad_s2;  ///< largest that went to the robot since the sample before
  /// Largest force at the sling since the sample before, as a share of what the plan allows; nothing where
  /// the robot tells no torques.
  std::optional<double> force_share;
  std::optional<double> help_level;  ///< 0 to 1; nothing where the robot holds its position stiffly
  bool help_adapts = false;          ///< to the error, else it is fixed
};

/// What a session comes to. Figures of movement are taken from the training samples alone.
struct SessionMeasures {
  int frames = 0;
  double tracked_share = 0.0;  ///< of all frames since the target was taught
  double rms_mm = 0.0;         ///< mean misfit of the tracked frames
  double lag_ms = 0.0;  ///< delay of the end effector that fits its path best to the goal's; 0: unknown
  double gain = 0.0;    ///< least-squares slope of its displacement against the goal's, lag removed
  double felt_error_mm = 0.0;   ///< rms distance to the goal, lag included
  double shape_error_mm = 0.0;  ///< rms distance to the goal, lag removed
  double tool_speed_m_s = 0.0;  ///< largest speed of the end effector
  int repetitions = 0;    ///< out-and-back movements of the healthy arm (repetitions.h): shifts of 20 mm
                          ///< or more, or else turns of 0.35 rad or more
  double range_mm = 0.0;  ///< largest distance of the healthy arm from where training began
  double path_mm = 0.0;   ///< way of the end effector, in steps of at least 2 mm
  double active_s = 0.0;  ///< time in training
  double joint_speed_ratio = 0.0;             ///< largest commanded joint speed to its limit
  double joint_acceleration_ratio = 0.0;      ///< largest commanded joint acceleration to its limit
  std::optional<double> force_share;          ///< largest of all samples, in training or not
  std::optional<double> help_level;           ///< mean in training
  std::optional<double> help_adapting_share;  ///< of the training with help, in which it adapted
};

/// `max_speed_rad_s` and `max_acceleration_rad_s2` are the limits in force; without them (size 0) the ratios
/// stay 0. Fewer than two training samples leave the figures of movement at 0. Samples are in the order of
/// time; pauses, frames without the target and gaps above 0.25 s cut the movement into pieces that are judged
/// together.
[[nodiscard]] SessionMeasures measure(std::span<const Sample> samples, const robot::Joints& max_speed_rad_s,
                                      const robot::Joints& max_acceleration_rad_s2);

}  // namespace mirrorarm::therapy
