#include "core/vision/stereo_vision.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace mirrorarm::vision {
namespace {

constexpr double kRegionMargin_px = 12.0;
constexpr double kLeastBaseline_m = 1e-4;
constexpr int kSpins = 4000;  // some 100 us

/// Tells the processor that this core only waits.
void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

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

bool isUsable(const camera::CameraModel& camera) {
  const auto& i = camera.intrinsics();
  const bool is_finite =
      std::isfinite(i.fx_px) && std::isfinite(i.fy_px) && std::isfinite(i.cx_px) && std::isfinite(i.cy_px) &&
      std::all_of(i.distortion.begin(), i.distortion.end(), [](double k) { return std::isfinite(k); });
  return is_finite && i.fx_px > 0.0 && i.fy_px > 0.0;
}

bool isUsable(const camera::StereoRig& rig) {
  return isUsable(rig.left) && isUsable(rig.right) && isRigid(rig.X_RC) &&
         rig.X_RC.translation().norm() > kLeastBaseline_m;
}

void clear(Detection& detection) {
  detection.markers.clear();
  detection.rejected.fill(0);
  detection.rejected_lights.clear();
  detection.exposure = {};
}

/// Only what fits raw pixels carries the bias that the correction takes away.
MatcherSettings suited(MatcherSettings matcher, CentreMethod method) {
  matcher.correct_centres = matcher.correct_centres && method != CentreMethod::kLindebergFitzgibbon;
  return matcher;
}

/// One camera's share of the work.
struct Side {
  MarkerFinder finder;
  std::vector<Region> regions;

  void look(const camera::ImageView& image, Detection& found) { found = finder.find(image, regions); }
};

}  // namespace

/// The right image has its own thread. `asked` numbers the images given to it, `claimed` is the last that
/// somebody took on, `done` the last it has finished. An image that it has not taken on by the time the left
/// one is finished is taken from it: a thread that wakes late, or a single core, costs no more than one after
/// the other.
struct StereoVision::Body {
  Body(const camera::StereoRig& for_rig, const FinderSettings& finder, const MatcherSettings& settings)
      : rig(for_rig),
        usable(isUsable(for_rig)),
        matcher(for_rig, suited(settings, finder.method)),
        left{MarkerFinder(finder, for_rig.left), {}},
        right{MarkerFinder(finder, for_rig.right), {}},
        worker([this](const std::stop_token& stop) { work(stop); }) {}

  ~Body() {
    worker.request_stop();
    asked.fetch_add(1, std::memory_order_release);
    asked.notify_one();
  }

  [[nodiscard]] bool claim(unsigned image) {
    unsigned before = image - 1;
    return claimed.compare_exchange_strong(before, image, std::memory_order_acq_rel);
  }

  void work(const std::stop_token& stop) {
    for (unsigned seen = 0;;) {
      asked.wait(seen, std::memory_order_acquire);
      seen = asked.load(std::memory_order_acquire);
      if (stop.stop_requested()) return;
      if (!claim(seen)) continue;
      right.look(right_image, observation.right);
      done.store(seen, std::memory_order_release);
      done.notify_one();
    }
  }

  void lookAtBoth(const camera::StereoFrame& frame) {
    right_image = frame.right.view();
    const unsigned image = asked.fetch_add(1, std::memory_order_release) + 1;
    asked.notify_one();
    left.look(frame.left.view(), observation.left);
    if (claim(image))
      right.look(right_image, observation.right);
    else
      waitFor(image);
  }

  /// The other thread is at work on it: sleeping would cost more than what is left.
  void waitFor(unsigned image) const {
    for (int i = 0; i < kSpins && done.load(std::memory_order_acquire) != image; ++i) relax();
    for (unsigned now = done.load(std::memory_order_acquire); now != image;
         now = done.load(std::memory_order_acquire))
      done.wait(now, std::memory_order_acquire);
  }

  void match() {
    const auto points = matcher.match(observation.left.markers, observation.right.markers);
    observation.points.assign(points.begin(), points.end());
    for (const auto& point : points) {
      if (!point.preferred) continue;
      observation.left.markers[static_cast<std::size_t>(point.left)].centre_px = point.left_px;
      observation.right.markers[static_cast<std::size_t>(point.right)].centre_px = point.right_px;
    }
  }

  camera::StereoRig rig;
  bool usable;
  StereoMatcher matcher;
  StereoObservation observation;  // its right half the worker's while it looks
  Side left;
  Side right;                     // whose claim it is
  camera::ImageView right_image;  // likewise
  std::atomic<unsigned> asked{0};
  std::atomic<unsigned> claimed{0};
  std::atomic<unsigned> done{0};
  std::jthread worker;  // last member: joined first
};

StereoVision::StereoVision(const camera::StereoRig& rig, const FinderSettings& finder,
                           const MatcherSettings& matcher)
    : body_(std::make_unique<Body>(rig, finder, matcher)) {}
StereoVision::~StereoVision() = default;

const StereoObservation& StereoVision::observe(const camera::StereoFrame& frame) {
  auto& observation = body_->observation;
  observation.exposed_at = frame.exposed_at;
  observation.sequence = frame.sequence;
  observation.points.clear();
  clear(observation.left);
  clear(observation.right);
  const auto& rig = body_->rig;
  if (!body_->usable || !fits(frame.left, rig.left) || !fits(frame.right, rig.right)) return observation;
  body_->lookAtBoth(frame);
  body_->match();
  return observation;
}

void StereoVision::expect(std::span<const Eigen::Vector3d> points_C, double radius_m) {
  regionsAround(body_->rig.left, RigidTransform::Identity(), points_C, radius_m, body_->left.regions);
  regionsAround(body_->rig.right, body_->rig.X_RC, points_C, radius_m, body_->right.regions);
}

}  // namespace mirrorarm::vision
