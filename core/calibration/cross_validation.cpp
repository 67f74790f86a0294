#include "core/calibration/cross_validation.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kFewestViews = 4;
constexpr std::size_t kParts = 3;

/// The rig from all views but those of one part. The full solution is only where the search starts.
std::optional<camera::StereoRig> rigWithout(std::size_t part, std::size_t parts, const Board& board,
                                            std::span<const BoardView> views, const SolvedViews& solved) {
  Bundle start = solved.fit.bundle;
  start.X_CM.clear();
  std::vector<BoardView> others;
  for (std::size_t i = 0; i < solved.used.size(); ++i) {
    if (i % parts == part) continue;
    start.X_CM.push_back(solved.fit.bundle.X_CM[i]);
    others.push_back(views[solved.used[i]]);
  }
  const auto fit = fitRobustly(start, boardPoints(board), others);
  return fit ? std::optional(rigOf(fit->bundle)) : std::nullopt;
}

}  // namespace

Expected<CrossValidation, CalibrationRefusal> crossValidate(const Board& board,
                                                            std::span<const BoardView> views,
                                                            const SolvedViews& solved) {
  const std::size_t count = solved.used.size();
  if (count < kFewestViews) return unexpected(CalibrationRefusal{CalibrationError::kTooFewViews, {}});
  const std::size_t parts = count < 2 * kParts ? count : kParts;
  CrossValidation result;
  result.views.resize(count);
  HoldOutMeter all;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto rig = rigWithout(part, parts, board, views, solved);
    if (!rig) return unexpected(CalibrationRefusal{CalibrationError::kNotSolved, {}});
    for (std::size_t i = part; i < count; i += parts) {
      HoldOutMeter one;
      one.add(*rig, board, views[solved.used[i]]);
      result.views[i] = one.figures();
      all.add(*rig, board, views[solved.used[i]]);
    }
  }
  result.figures = all.figures();
  result.figures.parts = parts;
  return result;
}

}  // namespace mirrorarm::calibration
