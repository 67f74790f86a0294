#include "core/calibration/relative_motion.h"

#include <cassert>
#include <numbers>

#include "core/calibration/least_squares3.h"
#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kLargestTurn_rad = 170.0 / 180.0 * std::numbers::pi;
constexpr double kLeastShareOfMedian = 0.5;

double turn_rad(const RigidTransform& X) { return rotationVector(X.linear()).norm(); }

}  // namespace

std::vector<RelativeMotion> relativeMotions(std::span<const PosePair> pairs) {
  std::vector<RelativeMotion> motions;
  motions.reserve(pairs.size() * (pairs.size() + 1) / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j)
      motions.push_back(
          {i, j, pairs[j].X_BF.inverse() * pairs[i].X_BF, pairs[j].X_CM * pairs[i].X_CM.inverse()});
  return motions;
}

std::vector<RelativeMotion> tellingMotions(std::span<const PosePair> pairs, std::span<const double> weights) {
  assert(weights.empty() || weights.size() == pairs.size());
  auto motions = relativeMotions(pairs);
  std::erase_if(motions, [](const RelativeMotion& motion) {
    return turn_rad(motion.A) > kLargestTurn_rad || turn_rad(motion.B) > kLargestTurn_rad;
  });
  if (motions.empty()) return motions;
  std::vector<double> turns_rad;
  for (auto& motion : motions) {
    if (!weights.empty()) motion.weight = weights[motion.i] * weights[motion.j];
    turns_rad.push_back(turn_rad(motion.A));
  }
  const double least_rad = kLeastShareOfMedian * median(std::move(turns_rad));
  std::erase_if(motions,
                [least_rad](const RelativeMotion& motion) { return turn_rad(motion.A) < least_rad; });
  return motions;
}

std::optional<Eigen::Vector3d> positionOverMotions(std::span<const RelativeMotion> motions,
                                                   const Eigen::Matrix3d& R_FC) {
  LeastSquares3 equations;
  for (const auto& motion : motions)
    equations.add(motion.A.linear() - Eigen::Matrix3d::Identity(),
                  R_FC * motion.B.translation() - motion.A.translation(), motion.weight);
  return equations.solve();
}

}  // namespace mirrorarm::calibration
