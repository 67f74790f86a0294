#include "core/vision/edge_estimator.h"

#include <algorithm>

#include "core/vision/outline.h"

namespace mirrorarm::vision {
namespace {

constexpr int kMargin_px = 5;
constexpr double kCoarser = 2.0;
constexpr double kSigmasAcross = 7.0;   // of a large disc
constexpr double kSigmasAtLeast = 4.0;  // of any disc that is looked at on that scale
constexpr float kStrongShare = 0.10F;   // of the contrast, per sigma; a disc's edge has 0.2 to 0.3
constexpr float kWeakShare = 0.04F;
constexpr float kStrongNoises = 5.0F;
constexpr float kWeakNoises = 2.5F;

EdgeThresholds thresholdsOf(const Light& light, double sigma_px) {
  const auto sigma = static_cast<float>(sigma_px);
  const auto contrast = static_cast<float>(light.height());
  // Standard deviation of the gradient of white noise under a Gaussian: noise / (sqrt(8 pi) sigma^2).
  const float noise = 0.2F * static_cast<float>(light.noise) / (sigma * sigma);
  return {std::max(kStrongShare * contrast / sigma, kStrongNoises * noise),
          std::max(kWeakShare * contrast / sigma, kWeakNoises * noise)};
}

}  // namespace

EdgeEstimator::EdgeEstimator(const FinderSettings& settings, const camera::CameraModel* camera)
    : camera_(camera),
      fine_(settings.edge_sigma_px),
      coarse_(kCoarser * settings.edge_sigma_px),
      disc_(settings) {}

Expected<DetectedMarker, Rejection> EdgeEstimator::measure(const Brightness& image, const Light& light) {
  const auto& box = light.component.box;
  const int shorter = std::min(box.width(), box.height());
  if (shorter >= kSigmasAcross * coarse_.sigma_px()) return measureAt(image, light, coarse_);
  const auto marker = measureAt(image, light, fine_);
  if (marker || shorter < kSigmasAtLeast * coarse_.sigma_px()) return marker;
  return measureAt(image, light, coarse_);
}

Expected<DetectedMarker, Rejection> EdgeEstimator::measureAt(const Brightness& image, const Light& light,
                                                             EdgeDetector& edges) {
  const auto around = intersection(grown(light.component.box, kMargin_px), image.frame());
  const auto thresholds = thresholdsOf(light, edges.sigma_px());
  const auto points = edges.detect(image, around, thresholds);
  selectOutline(points, light.middle_px(), thresholds.strong, outline_);
  return disc_.fit(outline_, camera_, light.noise, edges.sigma_px());
}

}  // namespace mirrorarm::vision
