#include "core/calibration/drift_check.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/calibration/board_pose.h"
#include "core/calibration/hold_out.h"
#include "core/geometry/rigid_fit.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestStations = 3;
constexpr double kLeastSpread_m = 0.005;
/// A failed check is this many times beyond the limit.
constexpr double kFailedAt = 2.0;

/// The views whose board could be posed, and the stations of those.
struct Posed {
  std::vector<BoardView> views;
  std::vector<RigidTransform> X_CM;
  std::vector<RigidTransform> X_BF;
  double squares_px2 = 0.0;
  std::size_t points = 0;
};

Posed posed(const camera::StereoRig& rig, const Board& board, std::span<const BoardView> views,
            std::span<const RigidTransform> X_BF) {
  Posed all;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto pose = poseBoard(rig, board, views[i]);
    const auto points = views[i].seen[0].size() + views[i].seen[1].size();
    if (!pose || seenByBoth(views[i]).empty()) continue;
    all.views.push_back(views[i]);
    all.X_CM.push_back(pose->X_CM);
    if (!X_BF.empty()) all.X_BF.push_back(X_BF[i]);
    all.squares_px2 += pose->rms_px * pose->rms_px * static_cast<double>(points);
    all.points += points;
  }
  return all;
}

double spread_m(std::span<const Eigen::Vector3d> points) {
  const Eigen::Vector3d middle = centroid(points);
  double sum = 0.0;
  for (const auto& point : points) sum += (point - middle).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

Eigen::Vector3d standardDeviation_mm(std::span<const Eigen::Vector3d> points_m) {
  const Eigen::Vector3d middle = centroid(points_m);
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (const auto& point : points_m) squares += (point - middle).array().square();
  return 1e3 * (squares / static_cast<double>(points_m.size() - 1)).sqrt();
}

/// Factor by which the steps of `measured` are longer than those of `truth`, turned onto each other.
double scaleOf(std::span<const Eigen::Vector3d> measured, std::span<const Eigen::Vector3d> truth) {
  const auto X = fitByKabsch(measured, truth);
  const Eigen::Vector3d middle = centroid(truth);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d step = truth[i] - middle;
    product += step.dot(X * measured[i] - middle);
    square += step.squaredNorm();
  }
  return product / square;
}

std::optional<DriftFindings::Grid> measureGrid(const Posed& posed, const RigidTransform& X_FC) {
  if (posed.X_BF.size() < kFewestStations) return std::nullopt;
  std::vector<Eigen::Vector3d> board_B, flange_B, flange_M;
  for (std::size_t i = 0; i < posed.X_BF.size(); ++i) {
    const RigidTransform X_FM = X_FC * posed.X_CM[i];
    board_B.emplace_back((posed.X_BF[i] * X_FM).translation());
    flange_B.emplace_back(posed.X_BF[i].translation());
    flange_M.emplace_back(X_FM.inverse().translation());
  }
  if (spread_m(flange_B) < kLeastSpread_m) return std::nullopt;
  return DriftFindings::Grid{standardDeviation_mm(board_B), 100.0 * (scaleOf(flange_M, flange_B) - 1.0),
                             flange_B.size()};
}

/// The worst of all figures, each as a share of its limit.
double worstShare(const DriftFindings& findings, const DriftLimits& limits) {
  double worst = std::max(findings.epipolar_px / limits.epipolar_px,
                          std::abs(findings.length_percent) / limits.length_percent);
  if (findings.grid)
    worst = std::max({worst, findings.grid->std_mm.maxCoeff() / limits.grid_std_mm,
                      std::abs(findings.grid->scale_percent) / limits.grid_scale_percent});
  return worst;
}

DriftVerdict verdictOf(double share) {
  if (share <= 1.0) return DriftVerdict::kHolds;
  return share <= kFailedAt ? DriftVerdict::kDoubtful : DriftVerdict::kFailed;
}

}  // namespace

std::string_view id(DriftVerdict verdict) {
  switch (verdict) {
    case DriftVerdict::kHolds:
      return "holds";
    case DriftVerdict::kDoubtful:
      return "doubtful";
    case DriftVerdict::kFailed:
      break;
  }
  return "failed";
}

std::optional<DriftVerdict> driftVerdictOf(std::string_view text) {
  for (const auto verdict : {DriftVerdict::kHolds, DriftVerdict::kDoubtful, DriftVerdict::kFailed})
    if (text == id(verdict)) return verdict;
  return std::nullopt;
}

std::optional<DriftFindings> checkDrift(const camera::StereoRig& rig, const RigidTransform& X_FC,
                                        const Board& board, std::span<const BoardView> views,
                                        std::span<const RigidTransform> X_BF, const DriftLimits& limits) {
  assert(X_BF.empty() || X_BF.size() == views.size());
  const auto all = posed(rig, board, views, X_BF);
  if (all.points == 0) return std::nullopt;
  const auto held = measureHoldOut(rig, board, all.views);
  DriftFindings findings;
  findings.epipolar_px = held.epipolar_px;
  findings.reprojection_px = std::sqrt(all.squares_px2 / static_cast<double>(all.points));
  findings.length_percent = held.square_mean_percent;
  findings.points = all.points;
  findings.grid = measureGrid(all, X_FC);
  findings.verdict = verdictOf(worstShare(findings, limits));
  return findings;
}

}  // namespace mirrorarm::calibration
