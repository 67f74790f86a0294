#include "core/tracking/lesson_network.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace mirrorarm::tracking {
namespace {

constexpr std::size_t kFewestForPose = 3;
constexpr std::size_t kMaxWork = 150'000;  // frames times markers squared
constexpr std::size_t kFewestFrames = 60;
constexpr double kClearlyMore = 1.6;  // than the quiet markers: their spread is known to a few percent

std::vector<int> markersById(std::span<const RunningModel::Point> points) {
  int last = 0;
  for (const auto& point : points) last = std::max(last, point.id);
  std::vector<int> marker_of_id(static_cast<std::size_t>(last) + 1, -1);
  for (std::size_t i = 0; i < points.size(); ++i)
    marker_of_id[static_cast<std::size_t>(points[i].id)] = static_cast<int>(i);
  return marker_of_id;
}

NetworkFrame chosenOf(const NetworkFrame& keyframe, std::span<const int> marker_of_id) {
  NetworkFrame frame{keyframe.X_CT, {}};
  for (const auto& sighting : keyframe.sightings) {
    const auto id = static_cast<std::size_t>(sighting.marker);
    if (id >= marker_of_id.size() || marker_of_id[id] < 0) continue;
    frame.sightings.push_back(sighting);
    frame.sightings.back().marker = marker_of_id[id];
  }
  return frame;
}

bool knowsSensor(const MarkerNetwork& network) {
  for (const auto& frame : network.frames)
    for (const auto& sighting : frame.sightings)
      if (sighting.covariance_m2.trace() <= 0.0) return false;
  return true;
}

}  // namespace

LessonNetwork networkOf(std::span<const RunningModel::Point> points,
                        std::span<const NetworkFrame> keyframes) {
  LessonNetwork lesson;
  for (const auto& point : points) {
    lesson.network.markers_T.push_back(point.mean_T);
    lesson.network.spread_m.push_back(point.spread_m);
  }
  const auto marker_of_id = markersById(points);
  const std::size_t most =
      std::max(kFewestFrames, kMaxWork / std::max<std::size_t>(1, points.size() * points.size()));
  const std::size_t step = (keyframes.size() + most - 1) / most;
  for (std::size_t k = 0; k < keyframes.size(); k += std::max<std::size_t>(1, step)) {
    NetworkFrame frame = chosenOf(keyframes[k], marker_of_id);
    if (frame.sightings.size() < kFewestForPose) continue;
    lesson.network.frames.push_back(std::move(frame));
    lesson.keyframe.push_back(k);
  }
  return lesson;
}

std::vector<double> skinSigmas(const MarkerNetwork& adjusted) {
  std::vector<double> skin_m = adjusted.spread_m;
  if (knowsSensor(adjusted)) return skin_m;
  std::vector<double> sorted = skin_m;
  std::sort(sorted.begin(), sorted.end());
  const double quiet = sorted[sorted.size() / 4];
  for (double& sigma : skin_m)
    sigma = sigma > kClearlyMore * quiet ? std::sqrt(sigma * sigma - quiet * quiet) : 0.0;
  return skin_m;
}

double largestSigma(const BundleAdjustment& adjustment, std::size_t markers) {
  double largest = 0.0;
  for (std::size_t i = 0; i < markers; ++i) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(adjustment.covarianceOf(i), Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues()[2]);
  }
  return std::sqrt(largest);
}

}  // namespace mirrorarm::tracking
