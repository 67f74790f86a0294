#include "core/tracking/bundle_adjustment.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t kFewestForPose = 3;
constexpr double kHuber = 4.0;           // standard deviations over three coordinates
constexpr double kOutlier = 8.0;         // likewise
constexpr double kMedianSigmas = 1.538;  // of three coordinates
constexpr double kFloor_m = 1e-6;
constexpr double kStartSpread_m = 0.001;
constexpr double kSettled_m = 1e-9;
constexpr double kTinyShare = 1e-12;

/// Orthonormal basis of the motions of all markers together: what no sighting can tell.
MatrixXd freeMotions(std::span<const Vector3d> markers_T) {
  MatrixXd motions(static_cast<Index>(3 * markers_T.size()), 6);
  for (std::size_t i = 0; i < markers_T.size(); ++i)
    motions.middleRows<3>(static_cast<Index>(3 * i)) = motionAt(markers_T[i]);
  const Eigen::HouseholderQR<MatrixXd> qr(motions);
  return qr.householderQ() * MatrixXd::Identity(motions.rows(), 6);
}

double trustIn(double sigmas) {
  if (sigmas > kOutlier) return 0.0;
  return sigmas > kHuber ? kHuber / sigmas : 1.0;
}

NetworkTerm termOf(const Sighting& sighting, const RigidTransform& X_CT, const Vector3d& marker_T,
                   double spread_m) {
  NetworkTerm term;
  term.marker = sighting.marker;
  const Matrix3d R_TC = X_CT.linear().transpose();
  term.residual_T = R_TC * (sighting.point_C - X_CT.translation()) - marker_T;
  term.sensor_T = R_TC * sighting.covariance_m2 * R_TC.transpose();
  const double own = spread_m * spread_m + kFloor_m * kFloor_m;
  term.weight = (term.sensor_T + own * Matrix3d::Identity()).inverse();
  term.motion = motionAt(marker_T);
  return term;
}

double sigmasOf(const NetworkTerm& term) {
  return std::sqrt(std::max(0.0, term.residual_T.dot(term.weight * term.residual_T)));
}

/// Outliers are told from the other sightings of their frame: while its pose or the spreads are not right yet
/// all fit worse than they should.
void setTrust(std::span<NetworkTerm> terms, std::vector<double>& sigmas) {
  sigmas.clear();
  for (const auto& term : terms) sigmas.push_back(sigmasOf(term));
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  const double scale = std::max(1.0, *middle / kMedianSigmas);
  for (auto& term : terms) {
    term.trust = trustIn(sigmasOf(term) / scale);
    term.pull = term.trust * term.motion.transpose() * term.weight;
  }
}

/// A frame's own equations for its pose.
struct PoseEquations {
  Matrix6d normal = Matrix6d::Zero();
  SmallMotion gradient = SmallMotion::Zero();

  explicit PoseEquations(std::span<const NetworkTerm> terms) {
    for (const auto& term : terms) {
      normal += term.pull * term.motion;
      gradient += term.pull * term.residual_T;
    }
    // Few or collinear markers leave a turn open.
    normal.diagonal() *= 1.0 + kTinyShare;
    normal.diagonal().array() += kTinyShare * normal.trace();
  }

  [[nodiscard]] Matrix6d covariance() const { return normal.ldlt().solve(Matrix6d::Identity()); }
};

}  // namespace

void BundleAdjustment::adjust(MarkerNetwork& network, int max_steps) {
  assert(network.markers_T.size() >= 3 && network.spread_m.size() == network.markers_T.size());
  const bool guess = std::any_of(network.spread_m.begin(), network.spread_m.end(),
                                 [](double spread) { return spread < 0.0; });
  if (guess) {
    network.spread_m.assign(network.markers_T.size(), kStartSpread_m);
    linearise(network);
    move(network);
    linearise(network);
    guessSpreads(terms_, network.spread_m);
  }
  for (int step = 0; step < max_steps; ++step) {
    linearise(network);
    const bool last = move(network) < kSettled_m || step + 1 == max_steps;
    spreads_.improve(terms_, network.spread_m, last);
    if (last) break;
  }
  linearise(network);
  move(network);
  linearise(network);
  findCovariance(network);
}

void BundleAdjustment::linearise(const MarkerNetwork& network) {
  const auto size = static_cast<Index>(3 * network.markers_T.size());
  normal_.setZero(size, size);
  gradient_.setZero(size);
  terms_.clear();
  first_term_.clear();
  frames_used_ = 0;
  for (std::size_t f = 0; f < network.frames.size(); ++f) {
    first_term_.push_back(terms_.size());
    if (network.frames[f].sightings.size() >= kFewestForPose) linearise(network, f);
  }
  first_term_.push_back(terms_.size());
}

void BundleAdjustment::linearise(const MarkerNetwork& network, std::size_t frame) {
  const NetworkFrame& seen = network.frames[frame];
  const std::size_t first = terms_.size();
  for (const auto& sighting : seen.sightings) {
    const auto marker = static_cast<std::size_t>(sighting.marker);
    terms_.push_back(termOf(sighting, seen.X_CT, network.markers_T[marker], network.spread_m[marker]));
    terms_.back().frame = static_cast<int>(frame);
  }
  const std::span<NetworkTerm> own(terms_.begin() + static_cast<std::ptrdiff_t>(first), terms_.end());
  setTrust(own, sigmas_);
  const auto trusted =
      std::count_if(own.begin(), own.end(), [](const NetworkTerm& term) { return term.trust > 0.0; });
  if (static_cast<std::size_t>(trusted) < kFewestForPose) {
    terms_.resize(first);
    return;
  }
  ++frames_used_;
  reduce(own);
}

/// Adds a frame to the markers' equations, its pose eliminated.
void BundleAdjustment::reduce(std::span<NetworkTerm> terms) {
  const PoseEquations pose(terms);
  const Matrix6d covariance = pose.covariance();
  const SmallMotion shift = covariance * pose.gradient;
  for (auto& a : terms) {
    a.lever = covariance * a.pull;
    if (a.trust <= 0.0) continue;
    const Index row = 3 * a.marker;
    gradient_.segment<3>(row) += a.trust * a.weight * (a.residual_T - a.motion * shift);
    normal_.block<3, 3>(row, row) += a.trust * a.weight;
    for (const auto& b : terms)
      if (b.marker <= a.marker && b.trust > 0.0)
        normal_.block<3, 3>(row, 3 * b.marker) -= a.lever.transpose() * b.pull;
  }
}

/// The markers' equations under inner constraints.
void BundleAdjustment::factorise(const MarkerNetwork& network) {
  free_ = freeMotions(network.markers_T);
  free_weight_ = normal_.trace() / static_cast<double>(normal_.rows());
  normal_.noalias() += free_weight_ * free_ * free_.transpose();
  normal_.diagonal().array() += kTinyShare * free_weight_;
  factors_.compute(normal_);
}

/// One Gauss-Newton step; how far the farthest marker went [m].
double BundleAdjustment::move(MarkerNetwork& network) {
  factorise(network);
  step_ = factors_.solve(gradient_);
  step_ -= free_ * (free_.transpose() * step_);
  for (std::size_t f = 0; f < network.frames.size(); ++f) {
    const std::span<NetworkTerm> own(terms_.data() + first_term_[f], first_term_[f + 1] - first_term_[f]);
    if (!own.empty()) moveFrame(network.frames[f].X_CT, own);
  }
  double farthest = 0.0;
  for (std::size_t i = 0; i < network.markers_T.size(); ++i) {
    const Vector3d step = step_.segment<3>(static_cast<Index>(3 * i));
    network.markers_T[i] += step;
    farthest = std::max(farthest, step.norm());
  }
  return farthest;
}

void BundleAdjustment::moveFrame(RigidTransform& X_CT, std::span<NetworkTerm> terms) const {
  PoseEquations pose(terms);
  for (const auto& term : terms) pose.gradient -= term.pull * step_.segment<3>(3 * term.marker);
  const SmallMotion motion = pose.normal.ldlt().solve(pose.gradient);
  X_CT = moved(X_CT, motion);
  // What spreads are judged by: residuals of the very weights that they led to.
  for (auto& term : terms) term.residual_T -= term.motion * motion + step_.segment<3>(3 * term.marker);
}

/// Pseudo-inverse of the equations; and a mean of readings that repeat themselves is less sure than their
/// number says.
void BundleAdjustment::findCovariance(const MarkerNetwork& network) {
  factorise(network);
  covariance_m2_ = factors_.solve(MatrixXd::Identity(normal_.rows(), normal_.cols()));
  covariance_m2_.noalias() -= free_ * free_.transpose() / free_weight_;
  const auto times = correlationTimes(terms_, network.markers_T.size());
  std::vector<double> readings(network.markers_T.size(), 0.0);
  for (const auto& term : terms_) readings[static_cast<std::size_t>(term.marker)] += term.trust;
  for (std::size_t i = 0; i < network.markers_T.size(); ++i) {
    if (network.spread_m[i] <= 0.0 || readings[i] <= 0.0) continue;
    const double lasting = network.spread_m[i] * network.spread_m[i] * (times[i] - 1.0) / readings[i];
    const auto row = static_cast<Index>(3 * i);
    covariance_m2_.block<3, 3>(row, row).diagonal().array() += lasting;
  }
}

Matrix3d BundleAdjustment::covarianceOf(std::size_t marker) const {
  const auto row = static_cast<Index>(3 * marker);
  return covariance_m2_.block<3, 3>(row, row);
}

double BundleAdjustment::chi2() const {
  double sum = 0.0;
  for (const auto& term : terms_)
    if (term.trust > 0.0) sum += term.trust * term.residual_T.dot(term.weight * term.residual_T);
  return sum;
}

int BundleAdjustment::freedom() const {
  const auto trusted =
      std::count_if(terms_.begin(), terms_.end(), [](const NetworkTerm& term) { return term.trust > 0.0; });
  return static_cast<int>(3 * trusted) - 6 * frames_used_ - static_cast<int>(gradient_.size()) + 6;
}

}  // namespace mirrorarm::tracking
