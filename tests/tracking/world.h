#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/tracking/cloud_point.h"
#include "core/tracking/target.h"
#include "core/vision/stereo_observation.h"

namespace mirrorarm::tracking::test {

using Eigen::Vector3d;

inline constexpr double kSensorNoise_m = 0.00015;

/// Ten markers on half a cylinder the size of a forearm, no two distances alike on purpose.
inline Target forearm() {
  Target target;
  target.name = "forearm";
  const double along_mm[] = {0, 14, 33, 47, 66, 82, 95, 113, 131, 150};
  const double around_deg[] = {10, 95, 160, 55, 120, 20, 75, 150, 40, 105};
  for (int i = 0; i < 10; ++i) {
    const double angle = around_deg[i] * std::numbers::pi / 180.0;
    target.markers_T.emplace_back(0.001 * along_mm[i] - 0.073, 0.045 * std::cos(angle),
                                  0.045 * std::sin(angle) - 0.03);
  }
  return target;
}

struct Noise {
  explicit Noise(unsigned seed) : rng(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng); }
  Vector3d gaussian(double sigma) {
    std::normal_distribution<double> d(0.0, sigma);
    return {d(rng), d(rng), d(rng)};
  }
  Eigen::Matrix3d rotation() {
    const Vector3d unit = gaussian(1.0);
    std::normal_distribution<double> d(0.0, 1.0);
    return Eigen::Quaterniond(d(rng), unit.x(), unit.y(), unit.z()).normalized().toRotationMatrix();
  }
  /// In front of the camera, turned anyhow.
  RigidTransform pose() {
    return makeTransform(rotation(), Vector3d(uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(0.4, 0.6)));
  }
  /// A turn of at most `angle` and a shift of at most `shift` a side.
  RigidTransform nudge(double angle, double shift) {
    const Vector3d axis = gaussian(1.0).normalized();
    return makeTransform(Eigen::Quaterniond(Eigen::AngleAxisd(uniform(0.0, angle), axis)),
                         Vector3d(uniform(-shift, shift), uniform(-shift, shift), uniform(-shift, shift)));
  }
  Vector3d stranger(const Vector3d& around) {
    return around + Vector3d(uniform(-0.15, 0.15), uniform(-0.15, 0.15), uniform(-0.15, 0.15));
  }

  std::mt19937 rng;
};

/// A measured cloud and, for the test alone, what each point truly is.
struct Scene {
  std::vector<Vector3d> points_C;
  std::vector<int> marker_of_point;  ///< -1 a stranger
};

/// `visible` of the markers at X_CT with sensor noise, `strangers` about them, shuffled.
inline Scene look(const std::vector<Vector3d>& markers_T, const RigidTransform& X_CT, int visible,
                  int strangers, Noise& noise) {
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(markers_T.size()); ++i) order.push_back(i);
  std::shuffle(order.begin(), order.end(), noise.rng);
  order.resize(static_cast<std::size_t>(visible));
  order.insert(order.end(), static_cast<std::size_t>(strangers), -1);
  std::shuffle(order.begin(), order.end(), noise.rng);
  Scene scene;
  scene.marker_of_point = order;
  for (const int marker : order) {
    const Vector3d p_C =
        marker < 0 ? noise.stranger(X_CT.translation()) : X_CT * markers_T[static_cast<std::size_t>(marker)];
    scene.points_C.push_back(p_C + noise.gaussian(kSensorNoise_m));
  }
  return scene;
}

inline std::vector<CloudPoint> cloudOf(const Scene& scene) {
  std::vector<CloudPoint> cloud;
  for (const auto& p : scene.points_C)
    cloud.push_back({p, kSensorNoise_m * kSensorNoise_m * Eigen::Matrix3d::Identity(), {}});
  return cloud;
}

inline std::vector<vision::StereoPoint> asStereo(const std::vector<Vector3d>& points_C) {
  std::vector<vision::StereoPoint> points;
  for (const auto& p : points_C) {
    vision::StereoPoint point;
    point.p_C = p;
    point.covariance_m2 = kSensorNoise_m * kSensorNoise_m * Eigen::Matrix3d::Identity();
    points.push_back(point);
  }
  return points;
}

}  // namespace mirrorarm::tracking::test
