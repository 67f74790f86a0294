#include "tests/calibration/plate_images.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/vision/centre_correction.h"

namespace mirrorarm::calibration {
namespace {

constexpr double kMargin_px = 25.0;
constexpr double kLeastCosine = 0.45;  // of the entrance angle
constexpr double kLeastShown = 0.7;

}  // namespace

PlateBench::PlateBench(const camera::StereoRig& rig, const Board& plate)
    : rig_(rig),
      plate_(plate),
      points_(boardPoints(plate)),
      diameters_m_(discDiameters_m(plate)),
      renderer_(rig, {}, {}) {}

RigidTransform PlateBench::pose(double most_tilt_rad) {
  for (;;) {
    const Eigen::Vector2d pixel(between(0, lens(0).intrinsics().width_px),
                                between(0, lens(0).intrinsics().height_px));
    const auto ray = lens(0).unproject(pixel);
    if (!ray) continue;
    const Eigen::Vector3d sight = ray->homogeneous().normalized();
    const double around = between(0.0, 2.0 * std::numbers::pi);
    const Eigen::Vector3d across = Eigen::AngleAxisd(around, sight) * sight.unitOrthogonal();
    const Eigen::Quaterniond R =
        Eigen::AngleAxisd(between(0.0, most_tilt_rad), across) *
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), sight) *
        Eigen::AngleAxisd(between(0.0, 2.0 * std::numbers::pi), Eigen::Vector3d::UnitZ());
    const RigidTransform X_CM = makeTransform(R, between(0.25, 0.65) * sight - R * boardMiddle(plate_));
    const double least = kLeastShown * static_cast<double>(points_.size());
    if (shown(X_CM, 0) >= least && shown(X_CM, 1) >= least) return X_CM;
  }
}

int PlateBench::shown(const RigidTransform& X_CM, int camera) const {
  const auto X_KM = poseIn(camera, X_CM);
  return static_cast<int>(std::count_if(points_.begin(), points_.end(), [&](const Eigen::Vector3d& p_M) {
    const Eigen::Vector3d p_K = X_KM * p_M;
    const auto pixel = lens(camera).project(p_K);
    return pixel && lens(camera).sees(*pixel, kMargin_px) &&
           X_KM.linear().col(2).dot(p_K.normalized()) > kLeastCosine;
  }));
}

std::vector<int> PlateBench::someDots(double share) {
  std::vector<int> dots(points_.size());
  std::iota(dots.begin(), dots.end(), 0);
  std::shuffle(dots.begin(), dots.end(), random_);
  dots.resize(static_cast<std::size_t>(share * static_cast<double>(dots.size())));
  return dots;
}

simulation::Patch PlateBench::dot(int point, bool mirrored) const {
  const auto at = static_cast<std::size_t>(point);
  simulation::Patch patch;
  patch.centre = points_[at];
  if (mirrored) patch.centre.x() = 2.0 * boardMiddle(plate_).x() - patch.centre.x();
  patch.u = 0.5 * diameters_m_[at] * Eigen::Vector3d::UnitY();
  patch.v = 0.5 * diameters_m_[at] * Eigen::Vector3d::UnitX();
  return patch;
}

simulation::Patch PlateBench::light() {
  const Eigen::Vector3d middle = boardMiddle(plate_);
  const double reach = plate_.spacing_m;
  simulation::Patch patch = dot(0, false);
  patch.centre = Eigen::Vector3d(between(-reach, 2.0 * middle.x() + reach),
                                 between(-reach, 2.0 * middle.y() + reach), 0.0);
  const double scale = between(0.4, 1.5);
  patch.u *= scale;
  patch.v *= scale;
  return patch;
}

std::pair<camera::GreyImage, camera::GreyImage> PlateBench::images(const RigidTransform& X_CM,
                                                                   const PlateScene& scene) {
  simulation::StereoRenderer::Instant instant;
  for (int point = 0; point < static_cast<int>(points_.size()); ++point)
    if (std::find(scene.hidden.begin(), scene.hidden.end(), point) == scene.hidden.end())
      instant.push_back(transformed(X_CM, dot(point, scene.mirrored)));
  const std::size_t dots = instant.size();
  while (instant.size() < dots + static_cast<std::size_t>(scene.lights)) {
    const auto stray = transformed(X_CM, light());
    const auto touches = [&](const simulation::Patch& other) {
      return (other.centre - stray.centre).norm() < 1.3 * (other.u.norm() + stray.u.norm());
    };
    if (std::none_of(instant.begin(), instant.end(), touches)) instant.push_back(stray);
  }
  return renderer_.render({&instant, 1}, ++seed_);
}

Eigen::Vector2d PlateBench::truth(const RigidTransform& X_CM, int camera, int point) const {
  const auto X_KM = poseIn(camera, X_CM);
  const auto at = static_cast<std::size_t>(point);
  const vision::FlatDisc disc{X_KM * points_[at], -X_KM.linear().col(2), 0.5 * diameters_m_[at]};
  return lens(camera).project(disc.p_K).value() + vision::centreBias(lens(camera), disc).value();
}

}  // namespace mirrorarm::calibration
