#include "core/calibration/bundle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "core/calibration/bundle_jacobian.h"

namespace mirrorarm::calibration {
namespace {

constexpr int kMostIterations = 200;
constexpr double kSettledShare = 1e-10;  ///< gain of a step, relative, below which the fit has settled
constexpr double kLargestDamping = 1e8;

double pointsSeen(std::span<const BoardView> views) {
  double points = 0.0;
  for (const auto& view : views) points += static_cast<double>(view.seen[0].size() + view.seen[1].size());
  return points;
}

/// Normal equations with each view's six numbers already eliminated.
class Reduced {
 public:
  Reduced(const Linearised& problem, double damping) : problem_(problem) {
    shared_ = damped(problem.shared, damping);
    gradient_ = problem.shared_gradient;
    for (const auto& view : problem.views) {
      inverses_.emplace_back(damped(view.own, damping).inverse());
      shared_ -= view.mixed * inverses_.back() * view.mixed.transpose();
      gradient_ -= view.mixed * (inverses_.back() * view.own_gradient);
    }
  }

  /// The step, or nothing when the equations are singular.
  [[nodiscard]] std::optional<BundleStep> step() const {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(shared_);
    if (ldlt.info() != Eigen::Success || !ldlt.isPositive()) return std::nullopt;
    BundleStep step;
    step.shared = -ldlt.solve(gradient_);
    if (!step.shared.allFinite()) return std::nullopt;
    for (std::size_t i = 0; i < inverses_.size(); ++i) {
      const auto& view = problem_.views[i];
      step.views.emplace_back(-inverses_[i] * (view.own_gradient + view.mixed.transpose() * step.shared));
    }
    return step;
  }

  /// Inverse of the shared numbers' equations: their covariance for noise of 1 px.
  [[nodiscard]] Eigen::MatrixXd covariance() const { return shared_.inverse(); }

 private:
  template <class Matrix>
  static Matrix damped(Matrix matrix, double damping) {
    matrix.diagonal() *= 1.0 + damping;
    return matrix;
  }
  const Linearised& problem_;
  Eigen::MatrixXd shared_;
  Eigen::VectorXd gradient_;
  std::vector<Matrix6> inverses_;
};

/// One step that makes the fit better, the damping raised until there is one. False when none is left.
bool improve(Bundle& bundle, double& squares, double& damping, std::span<const Eigen::Vector3d> board,
             std::span<const BoardView> views) {
  const auto problem = linearise(bundle, board, views);
  if (!problem) return false;
  for (; damping < kLargestDamping; damping *= 10.0) {
    const auto step = Reduced(*problem, damping).step();
    if (!step) continue;
    const Bundle next = moved(bundle, *step);
    const auto next_squares = sumOfSquares(next, board, views);
    if (!next_squares || !(*next_squares < squares)) continue;
    const bool goes_on = squares - *next_squares > kSettledShare * squares;
    bundle = next;
    squares = *next_squares;
    damping = std::max(damping / 10.0, 1e-12);
    return goes_on;
  }
  return false;
}

double focalSigmaShare(const Bundle& bundle, const Linearised& problem, double sigma_px) {
  const Eigen::MatrixXd covariance = Reduced(problem, 0.0).covariance();
  double worst = 0.0;
  for (std::size_t k = 0; k < bundle.cameras.size(); ++k) {
    const auto first = firstIntrinsic(bundle, k);
    const auto& camera = bundle.cameras[k];
    worst = std::max(worst, std::sqrt(covariance(first, first)) / camera.fx_px);
    worst = std::max(worst, std::sqrt(covariance(first + 1, first + 1)) / camera.fy_px);
  }
  return std::isfinite(worst) ? worst * sigma_px : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<BundleFit> adjustBundle(const Bundle& start, std::span<const Eigen::Vector3d> board,
                                      std::span<const BoardView> views) {
  assert(start.X_CM.size() == views.size());
  auto squares = sumOfSquares(start, board, views);
  if (!squares) return std::nullopt;
  BundleFit fit;
  fit.bundle = start;
  double damping = 1e-3;
  for (int i = 0; i < kMostIterations; ++i)
    if (!improve(fit.bundle, *squares, damping, board, views)) break;
  fit.rms_px = std::sqrt(*squares / pointsSeen(views));
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Bundle alone{fit.bundle.cameras, fit.bundle.X_RC, {fit.bundle.X_CM[i]}};
    const auto own = sumOfSquares(alone, board, views.subspan(i, 1));
    fit.view_rms_px.push_back(std::sqrt(own.value_or(0.0) / pointsSeen(views.subspan(i, 1))));
  }
  const auto problem = linearise(fit.bundle, board, views);
  if (!problem) return std::nullopt;
  fit.focal_sigma_share = focalSigmaShare(fit.bundle, *problem, fit.rms_px / std::sqrt(2.0));
  return fit;
}

}  // namespace mirrorarm::calibration
