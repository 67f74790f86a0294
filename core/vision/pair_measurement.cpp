#include "core/vision/pair_measurement.h"

#include "core/vision/centre_correction.h"
#include "core/vision/disc_orientation.h"
#include "core/vision/triangulation.h"

namespace mirrorarm::vision {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kTellingTilt_rad = 0.5;  // a normal less certain than that tells nothing

/// How the correction in one image [px] moves with m = radius times normal: its perspective part, (m . d) /
/// distance times the image of m, is the one that depends on the tilt.
Eigen::Matrix<double, 2, 3> correctionByTilt(const PointImage& image, const Vector3d& m_C,
                                             const Vector3d& ray_C) {
  const double distance2 = ray_C.squaredNorm();
  return image.by_point * (m_C * ray_C.transpose() + m_C.dot(ray_C) * Matrix3d::Identity()) / distance2;
}

/// What the disc's uncertain tilt does to the triangulated point through both corrections.
Matrix3d covarianceOfTilt(const camera::StereoRig& rig, const ImagedPoint& images,
                          const DiscOrientation& disc, const MeasuredCentre& left,
                          const MeasuredCentre& right, const Matrix3d& covariance_m2) {
  const Vector3d m_C = disc.radius_m * disc.normal_C;
  const Vector3d right_ray_C = images.p_C + rig.X_RC.linear().transpose() * rig.X_RC.translation();
  const Matrix3d by_tilt = covariance_m2 * (images.left.by_point.transpose() * left.weight_px2 *
                                                correctionByTilt(images.left, m_C, images.p_C) +
                                            images.right.by_point.transpose() * right.weight_px2 *
                                                correctionByTilt(images.right, m_C, right_ray_C));
  return by_tilt * disc.covariance_m2 * by_tilt.transpose();
}

/// What a cut outline says of its disc speaks against no pair.
bool canBeJudged(const DetectedMarker& left, const DetectedMarker& right) { return !left.cut && !right.cut; }

void describe(const DiscOrientation& disc, StereoPoint& point) {
  const double r2 = disc.radius_m * disc.radius_m;
  if (!(disc.covariance_m2.trace() < kTellingTilt_rad * kTellingTilt_rad * r2)) return;
  point.normal_C = disc.normal_C;
  point.radius_m = disc.radius_m;
}

void correct(const camera::StereoRig& rig, const DiscOrientation& disc, const ImagedPoint& images,
             StereoPoint& point) {
  const RigidTransform& X_RC = rig.X_RC;
  const auto left = centreBias(rig.left, {images.p_C, disc.normal_C, disc.radius_m}, images.left.pixel);
  const auto right = centreBias(rig.right, {X_RC * images.p_C, X_RC.linear() * disc.normal_C, disc.radius_m},
                                images.right.pixel);
  if (!left || !right) return;
  point.left_px -= *left;
  point.right_px -= *right;
}

/// From the corrected pixels in `pair` to its place; `disc` is null when they were not corrected.
bool triangulate(const camera::StereoRig& rig, const ImagedPoint& start, const DiscOrientation* disc,
                 const DetectedMarker& left, const DetectedMarker& right, StereoPoint& pair) {
  const auto left_centre = measuredCentre(pair.left_px, left.covariance_px2);
  const auto right_centre = measuredCentre(pair.right_px, right.covariance_px2);
  const auto images = imaged(rig, stepTowards(start, left_centre, right_centre).p_C);
  if (!images) return false;
  const auto point = stepTowards(*images, left_centre, right_centre);
  pair.p_C = point.p_C;
  pair.covariance_m2 = point.covariance_m2;
  if (disc != nullptr)
    pair.covariance_m2 +=
        covarianceOfTilt(rig, *images, *disc, left_centre, right_centre, point.covariance_m2);
  return pair.p_C.allFinite() && pair.covariance_m2.allFinite();
}

}  // namespace

std::optional<PairMeasurement> measurePair(const camera::StereoRig& rig, const MatcherSettings& settings,
                                           const Vector3d& start_C, const DetectedMarker& left,
                                           const DetectedMarker& right) {
  const auto start = imaged(rig, start_C);
  if (!start) return std::nullopt;
  PairMeasurement pair;
  pair.point.left_px = left.centre_px;
  pair.point.right_px = right.centre_px;
  const auto disc = discOrientation(*start, left, right);
  const bool is_one_disc = disc && disc->misfit <= settings.max_shape_misfit;
  if (disc && canBeJudged(left, right)) {
    if (!is_one_disc) return std::nullopt;
    pair.shape_misfit = disc->misfit;
  }
  if (is_one_disc) describe(*disc, pair.point);
  const bool is_corrected = is_one_disc && settings.correct_centres;
  if (is_corrected) correct(rig, *disc, *start, pair.point);
  if (!triangulate(rig, *start, is_corrected ? &*disc : nullptr, left, right, pair.point))
    return std::nullopt;
  return pair;
}

}  // namespace mirrorarm::vision
