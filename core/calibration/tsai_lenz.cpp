#include "core/calibration/tsai_lenz.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "core/calibration/visp_bridge.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kLargestTurn_rad = 170.0 / 180.0 * std::numbers::pi;
constexpr double kSmallestPivotShare = 1e-9;

struct Weighted {
  RelativeMotion motion;
  double weight = 1.0;
};

/// Tsai and Lenz's modified Rodrigues vector: 2 sin(angle / 2) along the axis.
Eigen::Vector3d turnVector(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return (q.w() < 0.0 ? -2.0 : 2.0) * q.vec();
}

/// Sum of w |S x - d|^2 over equations of three rows, solved for x.
class LeastSquares {
 public:
  void add(const Eigen::Matrix3d& S, const Eigen::Vector3d& d, double weight) {
    normal_ += weight * S.transpose() * S;
    right_ += weight * S.transpose() * d;
  }
  [[nodiscard]] std::optional<Eigen::Vector3d> solve() const {
    const Eigen::LDLT<Eigen::Matrix3d> ldlt(normal_);
    const auto pivots = ldlt.vectorD();
    if (!(pivots.minCoeff() > kSmallestPivotShare * pivots.maxCoeff())) return std::nullopt;
    return ldlt.solve(right_);
  }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// Rotation of the camera given that it is nearly `R0`: tan(angle / 2) along the axis of what is left.
std::optional<Eigen::Vector3d> restOfRotation(std::span<const Weighted> motions, const Eigen::Matrix3d& R0) {
  LeastSquares equations;
  for (const auto& [motion, weight] : motions) {
    const Eigen::Vector3d a = turnVector(motion.A.linear());
    const Eigen::Vector3d b = R0 * turnVector(motion.B.linear());
    equations.add(crossMatrix(a + b), b - a, weight);
  }
  return equations.solve();
}

Eigen::Matrix3d rotationByTangent(const Eigen::Vector3d& tangent) {
  const Eigen::Quaterniond q(1.0, tangent.x(), tangent.y(), tangent.z());
  return q.normalized().toRotationMatrix();
}

/// The textbook's vector is infinite for a camera turned by 180 degrees, so the problem is also posed from
/// three half turns and the start nearest to the answer is taken.
std::optional<Eigen::Matrix3d> rotationOverMotions(std::span<const Weighted> motions) {
  std::optional<Eigen::Vector3d> least;
  Eigen::Matrix3d start = Eigen::Matrix3d::Identity();
  const std::array<Eigen::Vector3d, 4> half_turns = {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                                     Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)};
  for (const auto& diagonal : half_turns) {
    const Eigen::Matrix3d R0 = diagonal.asDiagonal();
    const auto rest = restOfRotation(motions, R0);
    if (!rest || (least && least->norm() <= rest->norm())) continue;
    least = rest;
    start = R0;
  }
  if (!least) return std::nullopt;
  return rotationByTangent(*least) * start;
}

std::optional<Eigen::Vector3d> translationOverMotions(std::span<const Weighted> motions,
                                                      const Eigen::Matrix3d& R_FC) {
  LeastSquares equations;
  for (const auto& [motion, weight] : motions)
    equations.add(motion.A.linear() - Eigen::Matrix3d::Identity(),
                  R_FC * motion.B.translation() - motion.A.translation(), weight);
  return equations.solve();
}

std::vector<Weighted> usableMotions(std::span<const PosePair> pairs, std::span<const double> weights) {
  std::vector<Weighted> usable;
  for (const auto& motion : relativeMotions(pairs)) {
    if (rotationVector(motion.A.linear()).norm() > kLargestTurn_rad) continue;
    if (rotationVector(motion.B.linear()).norm() > kLargestTurn_rad) continue;
    usable.push_back({motion, weights.empty() ? 1.0 : weights[motion.i] * weights[motion.j]});
  }
  return usable;
}

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

std::optional<RigidTransform> tsaiLenzByVisp(std::span<const PosePair> pairs) {
  std::vector<RigidTransform> X_CM, X_BF;
  for (const auto& pair : pairs) {
    X_CM.push_back(pair.X_CM);
    X_BF.push_back(pair.X_BF);
  }
  const auto X_FC = calibrateByVisp(X_CM, X_BF);
  return X_FC && isRigid(*X_FC) ? X_FC : std::nullopt;
}

std::optional<RigidTransform> tsaiLenzOverAllPairs(std::span<const PosePair> pairs,
                                                   std::span<const double> weights) {
  assert(weights.empty() || weights.size() == pairs.size());
  const auto motions = usableMotions(pairs, weights);
  const auto R_FC = rotationOverMotions(motions);
  if (!R_FC) return std::nullopt;
  const auto p_FC = translationOverMotions(motions, *R_FC);
  if (!p_FC) return std::nullopt;
  return makeTransform(*R_FC, *p_FC);
}

}  // namespace mirrorarm::calibration
