#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/calibration/hand_eye.h"
#include "core/common/expected.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// A pose with the time that its own device's clock gave it [s].
struct TimedPose {
  double time_s = 0.0;
  RigidTransform X = RigidTransform::Identity();
};

/// Reads a stream of poses: CSV with a header (time_s or time_ns, then tx_m,ty_m,tz_m,qx,qy,qz,qw; other
/// columns pass, rows with empty numbers are left out) or without one (t,x,y,z,qx,qy,qz,qw; seconds, metres).
/// Of rows with the same time the first is taken. Refused with the line: numbers that are none, times that go
/// back, quaternions whose norm is not 1 to 1 %.
[[nodiscard]] FromFile<std::vector<TimedPose>> readPoseStream(const std::filesystem::path& file);

/// Camera clock against robot clock, and with it where the camera sits.
struct ClockOffset {
  double offset_s = 0.0;     ///< add it to a camera's time to have the robot's time of the same moment
  double sigma_s = 0.0;      ///< its standard deviation, by leaving out a tenth of the movement at a time
  double correlation = 0.0;  ///< of both angular speeds at that offset, 0..1
  HandEyeSolution hand_eye;  ///< `stations` are the camera's poses compared, in their order
  double median_m = 0.0;     ///< median residual over the poses compared
  double median_rad = 0.0;
  bool was_camera_inverted = false;  ///< the camera's stream gave X_MC; it was turned round
};

enum class ClockError {
  kTooShort,       ///< less than 5 s of common time, or too few poses
  kTooLong,        ///< more than 4 hours: hardly seconds
  kTooStill,       ///< the flange hardly turned, or turned evenly
  kNoAgreement,    ///< no offset makes both turn alike
  kAmbiguous,      ///< several do: the movement repeats itself
  kRobotInverted,  ///< X_FB was given for X_BF
  kWrongMount,     ///< the camera is not where it was said to be
  kNotSolved,      ///< the offset is found, but the poses do not fix the camera
};
/// One line for an engineer: what is wrong and the remedy.
[[nodiscard]] std::string_view reason(ClockError error);

/// From two streams of one movement: `robot` gives X_BF (or another frame that the camera is fixed to),
/// `camera` gives X_CM. The angular speeds' correlation finds the offset within `search_s` to a sample, a
/// robust fit of offset, X_PC and X_QM brings it far below the camera's frame interval. Times ascend
/// in both.
[[nodiscard]] Expected<ClockOffset, ClockError> solveClockOffset(std::span<const TimedPose> robot,
                                                                 std::span<const TimedPose> camera,
                                                                 CameraMount mount, double search_s = 1.0);

}  // namespace mirrorarm::calibration
