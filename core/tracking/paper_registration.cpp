#include "core/tracking/paper_registration.h"

#include <algorithm>

#include "core/tracking/fit_covariance.h"
#include "core/tracking/layout.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::size_t kMinForPose = 3;

}  // namespace

const ShapeFit& PaperRegistration::run(std::span<const Eigen::Vector3d> markers_T,
                                       std::span<const CloudPoint> cloud,
                                       const std::optional<RigidTransform>& last_X_CT) {
  points_C_.clear();
  for (const CloudPoint& point : cloud) points_C_.push_back(point.p_C);
  const SoftassignResult& found = softassign_.run(markers_T, points_C_, settings_.softassign, last_X_CT);
  fit_.point_of_marker = found.y_of_x;
  fit_.matched = found.matched;
  fit_.pose = {};
  fit_.pose.X_CT = found.X_YX;
  fit_.pose.rms_m = found.rms_m;
  keepMatches(markers_T, cloud);
  fit_.reason = cloud.empty() ? LostReason::kNoPoints : verdict(markers_T.size());
  if (fit_.isAccepted())
    fit_.pose.covariance = fitCovariance(found.X_YX, matched_T_, matched_C_, matched_covariance_);
  return fit_;
}

void PaperRegistration::keepMatches(std::span<const Eigen::Vector3d> markers_T,
                                    std::span<const CloudPoint> cloud) {
  matched_T_.clear();
  matched_C_.clear();
  matched_covariance_.clear();
  for (std::size_t j = 0; j < markers_T.size(); ++j) {
    if (fit_.point_of_marker[j] < 0) continue;
    const CloudPoint& point = cloud[static_cast<std::size_t>(fit_.point_of_marker[j])];
    matched_T_.push_back(markers_T[j]);
    matched_C_.push_back(point.p_C);
    matched_covariance_.push_back(point.covariance_m2);
  }
}

LostReason PaperRegistration::verdict(std::size_t markers) const {
  const double needed = settings_.min_marker_share * static_cast<double>(markers);
  if (matched_T_.size() < kMinForPose || static_cast<double>(matched_T_.size()) < needed)
    return LostReason::kTooFewMarkers;
  if (fit_.pose.rms_m > settings_.max_rms_m) return LostReason::kBadFit;
  return areCollinear(matched_T_) ? LostReason::kTooFewMarkers : LostReason::kNone;
}

}  // namespace mirrorarm::tracking
