#include "core/calibration/tsai_lenz.h"

#include <array>
#include <limits>

#include <Eigen/Dense>

#include "core/calibration/least_squares3.h"
#include "core/calibration/relative_motion.h"
#include "core/calibration/visp_bridge.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

/// Tsai and Lenz's modified Rodrigues vector: 2 sin(angle / 2) along the axis.
Eigen::Vector3d turnVector(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return (q.w() < 0.0 ? -2.0 : 2.0) * q.vec();
}

/// Rotation of the camera given that it is nearly `R0`: tan(angle / 2) along the axis of what is left.
std::optional<Eigen::Vector3d> restOfRotation(std::span<const RelativeMotion> motions,
                                              const Eigen::Matrix3d& R0) {
  LeastSquares3 equations;
  for (const auto& motion : motions) {
    const Eigen::Vector3d a = turnVector(motion.A.linear());
    const Eigen::Vector3d b = R0 * turnVector(motion.B.linear());
    equations.add(crossMatrix(a + b), b - a, motion.weight);
  }
  return equations.solve();
}

Eigen::Matrix3d rotationByTangent(const Eigen::Vector3d& tangent) {
  const Eigen::Quaterniond q(1.0, tangent.x(), tangent.y(), tangent.z());
  return q.normalized().toRotationMatrix();
}

/// How badly a rotation turns the camera's axes into the robot's.
double misfitOf(std::span<const RelativeMotion> motions, const Eigen::Matrix3d& R_FC) {
  double sum = 0.0;
  for (const auto& motion : motions)
    sum +=
        motion.weight * (turnVector(motion.A.linear()) - R_FC * turnVector(motion.B.linear())).squaredNorm();
  return sum;
}

/// The textbook's vector is infinite for a camera turned by 180 degrees, so the problem is also posed from
/// three half turns. From the one that happens to be infinite comes anything: the best rotation is taken.
std::optional<Eigen::Matrix3d> rotationOverMotions(std::span<const RelativeMotion> motions) {
  std::optional<Eigen::Matrix3d> best;
  double least = std::numeric_limits<double>::infinity();
  const std::array<Eigen::Vector3d, 4> half_turns = {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                                     Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)};
  for (const auto& diagonal : half_turns) {
    const Eigen::Matrix3d R0 = diagonal.asDiagonal();
    const auto rest = restOfRotation(motions, R0);
    if (!rest) continue;
    const Eigen::Matrix3d R_FC = rotationByTangent(*rest) * R0;
    const double misfit = misfitOf(motions, R_FC);
    if (misfit >= least) continue;
    least = misfit;
    best = R_FC;
  }
  return best;
}

}  // namespace

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
  const auto motions = tellingMotions(pairs, weights);
  const auto R_FC = rotationOverMotions(motions);
  if (!R_FC) return std::nullopt;
  const auto p_FC = positionOverMotions(motions, *R_FC);
  if (!p_FC) return std::nullopt;
  return makeTransform(*R_FC, *p_FC);
}

}  // namespace mirrorarm::calibration
