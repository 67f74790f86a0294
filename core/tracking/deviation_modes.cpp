#include "core/tracking/deviation_modes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace mirrorarm::tracking {
namespace {

constexpr double kLeastNorm_m = 1e-9;

/// No more modes than half of the ways in which so many markers can move against each other.
int mostModes(std::size_t markers) { return std::clamp((3 * static_cast<int>(markers) - 6) / 2, 0, kModes); }

}  // namespace

void DeviationModes::resize(std::size_t markers) {
  rows_.resize(markers, ModeRows::Zero());
  rest_.resize(markers);
}

ModeVector DeviationModes::amplitudes(std::span<const Eigen::Vector3d> deviation) const {
  ModeVector sum = ModeVector::Zero();
  for (std::size_t i = 0; i < rows_.size(); ++i) sum += rows_[i].transpose() * deviation[i];
  return sum;
}

void DeviationModes::learn(std::span<const Eigen::Vector3d> deviation, double share) {
  last_turn_.setIdentity();
  const ModeVector amplitudes_now = amplitudes(deviation);
  double rest_square = 0.0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rest_[i] = deviation[i] - rows_[i] * amplitudes_now;
    rest_square += rest_[i].squaredNorm();
  }
  const double rest_norm = std::sqrt(rest_square);
  if (rest_norm < kLeastNorm_m && amplitudes_now.norm() < kLeastNorm_m) {
    variances_ *= 1.0 - share;
    return;
  }
  Eigen::Matrix<double, kModes + 1, 1> sample;
  sample << amplitudes_now, rest_norm;
  Update covariance = share * sample * sample.transpose();
  covariance.diagonal().head<kModes>() += (1.0 - share) * variances_;
  rotate(covariance, rest_norm);
}

/// Into the principal axes of old modes and the direction that they lack; the least one is forgotten.
void DeviationModes::rotate(const Update& covariance, double rest_norm) {
  const Eigen::SelfAdjointEigenSolver<Update> solver(covariance);
  const int modes = mostModes(rows_.size());
  Eigen::Matrix<double, kModes + 1, kModes> turn = Eigen::Matrix<double, kModes + 1, kModes>::Zero();
  variances_.setZero();
  for (int k = 0; k < modes; ++k) {
    variances_[k] = std::max(0.0, solver.eigenvalues()[kModes - k]);
    turn.col(k) = solver.eigenvectors().col(kModes - k);
  }
  last_turn_ = turn.topRows<kModes>();
  const double scale = rest_norm < kLeastNorm_m ? 0.0 : 1.0 / rest_norm;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i] = (rows_[i] * turn.topRows<kModes>() + scale * rest_[i] * turn.bottomRows<1>()).eval();
}

void DeviationModes::refit(const ShapeGauge& gauge) {
  for (int k = 0; k < kModes; ++k) {
    for (std::size_t i = 0; i < rows_.size(); ++i) rest_[i] = rows_[i].col(k);
    gauge.removeRigidPart(rest_);
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].col(k) = rest_[i];
    orthonormalise(k);
  }
}

/// Gram and Schmidt's step against the modes before it; one that nothing is left of becomes zero.
void DeviationModes::orthonormalise(int mode) {
  double square = 0.0;
  for (int other = 0; other < mode; ++other) {
    double product = 0.0;
    for (const auto& rows : rows_) product += rows.col(other).dot(rows.col(mode));
    for (auto& rows : rows_) rows.col(mode) -= product * rows.col(other);
  }
  for (const auto& rows : rows_) square += rows.col(mode).squaredNorm();
  constexpr double kLeastSquare = 1e-6;  // of a unit field: the rest of it was rigid or another mode
  const double scale = square > kLeastSquare ? 1.0 / std::sqrt(square) : 0.0;
  for (auto& rows : rows_) rows.col(mode) *= scale;
  if (scale == 0.0) variances_[mode] = 0.0;
}

}  // namespace mirrorarm::tracking
