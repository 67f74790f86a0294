#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/bundle.h"

namespace mirrorarm::calibration {

/// A bundle that single bad points do not bend, and what it is worth.
struct RobustFit {
  Bundle bundle;
  std::vector<BoardView> used;      ///< as solved: physical centres of the discs, without the outlier points
  std::vector<int> outlier_points;  ///< a view each: points farther off than the noise explains
  std::vector<double> misfit_px;    ///< a view each: median distance over all its points, outliers too
  std::vector<double> rms_px;       ///< a view each: distance of a point used from its projection
  double total_rms_px = 0.0;        ///< over all points used
  double variance_factor = 0.0;     ///< of the points' sigma_px squared, or of 1 px^2 where unknown
  /// Of the numbers that the views share: LensNumbers of each camera, small motion of the bar. Nothing when
  /// the views do not fix them.
  std::optional<Eigen::MatrixXd> covariance;
};

/// Refines `start` in rounds: each finds how far the outlines' centres of discs lie from the discs' own and
/// which points stray, from the solution so far, then solves anew. The noise is taken from the residuals'
/// median; points beyond 5 standard deviations are left out, those beyond 2.5 pull no harder than there
/// (Huber). Nothing when the bundle cannot be adjusted.
[[nodiscard]] std::optional<RobustFit> fitRobustly(const Bundle& start,
                                                   std::span<const Eigen::Vector3d> board,
                                                   std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
