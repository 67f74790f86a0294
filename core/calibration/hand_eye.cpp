#include "core/calibration/hand_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/calibration/contradicting_stations.h"
#include "core/calibration/half_turns.h"
#include "core/calibration/hand_eye_convention.h"
#include "core/calibration/hand_eye_refinement.h"
#include "core/calibration/hand_eye_residuals.h"
#include "core/calibration/median.h"
#include "core/calibration/park_martin.h"
#include "core/calibration/relative_motion.h"
#include "core/calibration/tsai_lenz.h"
#include "core/calibration/worst_axis.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kFewestPairs = 3;
constexpr double kRigidTolerance = 1e-3;
constexpr double kSmallestLargestTurn_rad = 8.0 * kDegree;
constexpr double kSmallestSecondSpread_rad = 1.5 * kDegree;
constexpr double kLargestRms_m = 0.03;
constexpr double kLargestRms_rad = 5.0 * kDegree;
/// A camera placed no better than that is not placed.
constexpr double kLargestSigma_m = 0.01;
/// Beyond any arm's reach.
constexpr double kFarthest_m = 20.0;

using Refusal = std::optional<HandEyeError>;

auto refusal(HandEyeError error) { return unexpected(HandEyeRefusal{error, {}}); }

/// Spread of the turns along their second strongest axis: near zero when all are about one axis.
Refusal refuseTurns(std::span<const PosePair> pairs) {
  double largest_rad = 0.0;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  const auto motions = relativeMotions(pairs);
  for (const auto& motion : motions) {
    const Eigen::Vector3d turn = rotationVector(motion.A.linear());
    largest_rad = std::max(largest_rad, turn.norm());
    scatter += turn * turn.transpose() / static_cast<double>(motions.size());
  }
  if (largest_rad < kSmallestLargestTurn_rad) return HandEyeError::kTurnsTooSmall;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter, Eigen::EigenvaluesOnly);
  if (std::sqrt(std::max(0.0, axes.eigenvalues()[1])) < kSmallestSecondSpread_rad)
    return HandEyeError::kOneAxis;
  return std::nullopt;
}

double medianDistance_m(std::span<const PosePair> pairs, RigidTransform PosePair::*pose) {
  std::vector<double> distances_m;
  for (const auto& pair : pairs) distances_m.push_back((pair.*pose).translation().norm());
  return median(std::move(distances_m));
}

Refusal refusePairs(std::span<const PosePair> pairs) {
  if (pairs.size() < kFewestPairs) return HandEyeError::kTooFewPairs;
  for (const auto& pair : pairs)
    if (!isRigid(pair.X_BF, kRigidTolerance) || !isRigid(pair.X_CM, kRigidTolerance))
      return HandEyeError::kNotRigid;
  if (medianDistance_m(pairs, &PosePair::X_BF) > kFarthest_m) return HandEyeError::kRobotInMillimetres;
  if (medianDistance_m(pairs, &PosePair::X_CM) > kFarthest_m) return HandEyeError::kCameraInMillimetres;
  return refuseTurns(pairs);
}

std::vector<PosePair> without(std::span<const PosePair> pairs, std::span<const std::size_t> left_out) {
  std::vector<PosePair> kept;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (std::find(left_out.begin(), left_out.end(), i) == left_out.end()) kept.push_back(pairs[i]);
  return kept;
}

struct Answer {
  RigidTransform X_FC = RigidTransform::Identity();
  std::optional<Eigen::Matrix<double, 6, 6>> covariance;
};

std::optional<Answer> refined(std::span<const PosePair> pairs) {
  const auto start = tsaiLenzOverAllPairs(pairs);
  const auto poses = start ? refinePoses(pairs, *start) : std::nullopt;
  if (!poses) return std::nullopt;
  return Answer{poses->X_FC, poses->covariance};
}

std::optional<Answer> answerBy(HandEyeMethod method, std::span<const PosePair> pairs) {
  if (method == HandEyeMethod::kRefined) return refined(pairs);
  const auto X_FC = method == HandEyeMethod::kTsaiLenzVisp       ? tsaiLenzByVisp(pairs)
                    : method == HandEyeMethod::kTsaiLenzAllPairs ? tsaiLenzOverAllPairs(pairs)
                                                                 : parkMartin(pairs);
  if (!X_FC) return std::nullopt;
  return Answer{*X_FC, std::nullopt};
}

/// Delete-one jackknife of the position (Efron and Tibshirani, An Introduction to the Bootstrap, chapter 11),
/// by the quick solver: ViSP takes half a second for 50 stations, and the spread is the same.
std::optional<double> jackknife_m(std::span<const PosePair> pairs) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd positions(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::array left_out = {static_cast<std::size_t>(i)};
    const auto rest = without(pairs, left_out);
    if (refusePairs(rest)) return std::nullopt;
    const auto X_FC = tsaiLenzOverAllPairs(rest);
    if (!X_FC) return std::nullopt;
    positions.col(i) = X_FC->translation();
  }
  const Eigen::Vector3d mean = positions.rowwise().mean();
  const Eigen::Matrix3Xd strays = positions.colwise() - mean;
  return worstAxisSigma(strays * strays.transpose() * (static_cast<double>(n - 1) / static_cast<double>(n)));
}

bool areTooMany(std::span<const std::size_t> outliers, std::size_t stations) {
  return 2 * outliers.size() >= stations || stations - outliers.size() < kFewestPairs;
}

bool isBeyondUse(const HandEyeSolution& solution) {
  return solution.rms_m > kLargestRms_m || solution.rms_rad > kLargestRms_rad;
}

/// Without half turns and in the manner of a camera in the hand.
Expected<HandEyeSolution, HandEyeRefusal> solve(std::span<const PosePair> all, HandEyeMethod method) {
  HandEyeSolution solution;
  solution.outliers = contradictingStations(all);
  if (areTooMany(solution.outliers, all.size())) return refusal(HandEyeError::kInconsistent);
  const auto kept = without(all, solution.outliers);
  if (const auto refused = refusePairs(kept)) return refusal(*refused);
  const auto answer = answerBy(method, kept);
  if (!answer) return refusal(HandEyeError::kNotSolved);
  solution.method = method;
  solution.X_PC = answer->X_FC;
  solution.covariance = answer->covariance;
  fillResiduals(all, solution);
  if (isBeyondUse(solution)) return refusal(HandEyeError::kInconsistent);
  solution.sigma_m =
      answer->covariance ? worstAxisSigma(answer->covariance->bottomRightCorner<3, 3>()) : jackknife_m(kept);
  if (solution.sigma_m > kLargestSigma_m) return refusal(HandEyeError::kNotSolved);
  return solution;
}

}  // namespace

std::string_view name(CameraMount mount) { return mount == CameraMount::kInHand ? "in-hand" : "to-hand"; }

std::optional<CameraMount> cameraMountOf(std::string_view text) {
  for (const auto mount : {CameraMount::kInHand, CameraMount::kToHand})
    if (text == name(mount)) return mount;
  return std::nullopt;
}

std::string_view name(HandEyeMethod method) {
  switch (method) {
    case HandEyeMethod::kTsaiLenzVisp:
      return "tsai-lenz (visp)";
    case HandEyeMethod::kTsaiLenzAllPairs:
      return "tsai-lenz over all pairs";
    case HandEyeMethod::kParkMartin:
      return "park-martin";
    case HandEyeMethod::kRefined:
      break;
  }
  return "refined";
}

Expected<HandEyeSolution, HandEyeRefusal> solveHandEye(std::span<const PosePair> pairs, CameraMount mount,
                                                       HandEyeMethod method) {
  if (const auto refused = refusePairs(pairs)) return refusal(*refused);
  if (const auto wrong = wrongConvention(pairs, mount)) return refusal(*wrong);
  auto all = asInHand(pairs, mount);
  const auto turns = findHalfTurns(all);
  if (!turns.stations.empty() && !turns.far_corner_m)
    return unexpected(HandEyeRefusal{HandEyeError::kBoardTurned, turns.stations});
  undoHalfTurns(all, turns);
  auto solution = solve(all, method);
  if (solution) solution->turned = turns.stations;
  return solution;
}

}  // namespace mirrorarm::calibration
