#include "core/calibration/clock_fit.h"

#include <algorithm>
#include <array>
#include <ceres/ceres.h>
#include <cmath>
#include <vector>

#include "core/calibration/ceres_pose.h"
#include "core/calibration/median.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kJointRounds = 4;
constexpr int kRounds = 10;
constexpr double kSettled_s = 1e-5;
constexpr double kLikeness = 0.95;  ///< of the errors of poses in a row, as the offset is sought
constexpr std::size_t kFewestPoses = 20;
constexpr std::size_t kParts = 10;
constexpr double kOutlier = 6.0;  ///< noises of a pose, all six numbers together
/// Median length of three normal numbers.
constexpr double kMedianOfThree = 1.538;
constexpr double kLeastNoise_m = 1e-6;
constexpr double kLeastNoise_rad = 1e-6;

/// A camera's pose and where the robot was and went when it was taken, as far as is known.
struct Moment {
  RigidTransform X_CM;
  RigidTransform X_BF;
  SmallMotion velocity;  ///< of F
};

struct Noise {
  double sigma_m = 0.0;
  double sigma_rad = 0.0;
};

/// How far the object lies in the camera from where the poses put it, in units of the noise: turn and shift.
class MomentStray {
 public:
  MomentStray(const Moment& moment, CameraMount mount, const Noise& noise)
      : X_CM_(blockOf(moment.X_CM)),
        X_BF_(blockOf(moment.X_BF)),
        velocity_(moment.velocity),
        mount_(mount),
        noise_(noise) {}

  /// With the robot `delay_s` later than assumed.
  template <class T>
  [[nodiscard]] Eigen::Matrix<T, 6, 1> at(const T* X_PC, const T* X_QM, const T& delay_s) const {
    const PoseIn<T> X_BF = cast<T>(X_BF_) * moved(delay_s);
    const PoseIn<T> X_PQ = mount_ == CameraMount::kInHand ? X_BF.inverse() : X_BF;
    const PoseIn<T> predicted = PoseIn<T>(X_PC).inverse() * X_PQ * PoseIn<T>(X_QM);
    const PoseIn<T> seen = cast<T>(X_CM_);
    const Eigen::Quaternion<T> rest = predicted.q * seen.q.conjugate();
    Eigen::Matrix<T, 6, 1> stray;
    stray << rest.vec() * T((rest.w() < T(0.0) ? -2.0 : 2.0) / noise_.sigma_rad),
        (predicted.p - seen.p) / T(noise_.sigma_m);
    return stray;
  }

 private:
  template <class T>
  PoseIn<T> moved(const T& delay_s) const {
    const Eigen::Matrix<T, 3, 1> half_turn = velocity_.head<3>().cast<T>() * (delay_s / T(2.0));
    const Eigen::Quaternion<T> turn(T(1.0), half_turn.x(), half_turn.y(), half_turn.z());
    return {turn.normalized(), velocity_.tail<3>().cast<T>() * delay_s};
  }
  template <class T>
  static PoseIn<T> cast(const PoseBlock& block) {
    const Eigen::Map<const Eigen::Matrix<double, 7, 1>> v(block.data());
    return {Eigen::Quaterniond(v.data()).cast<T>(), v.tail<3>().cast<T>()};
  }
  PoseBlock X_CM_;
  PoseBlock X_BF_;
  SmallMotion velocity_;
  CameraMount mount_;
  Noise noise_;
};

/// What a pose tells beyond the one before it, if both err alike by the share `likeness` (an autoregression
/// of first order, whitened).
class InnovationCost {
 public:
  InnovationCost(const MomentStray& before, const MomentStray& now, double likeness)
      : before_(before), now_(now), likeness_(likeness) {}

  template <class T>
  bool operator()(const T* X_PC, const T* X_QM, const T* delay_s, T* residual) const {
    Eigen::Map<Eigen::Matrix<T, 6, 1>> innovation(residual);
    innovation = now_.at(X_PC, X_QM, *delay_s) - T(likeness_) * before_.at(X_PC, X_QM, *delay_s);
    innovation /= T(std::sqrt(1.0 - likeness_ * likeness_));
    return true;
  }

 private:
  MomentStray before_;
  MomentStray now_;
  double likeness_;
};

std::vector<Moment> momentsAt(const TimedPath& robot, std::span<const TimedPose> camera, double offset_s) {
  const double half_width_s = std::max(robot.interval_s(), 0.5 * TimedPath(camera).interval_s());
  std::vector<Moment> moments;
  for (const auto& pose : camera) {
    const auto X_BF = robot.at(pose.time_s + offset_s);
    const auto velocity = robot.velocityAt(pose.time_s + offset_s, half_width_s);
    if (X_BF && velocity) moments.push_back({pose.X, *X_BF, *velocity});
  }
  return moments;
}

std::vector<StationResidual> residualsOf(std::span<const Moment> moments, CameraMount mount,
                                         const ClockFit& fit) {
  std::vector<StationResidual> residuals;
  for (const auto& moment : moments) {
    const RigidTransform X_QP = mount == CameraMount::kInHand ? moment.X_BF : moment.X_BF.inverse();
    const RigidTransform X_QM = X_QP * fit.X_PC * moment.X_CM;
    residuals.push_back(
        {(X_QM.translation() - fit.X_QM.translation()).norm(), angleBetween(X_QM, fit.X_QM), false});
  }
  return residuals;
}

bool isOutlier(const StationResidual& residual, const Noise& noise) {
  return std::hypot(residual.position_m / noise.sigma_m, residual.rotation_rad / noise.sigma_rad) > kOutlier;
}

Noise noiseOf(std::span<const StationResidual> residuals) {
  std::vector<double> shifts_m, turns_rad;
  for (const auto& residual : residuals) {
    shifts_m.push_back(residual.position_m);
    turns_rad.push_back(residual.rotation_rad);
  }
  return {std::max(median(std::move(shifts_m)) / kMedianOfThree, kLeastNoise_m),
          std::max(median(std::move(turns_rad)) / kMedianOfThree, kLeastNoise_rad)};
}

/// Which moments are left out: a part in a row, or none.
struct LeftOut {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// What one solution seeks, the rest as it is. The poses come from all that the camera saw. The offset comes
/// from what changes from one pose to the next: there the errors of lens and board, which vary slowly and are
/// taken for a delay by their chance likeness to the speed, cancel.
enum class Sought { kAll, kPoses, kOffset };

void addMoments(ceres::Problem& problem, std::span<const Moment> moments, CameraMount mount,
                const Noise& noise, const LeftOut& left_out, double likeness,
                const std::array<double*, 3>& blocks) {
  for (std::size_t i = 1; i < moments.size(); ++i) {
    if (i >= left_out.first && i < left_out.end) continue;
    const MomentStray before(moments[i - 1], mount, noise), now(moments[i], mount, noise);
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<InnovationCost, 6, 7, 7, 1>(
                                 new InnovationCost(before, now, likeness)),
                             new ceres::TukeyLoss(kOutlier), blocks[0], blocks[1], blocks[2]);
  }
}

/// One solution about the moments as they are; the offset moves by the delay found.
bool solve(std::span<const Moment> moments, CameraMount mount, Sought sought, const LeftOut& left_out,
           ClockFit& fit) {
  PoseBlock X_PC = blockOf(fit.X_PC), X_QM = blockOf(fit.X_QM);
  double delay_s = 0.0;
  ceres::Problem problem;
  addPose(problem, X_PC);
  addPose(problem, X_QM);
  problem.AddParameterBlock(&delay_s, 1);
  addMoments(problem, moments, mount, noiseOf(fit.residuals), left_out,
             sought == Sought::kOffset ? kLikeness : 0.0, {X_PC.data(), X_QM.data(), &delay_s});
  if (sought == Sought::kPoses) problem.SetParameterBlockConstant(&delay_s);
  if (sought == Sought::kOffset) {
    problem.SetParameterBlockConstant(X_PC.data());
    problem.SetParameterBlockConstant(X_QM.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.function_tolerance = 1e-8;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return false;
  fit.X_PC = poseOf(X_PC);
  fit.X_QM = poseOf(X_QM);
  fit.offset_s += delay_s;
  return true;
}

bool solveBoth(std::span<const Moment> moments, CameraMount mount, const LeftOut& left_out, ClockFit& fit) {
  return solve(moments, mount, Sought::kPoses, left_out, fit) &&
         solve(moments, mount, Sought::kOffset, left_out, fit);
}

/// Delete-a-part jackknife (Efron and Tibshirani, An Introduction to the Bootstrap, section 11.5): poses in a
/// row err alike, so single ones would tell too little.
bool estimateSigma(std::span<const Moment> moments, CameraMount mount, ClockFit& fit) {
  Eigen::Matrix<double, 7, static_cast<int>(kParts)> strays;
  for (std::size_t part = 0; part < kParts; ++part) {
    ClockFit partial = fit;
    const LeftOut left_out{part * moments.size() / kParts, (part + 1) * moments.size() / kParts};
    if (!solveBoth(moments, mount, left_out, partial)) return false;
    const RigidTransform moved = fit.X_PC.inverse() * partial.X_PC;
    strays.col(static_cast<Eigen::Index>(part)) << rotationVector(moved.linear()), moved.translation(),
        partial.offset_s;
  }
  strays.colwise() -= strays.rowwise().mean().eval();
  const Eigen::Matrix<double, 7, 7> covariance =
      strays * strays.transpose() * (static_cast<double>(kParts - 1) / static_cast<double>(kParts));
  fit.covariance = covariance.topLeftCorner<6, 6>();
  fit.sigma_s = std::sqrt(covariance(6, 6));
  return true;
}

}  // namespace

std::optional<ClockFit> fitClock(const TimedPath& robot, std::span<const TimedPose> camera, CameraMount mount,
                                 const ClockFit& start) {
  ClockFit fit = start;
  for (int round = 0; round < kRounds; ++round) {
    const auto moments = momentsAt(robot, camera, fit.offset_s);
    if (moments.size() < kFewestPoses) return std::nullopt;
    fit.residuals = residualsOf(moments, mount, fit);
    const double before_s = fit.offset_s;
    // Far from the answer poses and offset lean on each other: first all at once.
    if (round < kJointRounds && !solve(moments, mount, Sought::kAll, {}, fit)) return std::nullopt;
    if (round >= kJointRounds && !solveBoth(moments, mount, {}, fit)) return std::nullopt;
    if (round < kJointRounds || (round + 1 < kRounds && std::abs(fit.offset_s - before_s) > kSettled_s))
      continue;
    const Noise noise = noiseOf(fit.residuals);
    fit.residuals = residualsOf(moments, mount, fit);
    for (auto& residual : fit.residuals) residual.is_outlier = isOutlier(residual, noise);
    if (!estimateSigma(moments, mount, fit)) return std::nullopt;
    break;
  }
  return fit;
}

}  // namespace mirrorarm::calibration
