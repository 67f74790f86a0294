#include "core/tracking/pose_estimator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kLeastVariance_m2 = 1e-14;  // no sensor is better than a tenth of a micrometre
constexpr double kMedianSigmas = 1.538;      // of three normal coordinates: median of chi with 3 degrees
constexpr double kConverged = 1e-5;          // square of the last step in standard deviations
constexpr double kChance = 3.090;            // normal deviate that 1 of 1000 exceeds
constexpr double kFar = 3.0;                 // scale beyond which the pose is not yet near the answer
constexpr int kMaxExplanations = 5;

// Of a pose about which nothing is known: keeps the normal matrix regular when the markers lie on a line.
constexpr double kAnyTurn_rad = 3.0;
constexpr double kAnyShift_m = 10.0;

Matrix6d anyPose() {
  Vector6d information;
  information << Vector3d::Constant(1.0 / (kAnyTurn_rad * kAnyTurn_rad)),
      Vector3d::Constant(1.0 / (kAnyShift_m * kAnyShift_m));
  return information.asDiagonal();
}

/// The chi-square that chance exceeds in one of a thousand cases. Source: Wilson and Hilferty, PNAS 17, 1931.
double largestByChance(int freedom) {
  const double share = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - share + kChance * std::sqrt(share), 3);
}

}  // namespace

void PoseEstimator::see(std::span<const MarkerMatch> matches) {
  const Matrix3d R_TC = estimate_.X_CT.linear().transpose();
  const Vector3d origin_C = estimate_.X_CT.translation();
  const Matrix3d added = (kLeastVariance_m2 + excess_m2_) * Matrix3d::Identity();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MarkerMatch& match = matches[i];
    Residual& residual = residuals_[i];
    const Matrix3d covariance =
        R_TC * match.point_covariance_m2 * R_TC.transpose() + match.marker_covariance_m2 + added;
    residual.information = covariance.inverse();
    residual.r_T = R_TC * (match.point_C - origin_C) - match.marker_T;
    residual.sigmas = std::sqrt(residual.r_T.dot(residual.information * residual.r_T));
  }
}

/// The median match sets the scale, but no fewer than three count as good: a pose needs them. Where it says
/// that the pose is still far off, nothing is an outlier yet: what fits worse only pulls less (Cauchy).
void PoseEstimator::weigh() {
  for (std::size_t i = 0; i < residuals_.size(); ++i) sorted_[i] = residuals_[i].sigmas;
  const auto middle =
      sorted_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(sorted_.size() / 2, 2));
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  scale_ = std::max(1.0, *middle / kMedianSigmas);
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    const double sigmas = residuals_[i].sigmas / scale_;
    weights_[i] = scale_ > kFar ? 1.0 / (1.0 + sigmas * sigmas) : robustWeight(sigmas);
  }
}

double PoseEstimator::robustWeight(double sigmas) const {
  if (sigmas <= settings_.huber_sigmas) return 1.0;
  return sigmas <= settings_.outlier_sigmas ? settings_.huber_sigmas / sigmas : 0.0;
}

/// Moves the pose by one step of Gauss and Newton and returns its squared length in standard deviations.
double PoseEstimator::step(std::span<const MarkerMatch> matches) {
  Matrix6d normal = anyPose();
  Vector6d pull = Vector6d::Zero();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (weights_[i] == 0.0) continue;
    const Matrix3d W = weights_[i] * residuals_[i].information;
    const Matrix3d x = crossMatrix(matches[i].marker_T);  // the marker moves by -x * turn + shift
    const Matrix3d xW = x * W;
    const Vector3d Wr = W * residuals_[i].r_T;
    normal.topLeftCorner<3, 3>().noalias() -= xW * x;
    normal.topRightCorner<3, 3>() += xW;
    normal.bottomRightCorner<3, 3>() += W;
    pull.head<3>().noalias() += x * Wr;
    pull.tail<3>() += Wr;
  }
  normal.bottomLeftCorner<3, 3>() = normal.topRightCorner<3, 3>().transpose();
  const Eigen::LLT<Matrix6d> factor(normal);
  estimate_.covariance = factor.solve(Matrix6d::Identity());
  const Vector6d d = estimate_.covariance * pull;
  estimate_.X_CT = moved(estimate_.X_CT, d);
  return pull.dot(d);
}

void PoseEstimator::descend(std::span<const MarkerMatch> matches) {
  for (int i = 0; i < settings_.max_steps; ++i) {
    see(matches);
    weigh();
    if (step(matches) < kConverged * scale_ * scale_) break;
  }
  see(matches);
}

double PoseEstimator::robustChi2() const {
  const double huber = settings_.huber_sigmas;
  double sum = 0.0;
  for (const Residual& residual : residuals_) {
    const double sigmas = std::min(residual.sigmas, settings_.outlier_sigmas);
    sum += sigmas <= huber ? sigmas * sigmas : huber * (2.0 * sigmas - huber);
  }
  return sum;
}

PoseEstimator::Misfit PoseEstimator::misfit() const {
  Misfit misfit{0.0, 0.0, -6};
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    if (weights_[i] == 0.0) continue;
    const Residual& residual = residuals_[i];
    misfit.chi2 += weights_[i] * residual.sigmas * residual.sigmas;
    misfit.slope += weights_[i] * (residual.information * residual.r_T).squaredNorm();
    misfit.freedom += 3;
  }
  return misfit;
}

/// Adds variance until the misfit is what it should be, each time with the pose that then is best. Newton's
/// steps on 1 / chi2, which grows evenly with the variance. Two degrees fewer than there are: so that the
/// mean of e' C^-1 e is right where the variance is known from few degrees (the mean of Fisher's F).
void PoseEstimator::explain(std::span<const MarkerMatch> matches) {
  Misfit left = misfit();
  if (left.chi2 <= largestByChance(left.freedom)) return;
  for (int i = 0; i < kMaxExplanations; ++i) {
    const double wanted = left.freedom - 2.0;
    if (std::abs(left.chi2 - wanted) < 0.02 * wanted) break;
    excess_m2_ = std::max(0.0, excess_m2_ + left.chi2 * (left.chi2 - wanted) / (wanted * left.slope));
    descend(matches);
    left = misfit();
  }
}

double PoseEstimator::inlierRms() const {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    if (weights_[i] == 0.0) continue;
    sum += residuals_[i].r_T.squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

const PoseEstimate& PoseEstimator::estimate(std::span<const MarkerMatch> matches,
                                            const RigidTransform& start) {
  assert(matches.size() >= 3);
  residuals_.resize(matches.size());
  weights_.resize(matches.size());
  sorted_.resize(matches.size());
  estimate_.X_CT = start;
  excess_m2_ = 0.0;
  descend(matches);
  estimate_.chi2 = robustChi2();
  estimate_.freedom = 3 * static_cast<int>(matches.size()) - 6;
  explain(matches);
  estimate_.excess_m = std::sqrt(excess_m2_);
  estimate_.rms_m = inlierRms();
  return estimate_;
}

}  // namespace mirrorarm::tracking
