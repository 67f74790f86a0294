#include "core/calibration/model_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirrorarm::calibration {
namespace {

using camera::LensModel;

Expected<ModelSolution, CalibrationRefusal> solveWith(LensModel model, const Board& board,
                                                      std::span<const BoardView> views, ImageSize size,
                                                      CameraCount cameras, Crossing crossing) {
  auto solved = solveViews(board, views, size, model, cameras);
  if (!solved) return unexpected(solved.error());
  auto crossed = crossValidate(board, views, *solved);
  if (crossed) return ModelSolution{std::move(*solved), std::move(*crossed)};
  if (crossing == Crossing::kRequired) return unexpected(crossed.error());
  return ModelSolution{std::move(*solved), std::nullopt};
}

/// Misfit of view `i` under a rig not solved from it: a model cannot win by leaving out what it does badly.
double heldOutMisfit_px(const ModelSolution& solution, const Board& board, const BoardView& view,
                        std::size_t i) {
  const auto& used = solution.solved.used;
  const auto at = std::find(used.begin(), used.end(), i);
  const HoldOut figures = at != used.end()
                              ? solution.crossed->views[static_cast<std::size_t>(at - used.begin())]
                              : measureHoldOut(rigOf(solution.solved.fit.bundle), board, {&view, 1});
  return figures.views > 0 ? figures.reprojection_px : std::numeric_limits<double>::infinity();
}

std::vector<std::size_t> usedByAny(const std::vector<ModelSolution>& solutions) {
  std::vector<std::size_t> all;
  for (const auto& solution : solutions)
    all.insert(all.end(), solution.solved.used.begin(), solution.solved.used.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

ModelTrial trialOf(const ModelSolution& solution, const Board& board, std::span<const BoardView> views,
                   const std::vector<std::size_t>& compared) {
  ModelTrial trial{solution.solved.fit.bundle.cameras[0].model, solution.solved.fit.total_rms_px, 0.0, 0.0};
  if (!solution.crossed) return trial;
  double squares = 0.0;
  for (const auto i : compared) squares += std::pow(heldOutMisfit_px(solution, board, views[i], i), 2);
  trial.hold_out_epipolar_px = solution.crossed->figures.epipolar_px;
  trial.hold_out_px = std::sqrt(squares / static_cast<double>(compared.size()));
  return trial;
}

}  // namespace

Expected<ModelChoice, CalibrationRefusal> chooseModel(const Board& board, std::span<const BoardView> views,
                                                      ImageSize size, std::optional<LensModel> model,
                                                      CameraCount cameras, Crossing crossing) {
  if (!model) crossing = Crossing::kRequired;
  std::vector<ModelSolution> solutions;
  CalibrationRefusal refusal{CalibrationError::kTooFewViews, {}};
  for (const auto tried : {LensModel::kBrownConrady, LensModel::kKannalaBrandt}) {
    if (model && *model != tried) continue;
    auto solution = solveWith(tried, board, views, size, cameras, crossing);
    if (solution)
      solutions.push_back(std::move(*solution));
    else if (solution.error().error >= refusal.error)
      refusal = std::move(solution.error());
  }
  if (solutions.empty()) return unexpected(std::move(refusal));
  ModelChoice choice;
  const auto compared = usedByAny(solutions);
  for (const auto& solution : solutions) choice.trials.push_back(trialOf(solution, board, views, compared));
  const auto best = std::min_element(
      choice.trials.begin(), choice.trials.end(),
      [](const ModelTrial& a, const ModelTrial& b) { return a.hold_out_px < b.hold_out_px; });
  choice.best = std::move(solutions[static_cast<std::size_t>(best - choice.trials.begin())]);
  return choice;
}

}  // namespace mirrorarm::calibration
