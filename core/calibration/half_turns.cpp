#include "core/calibration/half_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/calibration/contradicting_stations.h"
#include "core/calibration/median.h"
#include "core/calibration/relative_motion.h"
#include "core/calibration/station_misfit.h"
#include "core/calibration/tsai_lenz.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kClearly_rad = 20.0 * kDegree;     ///< a difference of angles that counts as a whole vote
constexpr double kLargestRest_rad = 3.0 * kDegree;  ///< of a half turn once undone
constexpr double kLeastGain_rad = 10.0 * kDegree;
constexpr std::size_t kFewestRight = 4;
constexpr double kLeastAgreement_m = 0.002;
constexpr double kAgreementInMisfits = 6.0;

RigidTransform halfTurn(const Eigen::Vector2d& far_corner_m) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R(0, 0) = R(1, 1) = -1.0;
  return makeTransform(R, Eigen::Vector3d(far_corner_m.x(), far_corner_m.y(), 0.0));
}

/// How badly the angles of robot and camera agree between two stations, as they are and with one of the two
/// boards turned back [rad].
struct AngleMisfit {
  Eigen::MatrixXd as_seen;
  Eigen::MatrixXd turned;
};

AngleMisfit angleMisfit(std::span<const PosePair> pairs) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  AngleMisfit misfit{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  const RigidTransform H = halfTurn(Eigen::Vector2d::Zero());
  for (const auto& motion : relativeMotions(pairs)) {
    const auto i = static_cast<Eigen::Index>(motion.i), j = static_cast<Eigen::Index>(motion.j);
    const double robot_rad = rotationVector(motion.A.linear()).norm();
    misfit.as_seen(i, j) = misfit.as_seen(j, i) =
        std::abs(angleBetween(pairs[motion.i].X_CM.inverse(), pairs[motion.j].X_CM.inverse()) - robot_rad);
    const RigidTransform B = pairs[motion.j].X_CM * H * pairs[motion.i].X_CM.inverse();
    misfit.turned(i, j) = misfit.turned(j, i) = std::abs(rotationVector(B.linear()).norm() - robot_rad);
  }
  return misfit;
}

/// Stations in two parts by the votes of all pairs; true for the smaller one.
std::vector<bool> smallerPart(const AngleMisfit& misfit) {
  const Eigen::MatrixXd votes =
      ((misfit.turned - misfit.as_seen) / kClearly_rad).cwiseMin(1.0).cwiseMax(-1.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(votes);
  const Eigen::VectorXd side = parts.eigenvectors().rightCols<1>();
  const auto negative = (side.array() < 0.0).count();
  const bool is_negative_smaller = 2 * negative < side.size() || (2 * negative == side.size() && side[0] > 0);
  std::vector<bool> smaller;
  for (const double value : side) smaller.push_back((value < 0.0) == is_negative_smaller);
  return smaller;
}

/// A station is turned when undoing it makes the angles agree that did not, with most stations of the larger
/// part.
bool isTurned(const AngleMisfit& misfit, const std::vector<bool>& smaller, std::size_t station) {
  std::vector<double> as_seen, turned;
  for (std::size_t other = 0; other < smaller.size(); ++other) {
    if (smaller[other]) continue;
    const auto i = static_cast<Eigen::Index>(station), j = static_cast<Eigen::Index>(other);
    as_seen.push_back(misfit.as_seen(i, j));
    turned.push_back(misfit.turned(i, j));
  }
  return median(turned) < kLargestRest_rad && median(as_seen) > median(turned) + kLeastGain_rad;
}

std::vector<std::size_t> turnedStations(std::span<const PosePair> pairs) {
  const auto misfit = angleMisfit(pairs);
  const auto smaller = smallerPart(misfit);
  std::vector<std::size_t> turned;
  for (std::size_t i = 0; i < smaller.size(); ++i)
    if (smaller[i] && isTurned(misfit, smaller, i)) turned.push_back(i);
  return turned;
}

bool contains(std::span<const std::size_t> sorted, std::size_t station) {
  return std::binary_search(sorted.begin(), sorted.end(), station);
}

std::vector<PosePair> rightStations(std::span<const PosePair> pairs, std::span<const std::size_t> turned) {
  std::vector<PosePair> right;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!contains(turned, i)) right.push_back(pairs[i]);
  return right;
}

Eigen::Vector3d medianOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const auto& point : points) values.push_back(point[axis]);
    middle[axis] = median(std::move(values));
  }
  return middle;
}

std::optional<Eigen::Vector2d> farCorner(std::span<const PosePair> pairs,
                                         std::span<const std::size_t> turned) {
  auto right = rightStations(pairs, turned);
  const auto contradicting = contradictingStations(right);
  if (right.size() < kFewestRight + contradicting.size()) return std::nullopt;
  right = rightStations(right, contradicting);
  const auto X_FC = tsaiLenzOverAllPairs(right);
  if (!X_FC) return std::nullopt;
  const auto misfit = stationMisfit(right, *X_FC);
  const double tolerance_m = std::max(kLeastAgreement_m, kAgreementInMisfits * misfit.rms_m());
  std::vector<Eigen::Vector3d> corners;
  for (const auto station : turned) {
    const RigidTransform X_BM = pairs[station].X_BF * *X_FC * pairs[station].X_CM;
    corners.emplace_back(X_BM.inverse() * misfit.X_BM.translation());
  }
  const Eigen::Vector3d corner = medianOf(corners);
  if (std::abs(corner.z()) > tolerance_m) return std::nullopt;
  return corner.head<2>();
}

}  // namespace

HalfTurns findHalfTurns(std::span<const PosePair> pairs) {
  HalfTurns turns;
  if (pairs.size() < 2) return turns;
  turns.stations = turnedStations(pairs);
  if (!turns.stations.empty()) turns.far_corner_m = farCorner(pairs, turns.stations);
  return turns;
}

void undoHalfTurns(std::span<PosePair> pairs, const HalfTurns& turns) {
  const RigidTransform H = halfTurn(turns.far_corner_m.value_or(Eigen::Vector2d::Zero()));
  for (const auto station : turns.stations) pairs[station].X_CM = pairs[station].X_CM * H;
}

}  // namespace mirrorarm::calibration
