#include "core/station/view_planner.h"

#include <algorithm>

namespace mirrorarm::station {
namespace {

/// More than the board's place is uncertain by before the hand-eye calibration.
constexpr double kAir_m = 0.03;
constexpr double kPost_m = 0.10;

/// The board's own and what stands there always.
std::vector<robot::Obstacle> obstaclesAround(const PlannedArm& arm, const BoardPlace& place) {
  auto obstacles = boardObstacles(place.board, place.X_BM, arm.table_height_m);
  obstacles.insert(obstacles.end(), arm.obstacles.begin(), arm.obstacles.end());
  return obstacles;
}

}  // namespace

std::vector<robot::Obstacle> boardObstacles(const calibration::Board& board, const RigidTransform& X_BM,
                                            double table_height_m) {
  Eigen::AlignedBox3d extent;
  for (const auto& p_M : calibration::boardPoints(board)) extent.extend(p_M);
  const double rim_m = board.spacing_m + kAir_m;
  const Eigen::Vector3d plate_m = extent.sizes() + 2.0 * Eigen::Vector3d(rim_m, rim_m, kAir_m);
  const RigidTransform X_BP = X_BM * Eigen::Translation3d(extent.center());
  std::vector<robot::Obstacle> obstacles{{X_BP, plate_m}};
  const Eigen::Vector3d middle_B = X_BP.translation();
  const double height_m = middle_B.z() - table_height_m;
  const RigidTransform X_BPost(
      Eigen::Translation3d(middle_B.x(), middle_B.y(), table_height_m + 0.5 * height_m));
  if (height_m > 0.0) obstacles.push_back({X_BPost, {kPost_m, kPost_m, height_m}});
  return obstacles;
}

ViewPlanner::ViewPlanner(const PlannedArm& arm, const BoardPlace& place)
    : X_BM_(place.X_BM),
      X_FC_(place.X_FC),
      limits_(arm.limits),
      kinematics_(arm.arm),
      planner_(arm.arm, arm.attached, obstaclesAround(arm, place), arm.planner) {}

bool ViewPlanner::isWithinLimits(const robot::Joints& q) const {
  return (q.array() >= limits_.lower_rad.array()).all() && (q.array() <= limits_.upper_rad.array()).all();
}

std::optional<robot::Joints> ViewPlanner::joints(const RigidTransform& X_CM,
                                                 std::span<const robot::Joints> seeds) const {
  const RigidTransform X_BF = X_BM_ * X_CM.inverse() * X_FC_.inverse();
  std::optional<robot::Joints> nearest;
  const auto way = [&](const robot::Joints& q) { return (q - seeds.back()).cwiseAbs().maxCoeff(); };
  for (const auto& seed : seeds) {
    const auto q = kinematics_.inverse(X_BF, seed);
    if (!q || !isWithinLimits(*q) || planner_.collides(*q)) continue;
    if (!nearest || way(*q) < way(*nearest)) nearest = q;
  }
  return nearest;
}

std::optional<std::vector<robot::Joints>> ViewPlanner::path(const robot::Joints& from,
                                                            const robot::Joints& to) {
  auto path = planner_.plan(from, to);
  if (!path) return std::nullopt;
  return std::move(path->waypoints);
}

RigidTransform ViewPlanner::viewFrom(const RigidTransform& X_BF) const {
  return (X_BF * X_FC_).inverse() * X_BM_;
}

}  // namespace mirrorarm::station
