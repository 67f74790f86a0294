#include "core/calibration/next_view.h"

#include <algorithm>
#include <vector>

#include <Eigen/Dense>

#include "core/calibration/candidate_views.h"
#include "core/calibration/view_information.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kPointsAlongRow = 4;

/// Few points tell as well as all which view is the best.
std::vector<Eigen::Vector3d> spreadPoints(const Board& board) {
  const auto all = boardPoints(board);
  const auto columns = static_cast<std::size_t>(board.columns), rows = static_cast<std::size_t>(board.rows);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < kPointsAlongRow; ++i)
    for (std::size_t j = 0; j < kPointsAlongRow; ++j)
      points.push_back(
          all[i * (rows - 1) / (kPointsAlongRow - 1) * columns + j * (columns - 1) / (kPointsAlongRow - 1)]);
  return points;
}

double logDeterminant(const Eigen::MatrixXd& information) {
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(information);
  return ldlt.vectorD().array().max(1e-300).log().sum();
}

/// `informationOf` gives what a view tells; `known` is what the views so far told.
template <class InformationOf>
std::optional<ViewWish> bestOf(std::span<const RigidTransform> candidates, const Eigen::MatrixXd& known,
                               const InformationOf& informationOf, const Reachable& reachable) {
  const double before = logDeterminant(known);
  std::vector<ViewWish> wishes;
  for (const auto& X_CM : candidates)
    wishes.push_back({X_CM, logDeterminant(known + informationOf(X_CM)) - before});
  std::ranges::stable_sort(wishes, std::greater(), &ViewWish::gain);
  const auto best = std::ranges::find_if(wishes, [&](const ViewWish& wish) { return reachable(wish.X_CM); });
  return best == wishes.end() ? std::nullopt : std::optional(*best);
}

}  // namespace

std::optional<ViewWish> nextStereoView(const camera::StereoRig& rig, const Board& board,
                                       std::span<const RigidTransform> X_CM_taken,
                                       const Reachable& reachable) {
  const auto points = spreadPoints(board);
  const RigInformation information(rig, points);
  Eigen::MatrixXd known = information.prior();
  for (const auto& X_CM : X_CM_taken) known += information.of(X_CM);
  return bestOf(
      candidateViews(rig, points, static_cast<int>(X_CM_taken.size())), known,
      [&](const RigidTransform& X_CM) { return information.of(X_CM); }, reachable);
}

std::optional<ViewWish> nextHandEyeView(const camera::StereoRig& rig, const Board& board,
                                        std::span<const RigidTransform> X_CM_taken,
                                        const Reachable& reachable) {
  Eigen::MatrixXd known = HandEyeInformation::prior();
  for (const auto& X_CM : X_CM_taken) known += HandEyeInformation::of(X_CM);
  return bestOf(candidateViews(rig, spreadPoints(board), static_cast<int>(X_CM_taken.size())), known,
                &HandEyeInformation::of, reachable);
}

}  // namespace mirrorarm::calibration
