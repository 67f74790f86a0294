#include "core/vision/disc_estimator.h"

#include "core/vision/conic_estimator.h"
#include "core/vision/edge_estimator.h"
#include "core/vision/likelihood_estimator.h"

namespace mirrorarm::vision {

std::unique_ptr<DiscEstimator> makeDiscEstimator(const FinderSettings& settings,
                                                 const camera::CameraModel* camera) {
  switch (settings.method) {
    case CentreMethod::kDualConic:
      return std::make_unique<ConicEstimator>(settings);
    case CentreMethod::kLindebergFitzgibbon:
      return std::make_unique<EdgeEstimator>(settings, camera);
    case CentreMethod::kMaximumLikelihood:
      break;
  }
  return std::make_unique<LikelihoodEstimator>(settings);
}

Expected<DetectedMarker, Rejection> withinLimits(const DetectedMarker& marker,
                                                 const FinderSettings& settings) {
  const double major = 2.0 * marker.ellipse.semi_major_px;
  const double minor = 2.0 * marker.ellipse.semi_minor_px;
  if (major < settings.min_diameter_px) return unexpected(Rejection::kTooSmall);
  if (major > settings.max_diameter_px) return unexpected(Rejection::kTooLarge);
  if (major > settings.max_axis_ratio * minor) return unexpected(Rejection::kTooElongated);
  const double variance = marker.covariance_px2.diagonal().maxCoeff();
  if (!(variance <= settings.max_centre_sigma_px * settings.max_centre_sigma_px))
    return unexpected(Rejection::kNotAnEllipse);
  if (marker.outline_fraction < settings.min_outline_fraction) return unexpected(Rejection::kCut);
  return marker;
}

}  // namespace mirrorarm::vision
