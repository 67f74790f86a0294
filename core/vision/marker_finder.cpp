#include "core/vision/marker_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/vision/component_scanner.h"
#include "core/vision/disc_fit.h"
#include "core/vision/edge_detector.h"
#include "core/vision/outline.h"
#include "core/vision/threshold_map.h"

namespace mirrorarm::vision {
namespace {

constexpr std::size_t kLevels = 3;  // a candidate that is no disc is cut at half its height twice more
constexpr double kSkirt_px = 8.0;   // blur around a disc that is above the threshold, both sides together
constexpr int kRoiMargin_px = 5;
constexpr double kCoarser = 2.0;
constexpr double kSigmasAcross = 7.0;   // of a large disc
constexpr double kSigmasAtLeast = 4.0;  // of any disc that is looked at on that scale
constexpr float kStrongShare = 0.10F;   // of the contrast, per sigma; a disc's edge has 0.2 to 0.3
constexpr float kWeakShare = 0.04F;
constexpr float kStrongNoises = 5.0F;
constexpr float kWeakNoises = 2.5F;

/// Regions cut to the image, those that touch united, so that no disc is found twice.
void unite(std::span<const Region> wanted, const Region& frame, std::vector<Region>& regions) {
  regions.clear();
  for (const auto& one : wanted) {
    Region region = intersection(one, frame);
    if (region.empty()) continue;
    for (bool again = true; std::exchange(again, false);) {
      std::erase_if(regions, [&](const Region& other) {
        if (intersection(region, other).empty()) return false;
        region = hull(region, other);
        return again = true;
      });
    }
    regions.push_back(region);
  }
}

}  // namespace

struct MarkerFinder::Body {
  Body(const FinderSettings& wanted, std::optional<camera::CameraModel> model)
      : settings(wanted),
        camera(std::move(model)),
        fine(wanted.edge_sigma_px),
        coarse(kCoarser * wanted.edge_sigma_px),
        disc(wanted) {}

  void search(const Region& region);
  void examine(const Component& component, std::size_t level);
  [[nodiscard]] Expected<DetectedMarker, Rejection> measure(const Component& component);
  [[nodiscard]] Expected<DetectedMarker, Rejection> measureAt(const Component& component,
                                                              EdgeDetector& edges);
  [[nodiscard]] std::optional<Rejection> refuse(const Component& component) const;
  [[nodiscard]] EdgeThresholds edgeThresholds(const Component& component, double sigma_px) const;
  bool splits(const Component& component, std::size_t level);
  void reject(const Component& component, Rejection reason);
  void dropDoubles();

  FinderSettings settings;
  std::optional<camera::CameraModel> camera;
  Brightness image;
  ThresholdMap map;
  std::array<ComponentScanner, kLevels> scanners;
  EdgeDetector fine;
  EdgeDetector coarse;  ///< for large discs: their outline averages over more pixels at no loss
  DiscFit disc;
  std::vector<EdgePoint> outline;
  std::vector<Region> regions;
  Detection found;
};

void MarkerFinder::Body::search(const Region& region) {
  map.estimate(image, region);
  for (const auto& component : scanners[0].scan(image, region, map)) examine(component, 0);
}

void MarkerFinder::Body::examine(const Component& component, std::size_t level) {
  const auto marker = measure(component);
  if (marker)
    found.markers.push_back(*marker);
  else if (!splits(component, level))
    reject(component, marker.error());
}

void MarkerFinder::Body::reject(const Component& component, Rejection reason) {
  ++found.rejected[static_cast<std::size_t>(reason)];
  if (found.rejected_lights.size() == kMostRejectedLights) return;
  const double extent_px = std::max(component.box.width(), component.box.height());
  found.rejected_lights.push_back({{component.x(), component.y()}, extent_px, reason});
}

std::optional<Rejection> MarkerFinder::Body::refuse(const Component& component) const {
  const int longer = std::max(component.box.width(), component.box.height());
  const int shorter = std::min(component.box.width(), component.box.height());
  const auto frame = grown(image.frame(), -1);
  if (longer < 0.6 * settings.min_diameter_px) return Rejection::kTooSmall;
  if (longer > settings.max_diameter_px + kSkirt_px)
    return 2 * component.clipped_px > component.area_px ? Rejection::kSaturated : Rejection::kTooLarge;
  if (longer > settings.max_axis_ratio * (shorter + 2)) return Rejection::kTooElongated;
  if (component.box.left < frame.left || component.box.top < frame.top || component.box.right > frame.right ||
      component.box.bottom > frame.bottom)
    return Rejection::kAtBorder;
  return std::nullopt;
}

EdgeThresholds MarkerFinder::Body::edgeThresholds(const Component& component, double sigma_px) const {
  const auto sigma = static_cast<float>(sigma_px);
  const float contrast = static_cast<float>(component.peak) - map.background(component.x(), component.y());
  // Standard deviation of the gradient of white noise under a Gaussian: noise / (sqrt(8 pi) sigma^2).
  const float noise = 0.2F * map.noise(component.x(), component.y()) / (sigma * sigma);
  return {std::max(kStrongShare * contrast / sigma, kStrongNoises * noise),
          std::max(kWeakShare * contrast / sigma, kWeakNoises * noise)};
}

Expected<DetectedMarker, Rejection> MarkerFinder::Body::measure(const Component& component) {
  if (const auto reason = refuse(component)) return unexpected(*reason);
  const int shorter = std::min(component.box.width(), component.box.height());
  if (shorter >= kSigmasAcross * coarse.sigma_px()) return measureAt(component, coarse);
  const auto marker = measureAt(component, fine);
  if (marker || shorter < kSigmasAtLeast * coarse.sigma_px()) return marker;
  return measureAt(component, coarse);
}

Expected<DetectedMarker, Rejection> MarkerFinder::Body::measureAt(const Component& component,
                                                                  EdgeDetector& edges) {
  const auto around = intersection(grown(component.box, kRoiMargin_px), image.frame());
  const auto thresholds = edgeThresholds(component, edges.sigma_px());
  const auto points = edges.detect(image, around, thresholds);
  selectOutline(points, {component.x(), component.y()}, thresholds.strong, outline);
  const double noise = map.noise(component.x(), component.y());
  return disc.fit(outline, camera ? &*camera : nullptr, noise, edges.sigma_px());
}

/// A candidate that is no disc may be several, or one in a haze: looks at it again at half its height. False
/// when that gives nothing new.
bool MarkerFinder::Body::splits(const Component& component, std::size_t level) {
  if (level + 1 == kLevels || component.area_px < 4) return false;
  const float background = map.background(component.x(), component.y());
  const float share = level == 0 ? 0.5F : 0.75F;
  const float height = background + share * (static_cast<float>(component.peak) - background);
  const auto parts = scanners[level + 1].scan(image, component.box,
                                              static_cast<std::uint8_t>(std::clamp(height, 0.0F, 254.0F)));
  const bool same = parts.empty() || (parts.size() == 1 && 4 * parts[0].area_px > 3 * component.area_px);
  if (same) return false;
  for (const auto& part : parts) examine(part, level + 1);
  return true;
}

void MarkerFinder::Body::dropDoubles() {
  auto& markers = found.markers;
  std::sort(markers.begin(), markers.end(), [](const DetectedMarker& a, const DetectedMarker& b) {
    return a.outline_fraction > b.outline_fraction;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const bool twice = std::any_of(
        markers.begin(), markers.begin() + static_cast<std::ptrdiff_t>(kept), [&](const auto& other) {
          return (other.centre_px - markers[i].centre_px).norm() < std::max(1.0, other.ellipse.semi_minor_px);
        });
    if (!twice) markers[kept++] = markers[i];
  }
  markers.resize(kept);
}

MarkerFinder::MarkerFinder(const FinderSettings& settings, std::optional<camera::CameraModel> camera)
    : body_(std::make_unique<Body>(settings, std::move(camera))) {}
MarkerFinder::~MarkerFinder() = default;
MarkerFinder::MarkerFinder(MarkerFinder&&) noexcept = default;
MarkerFinder& MarkerFinder::operator=(MarkerFinder&&) noexcept = default;

const Detection& MarkerFinder::find(const camera::ImageView& image, std::span<const Region> regions) {
  auto& body = *body_;
  body.found.markers.clear();
  body.found.rejected.fill(0);
  body.found.rejected_lights.clear();
  body.found.exposure = {};
  if (image.empty()) return body.found;
  body.image = {image, static_cast<std::uint8_t>(body.settings.dark_on_bright ? 255 : 0)};
  const Region whole = body.image.frame();
  unite(regions.empty() ? std::span<const Region>(&whole, 1) : regions, whole, body.regions);
  for (const auto& region : body.regions) body.search(region);
  body.dropDoubles();
  return body.found;
}

}  // namespace mirrorarm::vision
