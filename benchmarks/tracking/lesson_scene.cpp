#include "benchmarks/tracking/lesson_scene.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/vision/triangulation.h"

namespace mirrorarm::benchmarks::tracking {
namespace {

using Eigen::Vector3d;

constexpr int kMarkers = 10;
constexpr int kStill = 3;
constexpr int kAnywhere = 2;
constexpr double kDistance_m = 0.4;
constexpr double kReach_m = 0.12;
constexpr double kFrames_Hz = 24.0;

/// How an arm is carried about: two turns and a shift of different beats.
struct Swing {
  RigidTransform middle_CT = RigidTransform::Identity();
  Vector3d axis = Vector3d::UnitX();
  double turn_rad = 0.0;
  double beat_Hz = 0.0;

  explicit Swing(TrialRandom& random) {
    const RigidTransform any = randomPose(random);
    middle_CT = makeTransform(Eigen::Matrix3d(any.linear()), Vector3d(0.06, 0.0, kDistance_m));
    axis = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    turn_rad = random.uniform(0.4, 0.7);
    beat_Hz = random.uniform(0.3, 0.5);
  }

  [[nodiscard]] RigidTransform at(double seconds) const {
    const double phase = 2.0 * std::numbers::pi * beat_Hz * seconds;
    const Vector3d shift_C(0.03 * std::sin(phase), 0.03 * std::sin(0.7 * phase),
                           0.02 * std::sin(1.3 * phase));
    const Eigen::AngleAxisd turn(turn_rad * std::sin(0.8 * phase), axis);
    return makeTransform(Eigen::Matrix3d(turn * middle_CT.linear()),
                         Vector3d(middle_CT.translation() + shift_C));
  }
};

Vector3d about(const Vector3d& middle, TrialRandom& random) {
  return middle + Vector3d(random.uniform(-kReach_m, kReach_m), random.uniform(-kReach_m, kReach_m),
                           random.uniform(-kReach_m, kReach_m));
}

template <class Value>
void shuffle(std::vector<Value>& values, TrialRandom& random) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[static_cast<std::size_t>(random.index(static_cast<int>(i)))]);
}

}  // namespace

std::optional<mirrorarm::tracking::CloudPoint> measuredPoint(const camera::StereoRig& rig,
                                                             const Vector3d& p_C, TrialRandom& random) {
  const auto truth = mirrorarm::vision::imaged(rig, p_C);
  if (!truth) return std::nullopt;
  const Eigen::Matrix2d covariance_px2 = kCentreNoise_px * kCentreNoise_px * Eigen::Matrix2d::Identity();
  const auto noisy = [&](const Eigen::Vector2d& pixel) {
    const double x = random.normal(), y = random.normal();
    return mirrorarm::vision::measuredCentre(pixel + kCentreNoise_px * Eigen::Vector2d(x, y), covariance_px2);
  };
  const auto left = noisy(truth->left.pixel);
  const auto right = noisy(truth->right.pixel);
  const auto point = mirrorarm::vision::stepTowards(*truth, left, right);
  return mirrorarm::tracking::CloudPoint{point.p_C, point.covariance_m2, {}};
}

LessonScene lessonScene(const camera::StereoRig& rig, int frames, TrialRandom& random) {
  LessonScene scene;
  scene.markers_T = randomLayout(kMarkers, random);
  const Swing swing(random);
  const Vector3d middle = swing.middle_CT.translation();
  std::vector<Vector3d> still_C;
  for (int i = 0; i < kStill; ++i) still_C.push_back(about(middle, random));
  for (int f = 0; f < frames; ++f) {
    LessonFrame frame;
    frame.X_CT = swing.at(f / kFrames_Hz);
    std::vector<std::pair<int, Vector3d>> truth_C;
    for (int i = 0; i < kMarkers; ++i)
      truth_C.emplace_back(i, frame.X_CT * scene.markers_T[static_cast<std::size_t>(i)]);
    shuffle(truth_C, random);
    if (f % 2 == 1) truth_C.resize(static_cast<std::size_t>(kMarkers - 1 - random.index(5)));
    for (const auto& p : still_C) truth_C.emplace_back(-1, p);
    for (int i = 0; i < kAnywhere; ++i) truth_C.emplace_back(-1, about(middle, random));
    shuffle(truth_C, random);
    for (const auto& [marker, p_C] : truth_C) {
      const auto point = measuredPoint(rig, p_C, random);
      if (!point) continue;
      frame.cloud.push_back(*point);
      frame.marker_of_point.push_back(marker);
    }
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

}  // namespace mirrorarm::benchmarks::tracking
