#include "core/experiments/pose_statistics.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/geometry/rigid_fit.h"

namespace mirrorarm::experiments {
namespace {

using Eigen::Vector3d;

constexpr double kArm_m = 0.05;  // of the points that stand for a frame

bool isTracked(const TrialFrame& frame) { return frame.answer.status == tracking::TrackStatus::kTracked; }

/// The scene's target frame from the taught one, over all tracked frames.
RigidTransform commonOffset(std::span<const TrialFrame> frames, int tracked) {
  std::vector<Vector3d> taught{Vector3d::Zero()};
  for (int axis = 0; axis < 3; ++axis) taught.push_back(kArm_m * Vector3d::Unit(axis));
  std::vector<Vector3d> mean(taught.size(), Vector3d::Zero());
  for (const TrialFrame& frame : frames) {
    if (!isTracked(frame)) continue;
    const RigidTransform offset = frame.X_CT.inverse() * frame.answer.X_CT;
    for (std::size_t i = 0; i < taught.size(); ++i) mean[i] += offset * taught[i] / tracked;
  }
  return fitByKabsch(taught, mean);
}

}  // namespace

PoseStatistics statisticsOf(std::span<const TrialFrame> frames) {
  PoseStatistics result;
  result.frames = static_cast<int>(frames.size());
  for (const TrialFrame& frame : frames) result.tracked += isTracked(frame) ? 1 : 0;
  if (result.tracked == 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    result.fit_rms_mm = result.rms_mm = result.turn_rms_deg = kNone;
    result.std_mm.setConstant(kNone);
    return result;
  }
  const RigidTransform offset = commonOffset(frames, result.tracked);
  Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
  double turn_squares = 0.0;
  for (const TrialFrame& frame : frames) {
    if (!isTracked(frame)) continue;
    const RigidTransform truth = frame.X_CT * offset;
    const Vector3d error_mm = 1e3 * (frame.answer.X_CT.translation() - truth.translation());
    const double turn = angleBetween(frame.answer.X_CT, truth);
    sum += error_mm / result.tracked;
    squares += error_mm.cwiseAbs2() / result.tracked;
    turn_squares += turn * turn / result.tracked;
    result.fit_rms_mm += 1e3 * frame.answer.rms_m / result.tracked;
  }
  result.rms_mm = std::sqrt(squares.sum());
  result.turn_rms_deg = std::sqrt(turn_squares) * 180.0 / std::numbers::pi;
  result.std_mm = (squares - sum.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
  return result;
}

}  // namespace mirrorarm::experiments
