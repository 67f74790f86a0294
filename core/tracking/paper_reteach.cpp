#include "core/tracking/paper_reteach.h"

#include <algorithm>
#include <vector>

#include "core/tracking/softassign.h"

namespace mirrorarm::tracking {
namespace {

/// How far skin carries a marker before it must be another one.
constexpr double kSkinMoves_m = 0.020;

}  // namespace

std::optional<Target> paperReteach(const Target& old, std::span<const CloudPoint> cloud,
                                   const RigidTransform& X_CT_last, const PaperSettings& settings) {
  std::vector<Eigen::Vector3d> points_C;
  for (const CloudPoint& point : cloud) points_C.push_back(point.p_C);
  SoftassignSettings wide = settings.softassign;
  wide.tolerated_distance_m = kSkinMoves_m;
  // A smaller beta would forget the last pose, and with it which marker is which.
  constexpr double kSkinMoves_mm = 1e3 * kSkinMoves_m;
  wide.beta_start = std::max(wide.beta_start, 0.5 / (kSkinMoves_mm * kSkinMoves_mm));
  const auto found = registerSoftassign(old.markers_T, points_C, wide, X_CT_last);
  const double needed = std::max(3.0, settings.min_marker_share * static_cast<double>(old.markers_T.size()));
  if (found.matched < needed || found.rms_m > kSkinMoves_m) return std::nullopt;
  Target adapted = old;
  adapted.markers_covariance_m2.clear();
  const RigidTransform X_TC = found.X_YX.inverse();
  for (std::size_t marker = 0; marker < adapted.markers_T.size(); ++marker)
    if (const int point = found.y_of_x[marker]; point >= 0)
      adapted.markers_T[marker] = X_TC * points_C[static_cast<std::size_t>(point)];
  return adapted;
}

}  // namespace mirrorarm::tracking
