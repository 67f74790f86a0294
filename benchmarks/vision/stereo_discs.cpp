#include "benchmarks/vision/stereo_discs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Geometry>

#include "core/camera/rig_file.h"
#include "core/common/resources.h"
#include "core/vision/stereo_matcher.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kMargin_px = 16.0;
constexpr double kMostTilt_rad = std::numbers::pi / 3.0;

double tiltAgainst(const Eigen::Vector3d& eye_C, const StereoDisc& disc) {
  const Eigen::Vector3d towards = (eye_C - disc.centre_C).normalized();
  return std::acos(std::clamp(towards.dot(disc.normal_C), -1.0, 1.0));
}

bool bothProject(const camera::StereoRig& rig, StereoDisc& disc) {
  const auto left = rig.left.project(disc.centre_C);
  const auto right = rig.right.project(rig.X_RC * disc.centre_C);
  if (!left || !right || !rig.left.sees(*left, kMargin_px) || !rig.right.sees(*right, kMargin_px))
    return false;
  disc.left_px = *left;
  disc.right_px = *right;
  return true;
}

/// Evenly over the left image; the normal evenly over the cone around the line of sight.
std::optional<StereoDisc> tryDisc(const camera::StereoRig& rig, const DistanceRange& range,
                                  TrialRandom& random) {
  const auto& size = rig.left.intrinsics();
  const Eigen::Vector2d pixel(random.uniform(0.0, size.width_px), random.uniform(0.0, size.height_px));
  const auto ray = rig.left.unproject(pixel);
  if (!ray) return std::nullopt;
  StereoDisc disc;
  const Eigen::Vector3d sight = ray->homogeneous().normalized();
  disc.centre_C = random.uniform(range.least_m, range.most_m) * sight;
  if (disc.centre_C.z() < mirrorarm::vision::MatcherSettings{}.min_depth_m) return std::nullopt;
  const double cosine = random.uniform(std::cos(kMostTilt_rad), 1.0);
  const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3d a = sight.unitOrthogonal(), b = sight.cross(a);
  disc.normal_C =
      std::sqrt(1.0 - cosine * cosine) * (std::cos(turn) * a + std::sin(turn) * b) - cosine * sight;
  const Eigen::Vector3d right_eye_C = rig.X_RC.inverse().translation();
  if (tiltAgainst(right_eye_C, disc) > kMostTilt_rad || !bothProject(rig, disc)) return std::nullopt;
  return disc;
}

bool isApart(const StereoDisc& disc, const std::vector<StereoDisc>& others, double gap_px) {
  return std::ranges::none_of(others, [&](const StereoDisc& other) {
    return (other.left_px - disc.left_px).norm() < gap_px || (other.right_px - disc.right_px).norm() < gap_px;
  });
}

}  // namespace

simulation::Patch StereoDisc::patch_C() const {
  return simulation::patchOf({centre_C, normal_C, 2.0 * radius_m});
}

camera::StereoRig fisheyeRig() {
  const auto rig = camera::readRig(resourceFolder() / "rigs" / "fisheye.yaml");
  if (!rig) throw std::runtime_error("rigs/fisheye.yaml: " + rig.error().reason);
  return *rig;
}

std::vector<StereoDisc> randomDiscs(const camera::StereoRig& rig, int count, const DistanceRange& range,
                                    double gap_px, TrialRandom& random) {
  constexpr int kAttempts = 1000;
  std::vector<StereoDisc> discs;
  for (int attempt = 0; attempt < kAttempts * count && static_cast<int>(discs.size()) < count; ++attempt) {
    const auto disc = tryDisc(rig, range, random);
    if (disc && isApart(*disc, discs, gap_px)) discs.push_back(*disc);
  }
  return discs;
}

const mirrorarm::vision::StereoPoint* pointOf(const StereoDisc& disc,
                                              const mirrorarm::vision::StereoObservation& observation) {
  constexpr double kNear_px = 3.0;
  for (const auto& point : observation.points)
    if (point.preferred && (point.left_px - disc.left_px).norm() < kNear_px &&
        (point.right_px - disc.right_px).norm() < kNear_px)
      return &point;
  return nullptr;
}

}  // namespace mirrorarm::benchmarks::vision
