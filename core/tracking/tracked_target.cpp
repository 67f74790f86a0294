#include "core/tracking/tracked_target.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace mirrorarm::tracking {
namespace {

double largestSigma(const Eigen::Matrix3d& covariance) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace

std::string_view id(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return "tracked";
    case TrackStatus::kPredicted:
      return "predicted";
    case TrackStatus::kLost:
      return "lost";
  }
  return "lost";
}

std::string_view id(LostReason reason) {
  switch (reason) {
    case LostReason::kNone:
      return "none";
    case LostReason::kNoPoints:
      return "no_points";
    case LostReason::kTooFewMarkers:
      return "too_few_markers";
    case LostReason::kBadFit:
      return "bad_fit";
    case LostReason::kNotConverged:
      return "not_converged";
    case LostReason::kAmbiguous:
      return "ambiguous";
    case LostReason::kOutOfVolume:
      return "out_of_volume";
    case LostReason::kStale:
      return "stale";
  }
  return "none";
}

double shiftSigma(const TrackedTarget& target) {
  return largestSigma(target.covariance.bottomRightCorner<3, 3>());
}

double turnSigma(const TrackedTarget& target) {
  return largestSigma(target.covariance.topLeftCorner<3, 3>());
}

}  // namespace mirrorarm::tracking
