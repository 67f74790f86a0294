#include "core/calibration/clock_offset.h"

#include <cmath>
#include <numbers>

#include "core/calibration/clock_fit.h"
#include "core/calibration/median.h"
#include "core/calibration/timed_path.h"
#include "core/calibration/turn_correlation.h"
#include "core/calibration/worst_axis.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kShortest_s = 5.0;
constexpr double kLongest_s = 4.0 * 3600.0;
constexpr std::size_t kFewestPoses = 30;
constexpr double kLeastSpeedStd_rad_s = 0.01;
constexpr double kLeastCorrelation = 0.5;
constexpr double kRivalShare = 0.95;
constexpr std::size_t kStartPoses = 60;  ///< the start over all pairs grows with their square
constexpr std::size_t kMostPoses = 2000;
constexpr double kLargestMedian_m = 0.03;
constexpr double kLargestMedian_rad = 5.0 * kDegree;

using Refusal = std::optional<ClockError>;

Refusal refuseStreams(std::span<const TimedPose> robot, std::span<const TimedPose> camera) {
  if (robot.size() < kFewestPoses || camera.size() < kFewestPoses) return ClockError::kTooShort;
  for (const auto stream : {robot, camera})
    if (!(stream.back().time_s - stream.front().time_s < kLongest_s)) return ClockError::kTooLong;
  return std::nullopt;
}

Refusal refuseTurns(const TurnCorrelation& turns) {
  if (turns.common_s < kShortest_s) return ClockError::kTooShort;
  if (turns.speed_std_rad_s < kLeastSpeedStd_rad_s) return ClockError::kTooStill;
  if (turns.correlation < kLeastCorrelation) return ClockError::kNoAgreement;
  if (turns.rival > kRivalShare * turns.correlation) return ClockError::kAmbiguous;
  return std::nullopt;
}

/// At most `count` of them, evenly.
std::vector<TimedPose> thinned(std::span<const TimedPose> poses, std::size_t count) {
  if (poses.size() <= count) return {poses.begin(), poses.end()};
  std::vector<TimedPose> kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(poses[i * poses.size() / count]);
  return kept;
}

std::vector<PosePair> pairsAt(const TimedPath& robot, std::span<const TimedPose> camera, double offset_s) {
  std::vector<PosePair> pairs;
  for (const auto& pose : camera)
    if (const auto X_BF = robot.at(pose.time_s + offset_s)) pairs.push_back({*X_BF, pose.X});
  return pairs;
}

void invert(std::vector<TimedPose>& poses) {
  for (auto& pose : poses) pose.X = pose.X.inverse();
}

ClockError clockErrorOf(HandEyeError error) {
  switch (error) {
    case HandEyeError::kRobotInverted:
    case HandEyeError::kBothInverted:
      return ClockError::kRobotInverted;
    case HandEyeError::kCameraBesideRobot:
    case HandEyeError::kCameraInHand:
      return ClockError::kWrongMount;
    case HandEyeError::kInconsistent:
      return ClockError::kNoAgreement;
    default:
      return ClockError::kNotSolved;
  }
}

/// Where the camera sits, roughly; a camera stream that gives X_MC is turned round.
Expected<HandEyeSolution, ClockError> start(const TimedPath& robot, std::vector<TimedPose>& camera,
                                            CameraMount mount, double offset_s, bool& was_inverted) {
  auto solved = solveHandEye(pairsAt(robot, thinned(camera, kStartPoses), offset_s), mount);
  if (!solved && solved.error().error == HandEyeError::kCameraInverted) {
    was_inverted = true;
    invert(camera);
    solved = solveHandEye(pairsAt(robot, thinned(camera, kStartPoses), offset_s), mount);
  }
  if (!solved) return unexpected(clockErrorOf(solved.error().error));
  return *solved;
}

HandEyeSolution handEyeOf(const ClockFit& fit) {
  HandEyeSolution solution;
  solution.X_PC = fit.X_PC;
  solution.X_QM = fit.X_QM;
  solution.stations = fit.residuals;
  solution.covariance = fit.covariance;
  solution.sigma_m = worstAxisSigma(fit.covariance.bottomRightCorner<3, 3>());
  double count = 0.0;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
    const auto& residual = fit.residuals[i];
    if (residual.is_outlier) {
      solution.outliers.push_back(i);
      continue;
    }
    count += 1.0;
    solution.rms_m += residual.position_m * residual.position_m;
    solution.rms_rad += residual.rotation_rad * residual.rotation_rad;
  }
  solution.rms_m = std::sqrt(solution.rms_m / count);
  solution.rms_rad = std::sqrt(solution.rms_rad / count);
  return solution;
}

template <class Value>
double medianOver(std::span<const StationResidual> residuals, Value value) {
  std::vector<double> values;
  for (const auto& residual : residuals) values.push_back(residual.*value);
  return median(std::move(values));
}

}  // namespace

std::string_view reason(ClockError error) {
  switch (error) {
    case ClockError::kTooShort:
      return "both streams have less than 5 s in common, or fewer than 30 poses: record a minute of one "
             "movement, both clocks right to within the search";
    case ClockError::kTooLong:
      return "a stream spans more than 4 hours: are its times seconds?";
    case ClockError::kTooStill:
      return "the flange hardly turned, or turned evenly: turn it to and fro by 20 degrees and more, now "
             "faster, now slower";
    case ClockError::kNoAgreement:
      return "at no offset do robot and camera turn alike: check that both streams are of one movement, and "
             "widen the search";
    case ClockError::kAmbiguous:
      return "robot and camera turn alike at several offsets, as the movement repeats itself: move unevenly";
    case ClockError::kRobotInverted:
      return "the robot's poses look inverted: give the flange in the base (X_BF), not the base in the "
             "flange";
    case ClockError::kWrongMount:
      return "the camera is not where it was said to be: say --eye in-hand for a camera on the flange, "
             "to-hand "
             "for one beside the robot";
    case ClockError::kNotSolved:
      break;
  }
  return "robot and camera turn alike, but the turns do not fix the camera: turn the flange about two axes";
}

Expected<ClockOffset, ClockError> solveClockOffset(std::span<const TimedPose> robot_poses,
                                                   std::span<const TimedPose> camera_poses, CameraMount mount,
                                                   double search_s) {
  if (const auto refused = refuseStreams(robot_poses, camera_poses)) return unexpected(*refused);
  const TimedPath robot(robot_poses);
  const auto turns = correlateTurns(robot, TimedPath(camera_poses), search_s);
  if (const auto refused = refuseTurns(turns)) return unexpected(*refused);
  ClockOffset found;
  auto camera = thinned(camera_poses, kMostPoses);
  const auto first = start(robot, camera, mount, turns.offset_s, found.was_camera_inverted);
  if (!first) return unexpected(first.error());
  const auto fit = fitClock(robot, camera, mount, {turns.offset_s, first->X_PC, first->X_QM, 0.0, {}, {}});
  if (!fit) return unexpected(ClockError::kNotSolved);
  found.offset_s = fit->offset_s;
  found.sigma_s = fit->sigma_s;
  found.correlation = turns.correlation;
  found.hand_eye = handEyeOf(*fit);
  found.median_m = medianOver(fit->residuals, &StationResidual::position_m);
  found.median_rad = medianOver(fit->residuals, &StationResidual::rotation_rad);
  if (found.median_m > kLargestMedian_m || found.median_rad > kLargestMedian_rad)
    return unexpected(ClockError::kNoAgreement);
  return found;
}

}  // namespace mirrorarm::calibration
