#include "core/calibration/board_hand_eye.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/board_pose.h"
#include "core/calibration/hand_eye_pixels.h"
#include "core/calibration/hand_eye_residuals.h"
#include "core/calibration/worst_axis.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kNoticedInSigmas = 3.0;
constexpr double kNoticedShare = 0.002;
constexpr double kLeastPixelSigma = 0.005;

/// The stations whose board could be posed, and their places among all.
struct PosedStations {
  std::vector<std::size_t> places;
  std::vector<PosePair> pairs;
  std::vector<BoardView> centres;
  double sigma_px = 0.0;  ///< of a point along either axis
};

PosedStations poseStations(const camera::StereoRig& rig, const Board& board,
                           std::span<const HandEyeStation> stations) {
  PosedStations posed;
  double squares_px2 = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto pose = poseBoard(rig, board, stations[i].view);
    if (!pose) continue;
    posed.places.push_back(i);
    posed.pairs.push_back({stations[i].X_BF, pose->X_CM});
    posed.centres.push_back(pose->centres);
    squares_px2 += 0.5 * pose->rms_px * pose->rms_px;
  }
  if (!posed.places.empty())
    posed.sigma_px =
        std::max(kLeastPixelSigma, std::sqrt(squares_px2 / static_cast<double>(posed.places.size())));
  return posed;
}

/// The view of a board half a turn round, its points counted from the other end.
void turnBack(BoardView& view, std::size_t points) {
  for (auto& sighting : view.seen) {
    for (auto& seen : sighting) seen.point = static_cast<int>(points) - 1 - seen.point;
    std::reverse(sighting.begin(), sighting.end());
  }
}

bool contains(const std::vector<std::size_t>& places, std::size_t place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

/// What the pixels are fitted over: the stations that do not contradict.
std::vector<HandEyeStation> usedStations(const PosedStations& posed, const HandEyeSolution& start,
                                         std::size_t points) {
  std::vector<HandEyeStation> used;
  for (std::size_t i = 0; i < posed.pairs.size(); ++i) {
    if (contains(start.outliers, i)) continue;
    used.push_back({posed.centres[i], posed.pairs[i].X_BF});
    if (contains(start.turned, i)) turnBack(used.back().view, points);
  }
  return used;
}

bool isNoticed(const PixelFit& fit) {
  const double off = std::abs(fit.scale - 1.0);
  return off > kNoticedInSigmas * fit.scale_sigma && off > kNoticedShare;
}

/// Counts a posed station's place among all.
void renumber(const PosedStations& posed, std::vector<std::size_t>& stations) {
  for (auto& station : stations) station = posed.places[station];
}

/// Residuals of all stations given, those without a pose as outliers.
void spread(const PosedStations& posed, std::size_t count, HandEyeSolution& solution) {
  std::vector<StationResidual> all(count, StationResidual{0.0, 0.0, true});
  for (std::size_t i = 0; i < posed.places.size(); ++i) all[posed.places[i]] = solution.stations[i];
  solution.stations = std::move(all);
  renumber(posed, solution.turned);
  solution.outliers.clear();
  for (std::size_t i = 0; i < count; ++i)
    if (solution.stations[i].is_outlier) solution.outliers.push_back(i);
}

void turnPairsBack(const Board& board, const HandEyeSolution& solution, std::vector<PosePair>& pairs) {
  const auto points = boardPoints(board);
  RigidTransform half_turn = RigidTransform::Identity();
  half_turn.linear().diagonal() << -1.0, -1.0, 1.0;
  half_turn.translation() = points.front() + points.back();
  for (const auto station : solution.turned) pairs[station].X_CM = pairs[station].X_CM * half_turn;
}

BoardHandEye resultOf(const PosedStations& posed, std::vector<PosePair> pairs, const PixelFit& fit,
                      HandEyeSolution solution, CameraMount mount, std::size_t count) {
  solution.X_PC = fit.X_PC;
  solution.covariance = fit.covariance;
  solution.sigma_m = worstAxisSigma(fit.covariance.bottomRightCorner<3, 3>());
  fillResiduals(asInHand(pairs, mount), solution);
  solution.X_QM = fit.X_QM;
  BoardHandEye result;
  result.rms_px = fit.rms_px;
  result.stations_px.resize(count);
  std::size_t used = 0;
  for (std::size_t i = 0; i < posed.places.size(); ++i)
    if (!contains(solution.outliers, i)) result.stations_px[posed.places[i]] = fit.stations_px[used++];
  spread(posed, count, solution);
  result.hand_eye = std::move(solution);
  return result;
}

}  // namespace

Expected<BoardHandEye, HandEyeRefusal> refineHandEye(const camera::StereoRig& rig, const Board& board,
                                                     std::span<const HandEyeStation> stations,
                                                     CameraMount mount, const RobotNoise& robot) {
  const auto posed = poseStations(rig, board, stations);
  const auto start = solveHandEye(posed.pairs, mount);
  if (!start) {
    auto refusal = start.error();
    renumber(posed, refusal.stations);
    return unexpected(std::move(refusal));
  }
  const auto points = boardPoints(board);
  const PixelProblem problem{rig,   points, usedStations(posed, *start, points.size()),
                             mount, robot,  posed.sigma_px};
  const auto as_said = fitPixels(problem, {start->X_PC, start->X_QM}, false);
  const auto scaled = as_said ? fitPixels(problem, {as_said->X_PC, as_said->X_QM}, true) : std::nullopt;
  if (!scaled) return unexpected(HandEyeRefusal{HandEyeError::kNotSolved, {}});
  auto pairs = posed.pairs;
  Board measured = board;
  if (isNoticed(*scaled)) {
    measured.spacing_m *= scaled->scale;
    const auto again = poseStations(rig, measured, stations);
    if (again.places == posed.places) pairs = again.pairs;
  }
  turnPairsBack(measured, *start, pairs);
  auto result = resultOf(posed, std::move(pairs), isNoticed(*scaled) ? *scaled : *as_said, *start, mount,
                         stations.size());
  result.board = {scaled->scale, scaled->scale_sigma, isNoticed(*scaled)};
  return result;
}

}  // namespace mirrorarm::calibration
