#include "core/calibration/hand_eye_pixels.h"

#include <algorithm>
#include <array>
#include <ceres/ceres.h>
#include <cmath>

#include "core/calibration/ceres_pose.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kSoftLimit = 3.0;  ///< noises beyond which a point pulls no harder

using FlangeBlock = std::array<double, 6>;  ///< turn and shift of the flange from where the robot said

/// The lens, with its own derivative.
class LensCost : public ceres::SizedCostFunction<2, 3> {
 public:
  explicit LensCost(const camera::CameraModel& camera) : camera_(camera) {}

  bool Evaluate(const double* const* parameters, double* pixel, double** jacobians) const override {
    camera::CameraModel::ProjectJacobian J;
    const auto seen = camera_.project(Eigen::Map<const Eigen::Vector3d>(parameters[0]), J);
    if (!seen) return false;
    Eigen::Map<Eigen::Vector2d>{pixel} = *seen;
    if (jacobians && jacobians[0]) Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>{jacobians[0]} = J;
    return true;
  }

 private:
  const camera::CameraModel& camera_;
};

/// What the points of one image have in common.
struct ImageOfStation {
  const camera::CameraModel& camera;
  RigidTransform X_KC;  ///< left camera in this one
  RigidTransform X_BF;
  CameraMount mount;
  double sigma_px;
};

/// Distance of a point's projection from where it was seen, in noises.
class PointCost {
 public:
  PointCost(const ImageOfStation& image, const Eigen::Vector3d& p_M, const Eigen::Vector2d& pixel)
      : lens_(new LensCost(image.camera)),
        X_KC_(blockOf(image.X_KC)),
        X_BF_(blockOf(image.X_BF)),
        mount_(image.mount),
        sigma_px_(image.sigma_px),
        p_M_(p_M),
        pixel_(pixel) {}

  template <class T>
  bool operator()(const T* X_PC, const T* X_QM, const T* flange, const T* scale, T* residual) const {
    const PoseIn<T> X_BF = cast<T>(X_BF_) * moved(flange);
    const PoseIn<T> X_PQ = mount_ == CameraMount::kInHand ? X_BF.inverse() : X_BF;
    const Eigen::Matrix<T, 3, 1> p_M = p_M_.cast<T>() * *scale;
    const Eigen::Matrix<T, 3, 1> p_K =
        cast<T>(X_KC_) * (PoseIn<T>(X_PC).inverse() * (X_PQ * (PoseIn<T>(X_QM) * p_M)));
    Eigen::Matrix<T, 2, 1> projected;
    if (!lens_(p_K.data(), projected.data())) return false;
    Eigen::Map<Eigen::Matrix<T, 2, 1>>{residual} = (projected - pixel_.cast<T>()) / T(sigma_px_);
    return true;
  }

 private:
  template <class T>
  static PoseIn<T> moved(const T* flange) {
    const Eigen::Quaternion<T> turn(T(1.0), flange[0] / T(2.0), flange[1] / T(2.0), flange[2] / T(2.0));
    return {turn.normalized(), Eigen::Matrix<T, 3, 1>(flange[3], flange[4], flange[5])};
  }
  template <class T>
  static PoseIn<T> cast(const PoseBlock& block) {
    const Eigen::Map<const Eigen::Matrix<double, 7, 1>> v(block.data());
    return {Eigen::Quaterniond(v.data()).cast<T>(), v.tail<3>().cast<T>()};
  }
  ceres::CostFunctionToFunctor<2, 3> lens_;
  PoseBlock X_KC_;
  PoseBlock X_BF_;
  CameraMount mount_;
  double sigma_px_;
  Eigen::Vector3d p_M_;
  Eigen::Vector2d pixel_;
};

/// The flange is about where the robot says.
struct RobotCost {
  RobotNoise noise;

  template <class T>
  bool operator()(const T* flange, T* residual) const {
    for (int i = 0; i < 6; ++i) residual[i] = flange[i] / T(i < 3 ? noise.sigma_rad : noise.sigma_m);
    return true;
  }
};

/// The numbers sought, and the problem that moves them.
struct Unknowns {
  PoseBlock X_PC;
  PoseBlock X_QM;
  std::vector<FlangeBlock> flanges;
  double scale = 1.0;
};

using Points = std::vector<ceres::ResidualBlockId>;

void addImage(const PixelProblem& task, const ImageOfStation& image, const Sighting& sighting,
              FlangeBlock& flange, Unknowns& unknowns, ceres::Problem& problem, Points& points) {
  for (const auto& seen : sighting)
    points.push_back(problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PointCost, 2, 7, 7, 6, 1>(
            new PointCost(image, task.points[static_cast<std::size_t>(seen.point)], seen.pixel)),
        new ceres::HuberLoss(kSoftLimit), unknowns.X_PC.data(), unknowns.X_QM.data(), flange.data(),
        &unknowns.scale));
}

/// The points' residuals, station by station.
std::vector<Points> build(const PixelProblem& task, Unknowns& unknowns, ceres::Problem& problem) {
  addPose(problem, unknowns.X_PC);
  addPose(problem, unknowns.X_QM);
  problem.AddParameterBlock(&unknowns.scale, 1);
  std::vector<Points> stations(task.stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto& [view, X_BF] = task.stations[i];
    auto& flange = unknowns.flanges[i];
    const ImageOfStation left{task.rig.left, RigidTransform::Identity(), X_BF, task.mount, task.sigma_px};
    const ImageOfStation right{task.rig.right, task.rig.X_RC, X_BF, task.mount, task.sigma_px};
    addImage(task, left, view.seen[0], flange, unknowns, problem, stations[i]);
    addImage(task, right, view.seen[1], flange, unknowns, problem, stations[i]);
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<RobotCost, 6, 6>(new RobotCost{task.robot}),
                             nullptr, flange.data());
  }
  return stations;
}

/// Sum of the squared distances in one station's images [px^2].
double squares_px2(const ceres::Problem& problem, const Points& points, double sigma_px) {
  double sum = 0.0;
  for (const auto& point : points) {
    double half = 0.0;
    problem.EvaluateResidualBlock(point, false, &half, nullptr, nullptr);
    sum += 2.0 * half * sigma_px * sigma_px;
  }
  return sum;
}

void measure(const ceres::Problem& problem, const std::vector<Points>& stations, double sigma_px,
             PixelFit& fit) {
  double sum = 0.0, count = 0.0;
  for (const auto& points : stations) {
    const double squares = squares_px2(problem, points, sigma_px);
    fit.stations_px.push_back(std::sqrt(squares / static_cast<double>(points.size())));
    sum += squares;
    count += static_cast<double>(points.size());
  }
  fit.rms_px = std::sqrt(sum / count);
}

/// Misfit beyond the noise, as a factor of the variances, at least 1.
double varianceFactor(const ceres::Solver::Summary& summary) {
  const double freedoms = summary.num_residuals_reduced - summary.num_effective_parameters_reduced;
  return std::max(1.0, 2.0 * summary.final_cost / std::max(1.0, freedoms));
}

bool estimate(ceres::Problem& problem, const Unknowns& unknowns, double factor, PixelFit& fit) {
  const auto covariance = smallMotionCovariance(problem, unknowns.X_PC);
  if (!covariance) return false;
  fit.covariance = factor * *covariance;
  if (problem.IsParameterBlockConstant(&unknowns.scale)) return true;
  ceres::Covariance scale({});
  const std::vector<std::pair<const double*, const double*>> wanted = {{&unknowns.scale, &unknowns.scale}};
  double variance = 0.0;
  if (!scale.Compute(wanted, &problem) ||
      !scale.GetCovarianceBlock(&unknowns.scale, &unknowns.scale, &variance))
    return false;
  fit.scale_sigma = std::sqrt(factor * variance);
  return true;
}

}  // namespace

std::optional<PixelFit> fitPixels(const PixelProblem& task, const PixelStart& start, bool seeks_scale) {
  Unknowns unknowns{blockOf(start.X_PC), blockOf(start.X_QM),
                    std::vector<FlangeBlock>(task.stations.size(), FlangeBlock{}), 1.0};
  ceres::Problem problem;
  const auto stations = build(task, unknowns, problem);
  if (!seeks_scale) problem.SetParameterBlockConstant(&unknowns.scale);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.function_tolerance = 1e-10;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return std::nullopt;
  PixelFit fit;
  fit.X_PC = poseOf(unknowns.X_PC);
  fit.X_QM = poseOf(unknowns.X_QM);
  fit.scale = unknowns.scale;
  measure(problem, stations, task.sigma_px, fit);
  if (!estimate(problem, unknowns, varianceFactor(summary), fit)) return std::nullopt;
  return fit;
}

}  // namespace mirrorarm::calibration
