#pragma once

#include <array>
#include <vector>

#include "core/camera/rig_file.h"
#include "core/tracking/pose_estimator.h"
#include "core/vision/triangulation.h"
#include "tests/tracking/world.h"

namespace mirrorarm::tracking::test {

/// A marker's centres in both images with their covariances, and what was triangulated from them.
struct SeenMarker {
  vision::DetectedMarker left;
  vision::DetectedMarker right;
  MarkerMatch match;
};

inline camera::StereoRig fisheyeRig() { return *camera::readRig(RESOURCES "/rigs/fisheye.yaml"); }

/// A centre measured with a standard deviation of `sigma_px`, a little more across than along.
inline vision::DetectedMarker measured(const Eigen::Vector2d& centre_px, double sigma_px, Noise& noise) {
  const Eigen::Matrix2d shape{{1.0, 0.2}, {0.2, 1.2}};
  const Eigen::Matrix2d root = shape.llt().matrixL();
  vision::DetectedMarker marker;
  marker.covariance_px2 = sigma_px * sigma_px * shape;
  marker.centre_px = centre_px + sigma_px * root * noise.gaussian(1.0).head<2>();
  return marker;
}

/// The markers at X_CT through both lenses, with noise in the images alone.
inline std::vector<SeenMarker> sight(const camera::StereoRig& rig, const std::vector<Vector3d>& markers_T,
                                     const RigidTransform& X_CT, double sigma_px, Noise& noise) {
  std::vector<SeenMarker> seen;
  for (const auto& marker_T : markers_T) {
    const Vector3d p_C = X_CT * marker_T;
    SeenMarker marker;
    marker.left = measured(*rig.left.project(p_C), sigma_px, noise);
    marker.right = measured(*rig.right.project(rig.X_RC * p_C), sigma_px, noise);
    const auto point = *vision::triangulate(rig, marker.left, marker.right);
    marker.match.marker_T = marker_T;
    marker.match.point_C = point.p_C;
    marker.match.point_covariance_m2 = point.covariance_m2;
    seen.push_back(marker);
  }
  return seen;
}

inline std::vector<MarkerMatch> matchesOf(const std::vector<SeenMarker>& seen) {
  std::vector<MarkerMatch> matches;
  for (const auto& marker : seen) matches.push_back(marker.match);
  return matches;
}

/// What takes `X_CT` to `X_CT_true`: turn [rad] then shift [m], in T.
inline Eigen::Matrix<double, 6, 1> errorOf(const RigidTransform& X_CT, const RigidTransform& X_CT_true) {
  const RigidTransform d = X_CT.inverse() * X_CT_true;
  Eigen::Matrix<double, 6, 1> error;
  error << rotationVector(d.linear()), d.translation();
  return error;
}

/// e' C^-1 e of a pose: its mean is 6 when the covariance tells the truth.
inline double squaredSigmas(const RigidTransform& X_CT, const Eigen::Matrix<double, 6, 6>& covariance,
                            const RigidTransform& X_CT_true) {
  const auto error = errorOf(X_CT, X_CT_true);
  return error.dot(covariance.inverse() * error);
}

}  // namespace mirrorarm::tracking::test
