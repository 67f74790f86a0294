#include "core/calibration/hand_eye_refinement.h"

#include <algorithm>
#include <ceres/ceres.h>
#include <cmath>
#include <vector>

#include "core/calibration/ceres_pose.h"
#include "core/calibration/station_misfit.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kRounds = 4;
constexpr double kSoftLimit = 4.0;  ///< noises beyond which a station pulls no harder
/// No camera and robot agree better; also keeps the weights finite where the poses are exact.
constexpr double kLeastNoise_m = 1e-7;
constexpr double kLeastNoise_rad = 1e-7;

/// Normal noise of a station: a turn, and a shift that does not depend on it where the camera's place is
/// moved the share `pivot` of the way from the object (0: the board's own pose errs) to the camera (1: the
/// camera's direction errs, as a flange does that is not where it says).
struct Noise {
  double sigma_m = 0.0;
  double sigma_rad = 0.0;
  double pivot = 0.0;
};

/// Turn of the object in the camera and its shift, from where it was seen to where the poses put it.
template <class T>
struct Stray {
  Eigen::Matrix<T, 3, 1> shift, turn, lever;
};

template <class T>
Stray<T> stray(const PoseIn<T>& predicted, const PoseIn<T>& seen) {
  const Eigen::Quaternion<T> rest = predicted.q * seen.q.conjugate();
  return {predicted.p - seen.p, rest.vec() * T(rest.w() < T(0.0) ? -2.0 : 2.0), seen.p};
}

/// The stray of one station in units of its noise.
class StationCost {
 public:
  StationCost(const PosePair& pair, const Noise& noise)
      : X_FB_(blockOf(pair.X_BF.inverse())), X_CM_(blockOf(pair.X_CM)), noise_(noise) {}

  template <class T>
  bool operator()(const T* X_FC, const T* X_BM, T* residual) const {
    const PoseIn<T> predicted = PoseIn<T>(X_FC).inverse() * cast<T>(X_FB_) * PoseIn<T>(X_BM);
    const auto [shift, turn, lever] = stray<T>(predicted, cast<T>(X_CM_));
    Eigen::Map<Eigen::Matrix<T, 6, 1>> whitened(residual);
    whitened << (shift - T(noise_.pivot) * turn.cross(lever)) / T(noise_.sigma_m), turn / T(noise_.sigma_rad);
    return true;
  }

 private:
  template <class T>
  static PoseIn<T> cast(const PoseBlock& block) {
    const Eigen::Map<const Eigen::Matrix<double, 7, 1>> v(block.data());
    return {Eigen::Quaterniond(v.data()).cast<T>(), v.tail<3>().cast<T>()};
  }
  PoseBlock X_FB_;
  PoseBlock X_CM_;
  Noise noise_;
};

std::vector<Stray<double>> strays(std::span<const PosePair> pairs, const RefinedPoses& poses) {
  std::vector<Stray<double>> all;
  for (const auto& pair : pairs) {
    const PoseBlock predicted = blockOf((pair.X_BF * poses.X_FC).inverse() * poses.X_BM);
    const PoseBlock seen = blockOf(pair.X_CM);
    all.push_back(stray(PoseIn<double>(predicted.data()), PoseIn<double>(seen.data())));
  }
  return all;
}

/// Where along the line of sight shift and turn are least alike.
double pivotOf(std::span<const Stray<double>> strays) {
  double alike = 0.0, all = 0.0;
  for (const auto& [shift, turn, lever] : strays) {
    const Eigen::Vector3d swing = turn.cross(lever);
    alike += shift.dot(swing);
    all += swing.squaredNorm();
  }
  return all > 0.0 ? std::clamp(alike / all, 0.0, 1.0) : 0.0;
}

Noise noiseOf(std::span<const Stray<double>> strays) {
  Noise noise;
  noise.pivot = pivotOf(strays);
  for (const auto& [shift, turn, lever] : strays) {
    noise.sigma_m += (shift - noise.pivot * turn.cross(lever)).squaredNorm();
    noise.sigma_rad += turn.squaredNorm();
  }
  // Twelve numbers are fitted to six a station.
  const double freedoms = 3.0 * static_cast<double>(strays.size()) - 6.0;
  noise.sigma_m = std::max(std::sqrt(noise.sigma_m / freedoms), kLeastNoise_m);
  noise.sigma_rad = std::max(std::sqrt(noise.sigma_rad / freedoms), kLeastNoise_rad);
  return noise;
}

/// One solution with the noise as given; writes the covariance too.
bool solve(std::span<const PosePair> pairs, const Noise& noise, RefinedPoses& poses) {
  PoseBlock X_FC = blockOf(poses.X_FC), X_BM = blockOf(poses.X_BM);
  ceres::Problem problem;
  addPose(problem, X_FC);
  addPose(problem, X_BM);
  for (const auto& pair : pairs)
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<StationCost, 6, 7, 7>(new StationCost(pair, noise)),
        new ceres::HuberLoss(kSoftLimit), X_FC.data(), X_BM.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.function_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const auto covariance = smallMotionCovariance(problem, X_FC);
  if (!summary.IsSolutionUsable() || !covariance) return false;
  poses = {poseOf(X_FC), poseOf(X_BM), noise.sigma_m, noise.sigma_rad, *covariance};
  return true;
}

}  // namespace

std::optional<RefinedPoses> refinePoses(std::span<const PosePair> pairs, const RigidTransform& X_FC) {
  RefinedPoses poses;
  poses.X_FC = X_FC;
  poses.X_BM = stationMisfit(pairs, X_FC).X_BM;
  for (int round = 0; round < kRounds; ++round)
    if (!solve(pairs, noiseOf(strays(pairs, poses)), poses)) return std::nullopt;
  return poses;
}

}  // namespace mirrorarm::calibration
