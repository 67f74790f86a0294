#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/calibration/bundle.h"

namespace mirrorarm::calibration {

/// Normal equations of a bundle at one point, every point weighted by its sigma_px (0: by 1 px): the step is
/// -matrix^-1 gradient, its covariance the inverse times the variance factor.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;
  double squares = 0.0;    ///< weighted
  std::size_t points = 0;  ///< two rows each
};

/// Numbers in this order: height of each board point over the board [m] and the stretch of its steps along
/// the rows against those from row to row (`with_board` alone), LensNumbers of each camera, small motion of
/// the bar, of each view's pose. Nothing when a point cannot be projected.
[[nodiscard]] std::optional<NormalEquations> normalEquations(const Bundle& bundle,
                                                             std::span<const Eigen::Vector3d> board,
                                                             std::span<const BoardView> views,
                                                             bool with_board = false);

/// How many numbers the views share: lenses and bar.
[[nodiscard]] Eigen::Index sharedTerms(const Bundle& bundle);

/// The equations of the first `keep` numbers, the others eliminated. Nothing where the others are not fixed.
[[nodiscard]] std::optional<NormalEquations> reduced(const NormalEquations& equations, Eigen::Index keep);

/// Inverse of a normal matrix; nothing when what it belongs to is not fixed.
[[nodiscard]] std::optional<Eigen::MatrixXd> inverseOf(const Eigen::MatrixXd& normal);

}  // namespace mirrorarm::calibration
