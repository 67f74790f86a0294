#include "core/calibration/board_shape.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "core/calibration/bundle_equations.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestViews = 5;
constexpr double kSignificant = 4.0;  ///< standard deviations
constexpr double kBent_m = 1e-4;      ///< what matters at the accuracy aimed at
constexpr double kStretched_percent = 0.1;

/// Indices of the points that any view shows.
std::vector<Eigen::Index> seenPoints(const RobustFit& fit, std::size_t count) {
  std::vector<bool> seen(count, false);
  for (const auto& view : fit.used)
    for (const auto& sighting : view.seen)
      for (const auto& point : sighting) seen[static_cast<std::size_t>(point.point)] = true;
  std::vector<Eigen::Index> points;
  for (std::size_t i = 0; i < count; ++i)
    if (seen[i]) points.push_back(static_cast<Eigen::Index>(i));
  return points;
}

/// Orthonormal directions in which heights (all but the last number) leave a plane, and the stretch (last).
/// What lifts or tilts the board as a whole belongs to its poses.
Eigen::MatrixXd freeDirections(std::span<const Eigen::Vector3d> board,
                               const std::vector<Eigen::Index>& points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd plane(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& p = board[static_cast<std::size_t>(points[static_cast<std::size_t>(i)])];
    plane.row(i) << 1.0, p.x(), p.y();
  }
  const Eigen::MatrixXd Q = plane.householderQr().householderQ();
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(count + 1, count - 2);
  free.topLeftCorner(count, count - 3) = Q.rightCols(count - 3);
  free(count, count - 3) = 1.0;
  return free;
}

struct Deviation {
  Eigen::VectorXd heights_m;
  double height_variance_m2 = 0.0;  ///< mean over the points
  double stretch = 0.0;
  double stretch_variance = 0.0;
};

std::optional<Deviation> deviationOf(const NormalEquations& board_equations, const Eigen::MatrixXd& free,
                                     const std::vector<Eigen::Index>& which, double variance_factor) {
  const Eigen::MatrixXd normal = board_equations.matrix(which, which);
  const Eigen::VectorXd gradient = board_equations.gradient(which);
  const auto inverse = inverseOf(free.transpose() * normal * free);
  if (!inverse) return std::nullopt;
  const Eigen::VectorXd deviation = -free * (*inverse * (free.transpose() * gradient));
  const Eigen::VectorXd variance = variance_factor * (free * *inverse * free.transpose()).diagonal();
  const Eigen::Index heights = deviation.size() - 1;
  return Deviation{deviation.head(heights), variance.head(heights).mean(), deviation[heights],
                   variance[heights]};
}

}  // namespace

std::optional<BoardShape> boardShape(const RobustFit& fit, std::span<const Eigen::Vector3d> board) {
  auto which = seenPoints(fit, board.size());
  if (fit.used.size() < kFewestViews || which.size() < 4) return std::nullopt;
  const auto equations = normalEquations(fit.bundle, board, fit.used, true);
  if (!equations) return std::nullopt;
  const auto board_equations = reduced(*equations, static_cast<Eigen::Index>(board.size()) + 1);
  if (!board_equations) return std::nullopt;
  const auto free = freeDirections(board, which);
  which.push_back(static_cast<Eigen::Index>(board.size()));  // the stretch
  const auto deviation = deviationOf(*board_equations, free, which, fit.variance_factor);
  if (!deviation) return std::nullopt;
  BoardShape shape;
  shape.flatness_rms_m =
      std::sqrt(deviation->heights_m.squaredNorm() / static_cast<double>(deviation->heights_m.size()));
  shape.flatness_sigma_m = std::sqrt(deviation->height_variance_m2);
  shape.stretch_percent = 100.0 * deviation->stretch;
  shape.stretch_sigma_percent = 100.0 * std::sqrt(deviation->stretch_variance);
  shape.is_bent =
      shape.flatness_rms_m > kBent_m && shape.flatness_rms_m > kSignificant * shape.flatness_sigma_m;
  shape.is_stretched = std::abs(shape.stretch_percent) > kStretched_percent &&
                       std::abs(shape.stretch_percent) > kSignificant * shape.stretch_sigma_percent;
  return shape;
}

}  // namespace mirrorarm::calibration
