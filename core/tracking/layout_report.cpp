#include "core/tracking/layout_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include <Eigen/Dense>

#include "core/geometry/small_motion.h"
#include "core/tracking/layout.h"
#include "core/tracking/shared_shape.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kNearLine_m = 0.005;
constexpr double kNearInDiameters = 1.5;
constexpr double kFlat_m = 0.002;
constexpr double kPoorTurn_rad = 0.25 * std::numbers::pi / 180.0;
// A tracker accepts 3 mm (paper); commercial 4-marker bodies keep 2.9 mm and more between their poses.
constexpr double kSymmetricRms_m = 0.0025;
constexpr double kDistanceInRms = 2.2;  // the farthest distance of a fit that is just accepted
constexpr double kTellable_m = 0.001;   // what the tracker's tolerance and the sensor leave of two distances
constexpr int kProof = 4;               // markers that a search from nothing needs
constexpr double kSeenShare = 0.5;      // that a tracker asks for
// Of one point at 0.4 m, centres measured to 0.02 px: across the sight and along it.
constexpr double kAcross_m = 0.000014, kAlong_m = 0.000071;

/// Spread along the principal directions, the largest first, with the directions as columns.
struct Spread {
  Vector3d rms_m = Vector3d::Zero();
  Matrix3d axes = Matrix3d::Identity();
  Vector3d centre = Vector3d::Zero();
};

Spread spreadOf(std::span<const Vector3d> points) {
  Spread spread;
  const auto count = static_cast<double>(points.size());
  for (const auto& p : points) spread.centre += p / count;
  Matrix3d scatter = Matrix3d::Zero();
  for (const auto& p : points) scatter += (p - spread.centre) * (p - spread.centre).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter);
  spread.rms_m = solver.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
  spread.axes = solver.eigenvectors().rowwise().reverse();
  return spread;
}

/// Of the worst axis, about the markers' centroid, the thinnest direction along the sight.
double turnSigma(std::span<const Vector3d> points, const Spread& spread) {
  const Vector3d weights = Vector3d(kAcross_m, kAcross_m, kAlong_m).cwiseAbs2().cwiseInverse();
  Matrix3d information = Matrix3d::Zero();
  for (const auto& point : points) {
    const Vector3d p = spread.axes.transpose() * (point - spread.centre);
    const Matrix3d lever = crossMatrix(p);
    information += lever.transpose() * weights.asDiagonal() * lever;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(information, Eigen::EigenvaluesOnly);
  return 1.0 / std::sqrt(std::max(solver.eigenvalues()[0], std::numeric_limits<double>::min()));
}

bool turnsOver(const RigidTransform& X, const Spread& spread) {
  const Vector3d normal = spread.axes.col(2);
  return spread.rms_m[2] < kFlat_m && normal.dot(X.linear() * normal) < 0.0;
}

int leastAccepted(std::size_t markers) {
  const auto share = static_cast<int>(std::ceil(kSeenShare * static_cast<double>(markers)));
  return std::max(share, std::min(kProof, static_cast<int>(markers)));
}

void judgeSpread(const Target& target, const Spread& spread, LayoutReport& report) {
  const double beside_line_m = std::hypot(spread.rms_m[1], spread.rms_m[2]);
  if (areCollinear(target.markers_T)) {
    report.issues.push_back(LayoutIssue::kCollinear);
  } else if (beside_line_m < kNearLine_m) {
    report.issues.push_back(LayoutIssue::kNearlyCollinear);
  } else if (report.turn_sigma_rad > kPoorTurn_rad) {
    report.issues.push_back(LayoutIssue::kPoorTurn);
  }
  if (report.smallest_distance_m < kNearInDiameters * target.marker_diameter_m)
    report.issues.push_back(LayoutIssue::kTooNear);
}

void judgeLikeness(const Target& target, const Spread& spread, LayoutReport& report) {
  const Likeness whole{kDistanceInRms * kSymmetricRms_m, kSymmetricRms_m, report.markers};
  const SharedShape symmetric = findSelfLikeness(target.markers_T, whole, 2.0 * kSymmetricRms_m);
  report.symmetric_rms_m = symmetric.rms_m;
  if (symmetric.markers > 0)
    report.issues.push_back(turnsOver(symmetric.X_YX, spread) ? LayoutIssue::kPlanarAmbiguous
                                                              : LayoutIssue::kSymmetric);
  const SharedShape part =
      findSelfLikeness(target.markers_T, {kTellable_m, kTellable_m, 3}, 2.0 * kTellable_m);
  report.alike_markers = part.markers;
  report.needed_markers = std::clamp(part.markers + 1, std::min(kProof, report.markers), report.markers);
  if (symmetric.markers == 0 && part.markers >= leastAccepted(target.markers_T.size()))
    report.issues.push_back(LayoutIssue::kAlikeInPart);
}

}  // namespace

std::string_view id(LayoutIssue issue) {
  switch (issue) {
    case LayoutIssue::kCollinear:
      return "collinear";
    case LayoutIssue::kNearlyCollinear:
      return "nearly_collinear";
    case LayoutIssue::kSymmetric:
      return "symmetric";
    case LayoutIssue::kPlanarAmbiguous:
      return "planar_ambiguous";
    case LayoutIssue::kAlikeInPart:
      return "alike_in_part";
    case LayoutIssue::kTooNear:
      return "too_near";
    case LayoutIssue::kPoorTurn:
      return "poor_turn";
  }
  return "collinear";
}

bool LayoutReport::has(LayoutIssue issue) const {
  return std::find(issues.begin(), issues.end(), issue) != issues.end();
}

LayoutReport checkLayout(const Target& target) {
  const Spread spread = spreadOf(target.markers_T);
  LayoutReport report;
  report.target = target.name;
  report.markers = static_cast<int>(target.markers_T.size());
  report.length_m = spread.rms_m[0];
  report.width_m = std::hypot(spread.rms_m[1], spread.rms_m[2]);
  report.thickness_m = spread.rms_m[2];
  report.smallest_distance_m = smallestDistance(target.markers_T);
  report.turn_sigma_rad = turnSigma(target.markers_T, spread);
  judgeSpread(target, spread, report);
  if (!report.has(LayoutIssue::kCollinear)) judgeLikeness(target, spread, report);
  return report;
}

std::vector<LookAlike> findLookAlikes(std::span<const Target> targets) {
  std::vector<LookAlike> found;
  for (std::size_t i = 0; i < targets.size(); ++i)
    for (std::size_t j = i + 1; j < targets.size(); ++j) {
      const auto& a = targets[i].markers_T;
      const auto& b = targets[j].markers_T;
      const int telling = std::min(leastAccepted(a.size()), leastAccepted(b.size()));
      const SharedShape shared = findSharedShape(a, b, {kTellable_m, kTellable_m, telling});
      if (shared.markers == 0) continue;
      const bool is_part = static_cast<std::size_t>(shared.markers) == std::min(a.size(), b.size());
      found.push_back({targets[i].name, targets[j].name, shared.markers, is_part ? 0 : shared.markers + 1});
    }
  return found;
}

std::string describe(const LayoutReport& report, LayoutIssue issue) {
  std::ostringstream line;
  line.precision(3);
  line << id(issue) << ": " << report.target << " ";
  switch (issue) {
    case LayoutIssue::kCollinear:
      line << "has its markers on one line: the turn about it cannot be measured";
      break;
    case LayoutIssue::kNearlyCollinear:
      line << "has its markers only " << 1e3 * report.width_m
           << " mm rms beside one line: the turn about it is uncertain";
      break;
    case LayoutIssue::kSymmetric:
      line << "is symmetric: in another pose its markers lie on each other to "
           << 1e3 * report.symmetric_rms_m << " mm rms";
      break;
    case LayoutIssue::kPlanarAmbiguous:
      line << "is flat and mirror-symmetric: turned over its markers lie on each other to "
           << 1e3 * report.symmetric_rms_m << " mm rms, so its pose is ambiguous";
      break;
    case LayoutIssue::kAlikeInPart:
      line << "has " << report.alike_markers << " of " << report.markers
           << " markers that lie on others in another pose: at least " << report.needed_markers
           << " must be seen for a unique answer";
      break;
    case LayoutIssue::kTooNear:
      line << "has two markers " << 1e3 * report.smallest_distance_m
           << " mm apart: they may merge or be mixed up";
      break;
    case LayoutIssue::kPoorTurn:
      line << "is spread so little that its turn is uncertain by "
           << report.turn_sigma_rad * 180.0 / std::numbers::pi << " degrees at 0.4 m";
      break;
  }
  return line.str();
}

std::string describe(const LookAlike& pair) {
  const std::string shared = "look_alike: " + pair.a + " and " + pair.b + " share the places of " +
                             std::to_string(pair.shared_markers) + " markers: ";
  if (pair.needed_markers == 0) return shared + "one has no other, so they cannot be told apart by it";
  return shared + "at least " + std::to_string(pair.needed_markers) +
         " of one must be seen to tell them apart";
}

std::vector<std::string> layoutWarnings(std::span<const Target> targets) {
  std::vector<std::string> warnings;
  for (const auto& target : targets) {
    const LayoutReport report = checkLayout(target);
    for (const LayoutIssue issue : report.issues) warnings.push_back(describe(report, issue));
  }
  for (const auto& pair : findLookAlikes(targets)) warnings.push_back(describe(pair));
  return warnings;
}

}  // namespace mirrorarm::tracking
