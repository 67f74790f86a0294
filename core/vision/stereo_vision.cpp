#include "core/vision/stereo_vision.h"

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace mirrorarm::vision {
namespace {

constexpr double kRegionMargin_px = 12.0;

bool fits(const camera::GreyImage& image, const camera::CameraModel& camera) {
  return image.width() == camera.intrinsics().width_px && image.height() == camera.intrinsics().height_px;
}

/// Rectangles around the images of spheres of `radius_m`.
void regionsAround(const camera::CameraModel& camera, const RigidTransform& X_KC,
                   std::span<const Eigen::Vector3d> points_C, double radius_m, std::vector<Region>& regions) {
  regions.clear();
  for (const auto& p_C : points_C) {
    const Eigen::Vector3d p_K = X_KC * p_C;
    camera::CameraModel::ProjectJacobian J;
    const auto pixel = camera.project(p_K, J);
    if (!pixel || !camera.sees(*pixel, -kRegionMargin_px)) continue;
    const Eigen::Vector2d half = (radius_m * J.rowwise().norm()).array() + kRegionMargin_px;
    const Eigen::Vector2d low = *pixel - half;
    const Eigen::Vector2d high = *pixel + half;
    if (!half.allFinite() || half.maxCoeff() > 1e6) continue;
    regions.push_back({static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()),
                       static_cast<int>(high.y())});
  }
}

/// One camera's share of the work.
struct Side {
  MarkerFinder finder;
  std::vector<Region> regions;
  Detection found;

  void look(const camera::ImageView& image) { found = finder.find(image, regions); }
};

}  // namespace

/// The right image has its own thread: `asked_` counts the images given to it, `done_` those it has finished.
struct StereoVision::Body {
  Body(const camera::StereoRig& for_rig, const FinderSettings& finder, const MatcherSettings& settings)
      : rig(for_rig),
        matcher(settings),
        left{MarkerFinder(finder, for_rig.left), {}, {}},
        right{MarkerFinder(finder, for_rig.right), {}, {}},
        worker([this](const std::stop_token& stop) { work(stop); }) {}

  ~Body() {
    worker.request_stop();
    asked.fetch_add(1, std::memory_order_release);
    asked.notify_one();
  }

  void work(const std::stop_token& stop) {
    for (unsigned finished = 0;;) {
      asked.wait(finished, std::memory_order_acquire);
      if (stop.stop_requested()) return;
      right.look(right_image);
      done.store(++finished, std::memory_order_release);
      done.notify_one();
    }
  }

  void lookAtBoth(const camera::StereoFrame& frame) {
    right_image = frame.right.view();
    const unsigned wanted = asked.fetch_add(1, std::memory_order_release) + 1;
    asked.notify_one();
    left.look(frame.left.view());
    for (unsigned now = done.load(std::memory_order_acquire); now != wanted;
         now = done.load(std::memory_order_acquire))
      done.wait(now, std::memory_order_acquire);
  }

  camera::StereoRig rig;
  StereoObservation observation;
  MatcherSettings matcher;
  Side left;
  Side right;                     // the worker's while an image is asked for and not done
  camera::ImageView right_image;  // likewise
  std::atomic<unsigned> asked{0};
  std::atomic<unsigned> done{0};
  std::jthread worker;  // last member: joined first
};

StereoVision::StereoVision(const camera::StereoRig& rig, const FinderSettings& finder,
                           const MatcherSettings& matcher)
    : body_(std::make_unique<Body>(rig, finder, matcher)) {}
StereoVision::~StereoVision() = default;

const StereoObservation& StereoVision::observe(const camera::StereoFrame& frame) {
  auto& observation = body_->observation;
  observation = {};
  observation.exposed_at = frame.exposed_at;
  observation.sequence = frame.sequence;
  if (!fits(frame.left, body_->rig.left) || !fits(frame.right, body_->rig.right)) return observation;
  body_->lookAtBoth(frame);
  observation.left = body_->left.found;
  observation.right = body_->right.found;
  observation.points =
      matchStereo(body_->rig, observation.left.markers, observation.right.markers, body_->matcher);
  return observation;
}

void StereoVision::expect(std::span<const Eigen::Vector3d> points_C, double radius_m) {
  regionsAround(body_->rig.left, RigidTransform::Identity(), points_C, radius_m, body_->left.regions);
  regionsAround(body_->rig.right, body_->rig.X_RC, points_C, radius_m, body_->right.regions);
}

}  // namespace mirrorarm::vision
