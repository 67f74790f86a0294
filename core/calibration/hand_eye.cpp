#include "core/calibration/hand_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/calibration/station_misfit.h"
#include "core/calibration/tsai_lenz.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kFewestPairs = 3;
constexpr double kRigidTolerance = 1e-3;
constexpr double kSmallestLargestTurn_rad = 8.0 * kDegree;
constexpr double kSmallestSecondSpread_rad = 1.5 * kDegree;
constexpr double kLargestRms_m = 0.03;
constexpr double kLargestRms_rad = 5.0 * kDegree;
/// ViSP's answer stands unless the other one's misfit is smaller by this factor.
constexpr double kClearlyWorse = 1.5;

using Refusal = std::optional<HandEyeError>;

std::vector<PosePair> asInHand(std::span<const PosePair> pairs, CameraMount mount) {
  std::vector<PosePair> turned(pairs.begin(), pairs.end());
  if (mount == CameraMount::kToHand)
    for (auto& pair : turned) pair.X_BF = pair.X_BF.inverse();
  return turned;
}

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

Refusal refusePairs(std::span<const PosePair> pairs) {
  if (pairs.size() < kFewestPairs) return HandEyeError::kTooFewPairs;
  for (const auto& pair : pairs)
    if (!isRigid(pair.X_BF, kRigidTolerance) || !isRigid(pair.X_CM, kRigidTolerance))
      return HandEyeError::kNotRigid;
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
  StationMisfit misfit;
  HandEyeMethod method = HandEyeMethod::kTsaiLenzVisp;
};

bool isClearlyBetter(const StationMisfit& one, const StationMisfit& other) {
  return kClearlyWorse * one.rms_m() < other.rms_m() || kClearlyWorse * one.rms_rad() < other.rms_rad();
}

std::optional<Answer> bestAnswer(std::span<const PosePair> pairs) {
  std::optional<Answer> best;
  if (const auto X_FC = tsaiLenzByVisp(pairs))
    best = Answer{*X_FC, stationMisfit(pairs, *X_FC), HandEyeMethod::kTsaiLenzVisp};
  if (const auto X_FC = tsaiLenzOverAllPairs(pairs)) {
    const auto misfit = stationMisfit(pairs, *X_FC);
    if (!best || isClearlyBetter(misfit, best->misfit))
      best = Answer{*X_FC, misfit, HandEyeMethod::kTsaiLenzAllPairs};
  }
  return best;
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
  const Eigen::Matrix3d covariance =
      strays * strays.transpose() * (static_cast<double>(n - 1) / static_cast<double>(n));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
}

bool areTooMany(std::span<const std::size_t> outliers, std::size_t stations) {
  return 2 * outliers.size() >= stations || stations - outliers.size() < kFewestPairs;
}

}  // namespace

std::string_view name(CameraMount mount) { return mount == CameraMount::kInHand ? "in-hand" : "to-hand"; }

std::optional<CameraMount> cameraMountOf(std::string_view text) {
  for (const auto mount : {CameraMount::kInHand, CameraMount::kToHand})
    if (text == name(mount)) return mount;
  return std::nullopt;
}

std::string_view name(HandEyeMethod method) {
  return method == HandEyeMethod::kTsaiLenzVisp ? "tsai-lenz (visp)" : "tsai-lenz over all pairs";
}

std::string_view reason(HandEyeError error) {
  switch (error) {
    case HandEyeError::kTooFewPairs:
      return "holds fewer than 3 pose pairs: capture at least 3 stations, better 15";
    case HandEyeError::kNotRigid:
      return "a pose is not finite or its rotation is none";
    case HandEyeError::kTurnsTooSmall:
      return "the flange turned by less than 8 degrees between any two stations: turn it by 30 and more "
             "about two axes";
    case HandEyeError::kOneAxis:
      return "the flange turned about one axis only: capture stations turned about a second axis as well";
    case HandEyeError::kNotSolved:
      return "the turns do not fix the camera: capture stations turned by 20 to 60 degrees about two axes";
    case HandEyeError::kInconsistent:
      return "robot and camera contradict each other: check --eye, that the robot's poses are the flange in "
             "its base, "
             "metres, and that the board did not move";
  }
  return "is refused";
}

Expected<HandEyeSolution, HandEyeError> solveHandEye(std::span<const PosePair> pairs, CameraMount mount) {
  if (const auto refused = refusePairs(pairs)) return unexpected(*refused);
  const auto all = asInHand(pairs, mount);
  HandEyeSolution solution;
  solution.outliers = contradictingStations(all);
  if (areTooMany(solution.outliers, all.size())) return unexpected(HandEyeError::kInconsistent);
  const auto kept = without(all, solution.outliers);
  if (const auto refused = refusePairs(kept)) return unexpected(*refused);
  const auto answer = bestAnswer(kept);
  if (!answer) return unexpected(HandEyeError::kNotSolved);
  solution.X_PC = answer->X_FC;
  solution.X_QM = answer->misfit.X_BM;
  solution.rms_m = answer->misfit.rms_m();
  solution.rms_rad = answer->misfit.rms_rad();
  solution.method = answer->method;
  if (solution.rms_m > kLargestRms_m || solution.rms_rad > kLargestRms_rad)
    return unexpected(HandEyeError::kInconsistent);
  solution.sigma_m = jackknife_m(kept);
  return solution;
}

}  // namespace mirrorarm::calibration
