#include "benchmarks/tracking/target_view.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/vision/triangulation.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Eigen::Vector3d normal3(TrialRandom& random) { return {random.normal(), random.normal(), random.normal()}; }

/// In a frame on the cylinder's axis.
std::vector<vision::StereoDisc> discsAboutAxis() {
  constexpr int kDiscs = 10;
  constexpr double kRadius_m = 0.045;
  std::vector<vision::StereoDisc> discs;
  for (int i = 0; i < kDiscs; ++i) {
    const double angle = (-65.0 + 130.0 * ((i * 7) % kDiscs) / (kDiscs - 1)) * kDegree;
    vision::StereoDisc disc;
    disc.normal_C = Eigen::Vector3d(0.0, std::sin(angle), -std::cos(angle));
    disc.centre_C = Eigen::Vector3d(-0.075 + 0.15 * i / (kDiscs - 1), 0.0, 0.0) + kRadius_m * disc.normal_C;
    discs.push_back(disc);
  }
  return discs;
}

Eigen::Vector3d centroid(const std::vector<vision::StereoDisc>& discs) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& disc : discs) sum += disc.centre_C;
  return sum / static_cast<double>(discs.size());
}

mirrorarm::vision::DetectedMarker detected(const Eigen::Vector2d& truth_px, double sigma_px,
                                           TrialRandom& random) {
  mirrorarm::vision::DetectedMarker marker;
  marker.centre_px = truth_px + sigma_px * Eigen::Vector2d(random.normal(), random.normal());
  marker.covariance_px2 = sigma_px * sigma_px * Eigen::Matrix2d::Identity();
  return marker;
}

}  // namespace

std::vector<vision::StereoDisc> forearmDiscs_T() {
  auto discs = discsAboutAxis();
  const Eigen::Vector3d middle = centroid(discs);
  for (auto& disc : discs) disc.centre_C -= middle;
  return discs;
}

RigidTransform forearmPose(TrialRandom& random) {
  const Eigen::AngleAxisd turn(random.uniform(0.0, 15.0) * kDegree, normal3(random).normalized());
  return makeTransform(Eigen::Quaterniond(turn), Eigen::Vector3d(0.06, 0.0, 0.4)) *
         Eigen::Translation3d(centroid(discsAboutAxis()));
}

std::vector<vision::StereoDisc> discsAt(const camera::StereoRig& rig,
                                        const std::vector<vision::StereoDisc>& discs_T,
                                        const RigidTransform& X_CT) {
  std::vector<vision::StereoDisc> discs_C = discs_T;
  for (auto& disc : discs_C) {
    disc.centre_C = X_CT * disc.centre_C;
    disc.normal_C = X_CT.linear() * disc.normal_C;
    const auto left = rig.left.project(disc.centre_C);
    const auto right = rig.right.project(rig.X_RC * disc.centre_C);
    if (!left || !right) throw std::runtime_error("a disc lies outside the lenses' models");
    disc.left_px = *left;
    disc.right_px = *right;
  }
  return discs_C;
}

std::vector<mirrorarm::tracking::MarkerMatch> measuredMatches(const camera::StereoRig& rig,
                                                              const std::vector<vision::StereoDisc>& discs_T,
                                                              const std::vector<vision::StereoDisc>& discs_C,
                                                              double sigma_px, TrialRandom& random) {
  std::vector<mirrorarm::tracking::MarkerMatch> matches;
  for (std::size_t i = 0; i < discs_T.size(); ++i) {
    const auto left = detected(discs_C[i].left_px, sigma_px, random);
    const auto right = detected(discs_C[i].right_px, sigma_px, random);
    const auto point = mirrorarm::vision::triangulate(rig, left, right);
    if (!point) throw std::runtime_error("a disc's rays run apart");
    matches.push_back({discs_T[i].centre_C, Eigen::Matrix3d::Zero(), point->p_C, point->covariance_m2});
  }
  return matches;
}

}  // namespace mirrorarm::benchmarks::tracking
