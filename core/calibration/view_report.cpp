#include "core/calibration/view_report.h"

#include <cmath>

#include "core/calibration/board_pose.h"
#include "core/calibration/lens_numbers.h"

namespace mirrorarm::calibration {

ViewResidual heldOutResidual(const camera::StereoRig& rig, const Board& board, const BoardView& view) {
  ViewResidual residual;
  residual.name = view.name;
  residual.is_held_out = true;
  residual.hold_out = measureHoldOut(rig, board, {&view, 1});
  residual.rms_px = residual.hold_out->reprojection_px;
  return residual;
}

std::vector<ViewResidual> residualsOf(const ModelSolution& solution, const Board& board,
                                      std::span<const BoardView> views) {
  const auto rig = rigOf(solution.solved.fit.bundle);
  std::vector<ViewResidual> residuals;
  for (const auto& view : views) residuals.push_back({view.name, 0.0, false, false, 0, std::nullopt});
  for (std::size_t i = 0; i < solution.solved.used.size(); ++i) {
    auto& residual = residuals[solution.solved.used[i]];
    residual.rms_px = solution.solved.fit.rms_px[i];
    residual.outlier_points = solution.solved.fit.outlier_points[i];
    if (solution.crossed) residual.hold_out = solution.crossed->views[i];
  }
  for (const auto i : solution.solved.outliers) {
    residuals[i] = heldOutResidual(rig, board, views[i]);
    residuals[i].is_held_out = false;
    residuals[i].is_outlier = true;
  }
  return residuals;
}

std::vector<std::string> outlierNames(const SolvedViews& solved, std::span<const BoardView> views) {
  std::vector<std::string> names;
  for (const auto i : solved.outliers) names.push_back(views[i].name);
  return names;
}

LensSigma lensSigmaOf(const RobustFit& fit, std::size_t k) {
  LensSigma sigma;
  if (!fit.covariance) return sigma;
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < k; ++i) first += lensTerms(fit.bundle.cameras[i].model);
  const Eigen::VectorXd deviations =
      fit.covariance->diagonal().segment(first, lensTerms(fit.bundle.cameras[k].model)).cwiseSqrt();
  sigma.fx_px = deviations[0];
  sigma.fy_px = deviations[1];
  sigma.cx_px = deviations[2];
  sigma.cy_px = deviations[3];
  for (Eigen::Index i = kPinholeTerms; i < deviations.size(); ++i)
    sigma.distortion[static_cast<std::size_t>(i - kPinholeTerms)] = deviations[i];
  return sigma;
}

Eigen::Matrix<double, 6, 1> barSigmaOf(const RobustFit& fit) {
  if (!fit.covariance) return Eigen::Matrix<double, 6, 1>::Zero();
  return fit.covariance->diagonal().tail<6>().cwiseSqrt();
}

}  // namespace mirrorarm::calibration
