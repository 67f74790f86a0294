#include "core/tracking/deviation_fit.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMostRounds = 4;
constexpr double kMedianOfChi2 = 0.789;  // of a chi-square of 3 degrees, for one degree
constexpr double kFullWeight = 4.0;      // squares, in units of what is expected
constexpr double kNoWeight = 25.0;
constexpr double kLeastStep_m2 = 1e-20;

}  // namespace

void DeviationFit::run(std::span<SeenMarker> seen, const DeviationModes& modes, const Prior& prior) {
  rows_.clear();
  information_.clear();
  for (SeenMarker& marker : seen) {
    Rows rows;
    rows << motionAt(marker.place_T), modes.of(marker.marker);
    rows_.push_back(rows);
    information_.push_back(marker.covariance_m2.inverse());
    marker.weight = marker.counts ? 1.0 : 0.0;
  }
  const bool modes_move = prior.mode_steps_m2.maxCoeff() > 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    if (modes_move)
      solve<kUnknowns>(seen, prior);
    else
      solve<6>(seen, prior);
    if (!reweight(seen)) break;
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i].fitted_m2 = seen[i].weight * rows_[i] * covariance_ * rows_[i].transpose();
}

/// For the first Size unknowns; the others stay zero.
template <int Size>
void DeviationFit::solve(std::span<const SeenMarker> seen, const Prior& prior) {
  using Square = Eigen::Matrix<double, Size, Size>;
  Square normal = Square::Zero();
  normal.template topLeftCorner<6, 6>() = prior.motion_information;
  normal.diagonal().template tail<Size - 6>() =
      prior.mode_steps_m2.template head<Size - 6>().cwiseMax(kLeastStep_m2).cwiseInverse();
  Eigen::Matrix<double, Size, 1> right = Eigen::Matrix<double, Size, 1>::Zero();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].weight <= 0.0) continue;
    const Eigen::Matrix<double, 3, Size> rows = rows_[i].template leftCols<Size>();
    const Eigen::Matrix<double, Size, 3> gain = seen[i].weight * rows.transpose() * information_[i];
    normal += gain.lazyProduct(rows);
    right += gain.lazyProduct(seen[i].innovation);
  }
  const Eigen::LDLT<Square> solver(normal);
  covariance_.setZero();
  covariance_.template topLeftCorner<Size, Size>() = solver.solve(Square::Identity());
  unknowns_.setZero();
  unknowns_.template head<Size>() = solver.solve(right);
}

/// Full weight where the misfit is as expected, or as with most of the others; false when nothing changed.
bool DeviationFit::reweight(std::span<SeenMarker> seen) {
  squares_.clear();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    seen[i].left_over = seen[i].innovation - rows_[i] * unknowns_;
    if (seen[i].counts) squares_.push_back(seen[i].left_over.dot(information_[i] * seen[i].left_over) / 3.0);
  }
  const auto middle = squares_.begin() + static_cast<std::ptrdiff_t>(squares_.size() / 2);
  std::nth_element(squares_.begin(), middle, squares_.end());
  const double scale = std::max(1.0, *middle / kMedianOfChi2);
  bool changed = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].counts) continue;
    const double square = seen[i].left_over.dot(information_[i] * seen[i].left_over) / (3.0 * scale);
    const double weight = square <= kFullWeight ? 1.0 : square >= kNoWeight ? 0.0 : kFullWeight / square;
    changed = changed || weight != seen[i].weight;
    seen[i].weight = weight;
  }
  return changed;
}

}  // namespace mirrorarm::tracking
