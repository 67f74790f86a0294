#include "core/tracking/network_term.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace mirrorarm::tracking {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMedianOfChi2_3 = 2.366;  // three degrees of freedom
constexpr double kSignificance = 4.0;      // standard deviations of a variance estimated to be 0
constexpr double kLeastShareOfMedian = 0.4;
constexpr double kLostInNoise = 0.1;       // autocorrelation
constexpr std::size_t kFewestForTime = 8;  // sightings

std::vector<std::vector<Vector3d>> residualsByMarker(std::span<const NetworkTerm> terms,
                                                     std::size_t markers) {
  std::vector<std::vector<Vector3d>> residuals(markers);
  for (const auto& term : terms)
    if (term.trust > 0.0) residuals[static_cast<std::size_t>(term.marker)].push_back(term.residual_T);
  return residuals;
}

double correlationTime(std::span<const Vector3d> residuals) {
  double power = 0.0, time = 1.0;
  for (const auto& r : residuals) power += r.squaredNorm();
  if (residuals.size() < kFewestForTime || power <= 0.0) return time;
  for (std::size_t lag = 1; lag <= residuals.size() / 4; ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < residuals.size(); ++i) product += residuals[i].dot(residuals[i - lag]);
    if (product < kLostInNoise * power) break;
    time += 2.0 * product / power;
  }
  return time;
}

}  // namespace

void guessSpreads(std::span<const NetworkTerm> terms, std::vector<double>& spread_m) {
  const auto residuals = residualsByMarker(terms, spread_m.size());
  for (std::size_t marker = 0; marker < spread_m.size(); ++marker) {
    std::vector<double> squares;
    for (const auto& r : residuals[marker]) squares.push_back(r.squaredNorm());
    if (squares.empty()) continue;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    spread_m[marker] = std::sqrt(*middle / kMedianOfChi2_3);
  }
}

void SpreadEstimator::improve(std::span<const NetworkTerm> terms, std::vector<double>& spread_m,
                              bool only_significant) {
  score(terms, spread_m.size());
  // A spread that is 0 and would go below stays there and takes no part.
  for (Index i = 0; i < surplus_.size(); ++i) {
    const bool fixed = spread_m[static_cast<std::size_t>(i)] <= 0.0 && surplus_[i] <= 0.0;
    if (!fixed && information_(i, i) > 0.0) continue;
    information_.row(i).setZero();
    information_.col(i).setZero();
    information_(i, i) = 1.0;
    surplus_[i] = 0.0;
  }
  const Eigen::LDLT<MatrixXd> factors(information_);
  const VectorXd step = factors.solve(surplus_);
  const MatrixXd covariance = factors.solve(MatrixXd::Identity(step.size(), step.size()));
  for (Index i = 0; i < step.size(); ++i) {
    double& spread = spread_m[static_cast<std::size_t>(i)];
    double variance = std::max(spread * spread + step[i], 0.0);
    const double chance = kSignificance * std::sqrt(2.0 * std::max(0.0, covariance(i, i)));
    if (only_significant && knows_sensor_[static_cast<std::size_t>(i)] != 0 && variance < chance)
      variance = 0.0;
    spread = std::sqrt(variance);
  }
  keepUnknownSensorsAlike(spread_m);
}

/// Where the spread stands for the sensor no marker can be much surer than the others; poses that follow one
/// of them alone would make it look so.
void SpreadEstimator::keepUnknownSensorsAlike(std::vector<double>& spread_m) const {
  std::vector<double> sorted = spread_m;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (std::size_t i = 0; i < spread_m.size(); ++i)
    if (knows_sensor_[i] == 0) spread_m[i] = std::max(spread_m[i], kLeastShareOfMedian * *middle);
}

void SpreadEstimator::score(std::span<const NetworkTerm> terms, std::size_t markers) {
  position_covariance_m2_.assign(markers, Matrix3d::Zero());
  knows_sensor_.assign(markers, 1);
  for (const auto& term : terms) {
    const auto marker = static_cast<std::size_t>(term.marker);
    position_covariance_m2_[marker] += term.trust * term.weight;
    if (term.sensor_T.trace() <= 0.0) knows_sensor_[marker] = 0;
  }
  for (auto& m : position_covariance_m2_)
    if (m.trace() > 0.0) m = m.inverse().eval();
  // Positions take all their coordinates but a common motion.
  share_ = 1.0 - 2.0 / static_cast<double>(markers);
  surplus_.setZero(static_cast<Index>(markers));
  information_.setZero(static_cast<Index>(markers), static_cast<Index>(markers));
  for (std::size_t first = 0, next = 0; first < terms.size(); first = next) {
    while (next < terms.size() && terms[next].frame == terms[first].frame) ++next;
    scoreFrame(terms.subspan(first, next - first));
  }
}

void SpreadEstimator::scoreFrame(std::span<const NetworkTerm> terms) {
  for (const auto& a : terms) {
    if (a.trust <= 0.0) continue;
    const Matrix3d W = a.trust * a.weight;
    const Matrix3d& position = position_covariance_m2_[static_cast<std::size_t>(a.marker)];
    const Matrix3d own = W - a.lever.transpose() * a.pull - share_ * W * position * W;
    surplus_[a.marker] += a.trust * (a.weight * a.residual_T).squaredNorm() - own.trace();
    information_(a.marker, a.marker) += own.squaredNorm();
    for (const auto& b : terms)
      if (b.marker != a.marker && b.trust > 0.0)
        information_(a.marker, b.marker) += (a.lever.transpose() * b.pull).squaredNorm();
  }
}

std::vector<double> correlationTimes(std::span<const NetworkTerm> terms, std::size_t markers) {
  std::vector<double> times;
  for (const auto& residuals : residualsByMarker(terms, markers)) times.push_back(correlationTime(residuals));
  return times;
}

}  // namespace mirrorarm::tracking
