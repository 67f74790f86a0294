#include "core/experiments/stream_accuracy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/calibration/timed_path.h"

namespace mirrorarm::experiments {
namespace {

using calibration::TimedPose;
using Eigen::Vector3d;

constexpr double kAround_s = 0.1;
constexpr double kStill_m = 1e-4;
constexpr double kNewPlace_m = 1e-3;
constexpr std::size_t kFewestStandstills = 8;
constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

/// The pose at a time around which nothing moved.
std::optional<RigidTransform> stillAt(const calibration::TimedPath& path, double time_s) {
  const auto now = path.at(time_s), before = path.at(time_s - kAround_s), after = path.at(time_s + kAround_s);
  if (!now || !before || !after) return std::nullopt;
  const double moved_m = std::max((before->translation() - now->translation()).norm(),
                                  (after->translation() - now->translation()).norm());
  return moved_m < kStill_m ? now : std::nullopt;
}

/// The object in the truth's base, pose by pose of one standstill.
struct Standstill {
  Vector3d flange_B = Vector3d::Zero();
  std::vector<RigidTransform> X_BT;
};

std::vector<Standstill> standstillsOf(std::span<const TimedPose> truth, std::span<const TimedPose> camera,
                                      const RigidTransform& X_FC, double offset_s) {
  std::vector<Standstill> standstills;
  if (truth.size() < 2) return standstills;
  const calibration::TimedPath path(truth);
  for (const auto& seen : camera) {
    const auto X_BF = stillAt(path, seen.time_s + offset_s);
    if (!X_BF) continue;
    const Vector3d place = X_BF->translation();
    if (standstills.empty() || (standstills.back().flange_B - place).norm() > kNewPlace_m)
      standstills.push_back({place, {}});
    standstills.back().X_BT.push_back(*X_BF * X_FC * seen.X);
  }
  return standstills;
}

Vector3d meanPlace(const Standstill& standstill) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& X_BT : standstill.X_BT) sum += X_BT.translation();
  return sum / static_cast<double>(standstill.X_BT.size());
}

void measure(const std::vector<Standstill>& standstills, StreamAccuracy& result) {
  const auto count = static_cast<double>(standstills.size());
  Vector3d mean = Vector3d::Zero(), squares = Vector3d::Zero();
  double turns = 0.0;
  for (const auto& standstill : standstills) mean += meanPlace(standstill) / count;
  for (const auto& standstill : standstills) {
    squares += (meanPlace(standstill) - mean).cwiseAbs2() / count;
    turns += std::pow(angleBetween(standstill.X_BT.front(), standstills.front().X_BT.front()), 2) / count;
    result.poses += standstill.X_BT.size();
  }
  result.std_mm = 1e3 * squares.cwiseSqrt();
  result.rms_mm = 1e3 * std::sqrt(squares.sum());
  result.turn_rms_deg = kRadianInDegrees * std::sqrt(turns);
  result.standstills = standstills.size();
}

}  // namespace

Expected<StreamAccuracy, std::string> accuracyOfStreams(std::span<const TimedPose> truth,
                                                        std::span<const TimedPose> camera,
                                                        const std::optional<RigidTransform>& X_FC) {
  StreamAccuracy result;
  RigidTransform camera_on_truth = X_FC.value_or(RigidTransform::Identity());
  if (!X_FC) {
    const auto solved = solveClockOffset(truth, camera, calibration::CameraMount::kInHand);
    if (!solved) return unexpected(std::string(reason(solved.error())));
    camera_on_truth = solved->hand_eye.X_PC;
    result.clock_offset_s = solved->offset_s;
    result.solved_hand_eye = true;
  }
  const auto standstills = standstillsOf(truth, camera, camera_on_truth, result.clock_offset_s);
  if (standstills.size() < kFewestStandstills)
    return unexpected("the truth stands still at " + std::to_string(standstills.size()) +
                      " places where the object was tracked; " + std::to_string(kFewestStandstills) +
                      " are the least: rest for a second at each place");
  measure(standstills, result);
  return result;
}

}  // namespace mirrorarm::experiments
