#include "core/calibration/bundle.h"

#include <cassert>
#include <ceres/ceres.h>
#include <cmath>
#include <memory>

#include "core/calibration/lens_numbers.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::calibration {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Jacobian26 = Eigen::Matrix<double, 2, 6>;
/// Jacobians as Ceres keeps them.
template <int kColumns>
using RowMajor2Map = Eigen::Map<Eigen::Matrix<double, 2, kColumns, Eigen::RowMajor>>;

/// How the rotation by w, moved on by a small turn of its own frame, moves with w: right Jacobian of SO(3).
Eigen::Matrix3d turnByVector(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = crossMatrix(w);
  if (angle < 1e-5) return Eigen::Matrix3d::Identity() - 0.5 * W;
  const double a = (1.0 - std::cos(angle)) / (angle * angle);
  const double b = (angle - std::sin(angle)) / (angle * angle * angle);
  return Eigen::Matrix3d::Identity() - a * W + b * W * W;
}

/// A pose that Ceres moves by a SmallMotion from where it began, so that nothing is singular near there.
class MovingPose {
 public:
  explicit MovingPose(const RigidTransform& begin) : begin_(begin), now_(begin) {}
  void refresh() {
    now_ = moved(begin_, motion_);
    by_motion_.topLeftCorner<3, 3>() = turnByVector(motion_.head<3>());
    by_motion_.bottomRightCorner<3, 3>() = turnBy(motion_.head<3>()).transpose();
  }
  [[nodiscard]] double* motion() { return motion_.data(); }
  [[nodiscard]] const RigidTransform& now() const { return now_; }
  /// From derivatives by a small motion of now() to derivatives by motion().
  [[nodiscard]] const Matrix6& byMotion() const { return by_motion_; }

 private:
  RigidTransform begin_, now_;
  SmallMotion motion_ = SmallMotion::Zero();
  Matrix6 by_motion_ = Matrix6::Identity();
};

/// The numbers that Ceres moves, and what follows from them once for all points.
class BundleState final : public ceres::EvaluationCallback {
 public:
  explicit BundleState(const Bundle& start) : bar_(start.X_RC), begin_(start) {
    for (const auto& camera : start.cameras) {
      numbers_.push_back(lensNumbers(camera));
      lenses_.emplace_back(camera);
    }
    for (const auto& X_CM : start.X_CM) poses_.emplace_back(X_CM);
  }

  void PrepareForEvaluation(bool /*with_jacobians*/, bool is_new_point) override {
    if (!is_new_point) return;
    for (std::size_t k = 0; k < lenses_.size(); ++k)
      lenses_[k] = SolvedLens(withNumbers(begin_.cameras[k], numbers_[k]));
    bar_.refresh();
    for (auto& pose : poses_) pose.refresh();
  }

  [[nodiscard]] std::size_t cameras() const { return lenses_.size(); }
  [[nodiscard]] const SolvedLens& lens(std::size_t k) const { return lenses_[k]; }
  [[nodiscard]] MovingPose& bar() { return bar_; }
  [[nodiscard]] MovingPose& pose(std::size_t v) { return poses_[v]; }
  [[nodiscard]] LensNumbers& numbers(std::size_t k) { return numbers_[k]; }

  [[nodiscard]] Bundle bundle() {
    PrepareForEvaluation(false, true);
    Bundle bundle = begin_;
    for (std::size_t k = 0; k < lenses_.size(); ++k) bundle.cameras[k] = lenses_[k].camera().intrinsics();
    bundle.X_RC = bar_.now();
    for (std::size_t v = 0; v < poses_.size(); ++v) bundle.X_CM[v] = poses_[v].now();
    return bundle;
  }

 private:
  std::vector<LensNumbers> numbers_;
  std::vector<SolvedLens> lenses_;
  MovingPose bar_;
  std::vector<MovingPose> poses_;
  Bundle begin_;
};

/// Projected minus seen, in standard deviations, of one point in one image. Blocks: lens, pose and, for the
/// second camera, bar.
class PointResidual final : public ceres::CostFunction {
 public:
  PointResidual(BundleState& state, std::size_t k, std::size_t v, const Eigen::Vector3d& p_M,
                const SeenPoint& seen)
      : state_(state), k_(k), v_(v), p_M_(p_M), pixel_(seen.pixel) {
    if (seen.sigma_px > 0.0) weight_ = 1.0 / seen.sigma_px;
    set_num_residuals(2);
    *mutable_parameter_block_sizes() = {static_cast<int>(state.numbers(k).size()), 6};
    if (k > 0) mutable_parameter_block_sizes()->push_back(6);
  }

  // The values come from the state, which Ceres has refreshed.
  bool Evaluate(double const* const* /*values*/, double* residuals, double** jacobians) const override {
    const RigidTransform& X_CM = state_.pose(v_).now();
    const RigidTransform X_KC = k_ == 0 ? RigidTransform::Identity() : state_.bar().now();
    const Eigen::Vector3d p_C = X_CM * p_M_;
    camera::CameraModel::ProjectJacobian by_point;
    LensJacobian by_lens;
    const auto pixel = state_.lens(k_).project(X_KC * p_C, by_point, by_lens);
    if (!pixel) return false;
    Eigen::Map<Eigen::Vector2d>{residuals} = weight_ * (*pixel - pixel_);
    if (jacobians == nullptr) return true;
    const camera::CameraModel::ProjectJacobian by_C = weight_ * by_point * X_KC.linear();
    if (jacobians[0] != nullptr)
      RowMajor2Map<Eigen::Dynamic>(jacobians[0], 2, by_lens.cols()) = weight_ * by_lens;
    put(by_C * X_CM.linear() * motionAt(p_M_), state_.pose(v_), jacobians[1]);
    if (k_ > 0) put(by_C * motionAt(p_C), state_.bar(), jacobians[2]);
    return true;
  }

 private:
  static void put(const Jacobian26& by_small_motion, const MovingPose& pose, double* jacobian) {
    if (jacobian != nullptr) RowMajor2Map<6>{jacobian} = by_small_motion * pose.byMotion();
  }

  BundleState& state_;
  std::size_t k_, v_;
  Eigen::Vector3d p_M_;
  Eigen::Vector2d pixel_;
  double weight_ = 1.0;
};

/// Adds every point; the poses are eliminated first.
void fill(ceres::Problem& problem, BundleState& state, std::span<const Eigen::Vector3d> board,
          std::span<const BoardView> views, ceres::LossFunction* loss, ceres::ParameterBlockOrdering& order) {
  const std::size_t cameras = state.cameras();
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (std::size_t k = 0; k < cameras; ++k)
      for (const auto& seen : views[v].seen[k]) {
        std::vector<double*> blocks = {state.numbers(k).data(), state.pose(v).motion()};
        if (k > 0) blocks.push_back(state.bar().motion());
        problem.AddResidualBlock(
            new PointResidual(state, k, v, board[static_cast<std::size_t>(seen.point)], seen), loss, blocks);
      }
    order.AddElementToGroup(state.pose(v).motion(), 0);
  }
  for (std::size_t k = 0; k < cameras; ++k) order.AddElementToGroup(state.numbers(k).data(), 1);
  if (cameras > 1) order.AddElementToGroup(state.bar().motion(), 1);
}

/// Ceres complains aloud of a start where a point has no image.
bool isImaged(BundleState& state, std::span<const Eigen::Vector3d> board, std::span<const BoardView> views) {
  for (std::size_t v = 0; v < views.size(); ++v)
    for (std::size_t k = 0; k < state.cameras(); ++k) {
      const RigidTransform X_CM = state.pose(v).now();
      const RigidTransform X_KM = k == 0 ? X_CM : state.bar().now() * X_CM;
      for (const auto& seen : views[v].seen[k])
        if (!state.lens(k).camera().project(X_KM * board[static_cast<std::size_t>(seen.point)])) return false;
    }
  return true;
}

ceres::Solver::Options optionsOf(const AdjustSettings& settings) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.max_num_iterations = settings.most_steps;
  options.function_tolerance = 1e-12;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

std::optional<AdjustedBundle> adjustBundle(const Bundle& start, std::span<const Eigen::Vector3d> board,
                                           std::span<const BoardView> views, const AdjustSettings& settings) {
  assert(start.X_CM.size() == views.size());
  BundleState state(start);
  if (!isImaged(state, board, views)) return std::nullopt;
  ceres::HuberLoss huber(settings.huber);
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &state;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  auto options = optionsOf(settings);
  options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  fill(problem, state, board, views, settings.huber > 0.0 ? &huber : nullptr,
       *options.linear_solver_ordering);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return std::nullopt;
  return AdjustedBundle{state.bundle(), 2.0 * summary.final_cost};
}

}  // namespace mirrorarm::calibration
