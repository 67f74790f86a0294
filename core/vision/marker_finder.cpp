#include "core/vision/marker_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "core/vision/block_map.h"
#include "core/vision/component_scanner.h"
#include "core/vision/disc_estimator.h"

namespace mirrorarm::vision {
namespace {

constexpr std::size_t kLevels = 3;  // a light that is no disc is cut at half its height twice more
constexpr double kSkirt_px = 8.0;   // blur around a disc that is above the threshold, both sides together
constexpr double kElongationSlack = 1.3;  // the pixels of a light against its outline
constexpr double kSaturatedShare = 0.3;   // of a marker's pixels, at the sensor's upper end
constexpr double kDark = 30.0;            // grey: brightest light above the ground, in an image too dark
constexpr double kLitGround = 128.0;
constexpr double kLeastOfUsual = 0.6;   // size of a plate's dot to the median of all
constexpr std::size_t kNeighbours = 9;  // itself and eight around

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

double sizeOf(const DetectedMarker& marker) {
  return std::sqrt(marker.ellipse.semi_major_px * marker.ellipse.semi_minor_px);
}

}  // namespace

struct MarkerFinder::Body {
  Body(const FinderSettings& wanted, std::optional<camera::CameraModel> model)
      : settings(wanted),
        camera(std::move(model)),
        estimator(makeDiscEstimator(settings, camera ? &*camera : nullptr)) {}

  void search(const Region& region);
  void examine(const Component& component, std::size_t level);
  [[nodiscard]] Expected<DetectedMarker, Rejection> measure(const Light& light);
  [[nodiscard]] Light lightOf(const Component& component) const;
  [[nodiscard]] std::optional<Rejection> refuse(const Component& component) const;
  bool splits(const Light& light, std::size_t level);
  void accept(const Component& component, const DetectedMarker& marker);
  void reject(const Eigen::Vector2d& position_px, double extent_px, Rejection reason);
  void dropDoubles();
  [[nodiscard]] double sizeAround(const DetectedMarker& marker);
  void dropSmall();
  void judgeExposure();

  FinderSettings settings;
  std::optional<camera::CameraModel> camera;
  std::unique_ptr<DiscEstimator> estimator;
  Brightness image;
  BlockMap map;
  std::array<ComponentScanner, kLevels> scanners;
  std::vector<Region> regions;
  std::vector<std::pair<double, double>> neighbours;  ///< squared distance and size
  std::vector<double> least_sizes;
  Detection found;
};

void MarkerFinder::Body::search(const Region& region) {
  map.read(image, region);
  found.exposure.background = std::max<double>(found.exposure.background, map.ground());
  found.exposure.noise = std::max<double>(found.exposure.noise, map.noise());
  for (const auto& component : scanners[0].scan(image, map)) examine(component, 0);
}

void MarkerFinder::Body::examine(const Component& component, std::size_t level) {
  found.exposure.brightest = std::max<double>(found.exposure.brightest, component.peak);
  const Light light = lightOf(component);
  auto marker = measure(light);
  // Long lights fall apart at noise near their height: they may be two discs, cut once, but never crumbs.
  const bool crumbles = level > 0 && !marker && marker.error() == Rejection::kTooElongated;
  if (!marker && !crumbles && splits(light, level)) return;
  if (!marker && marker.error() == Rejection::kCut) marker = estimator->measureCut(image, light);
  if (marker)
    accept(component, *marker);
  else
    reject(light.middle_px(), std::max(component.box.width(), component.box.height()), marker.error());
}

Expected<DetectedMarker, Rejection> MarkerFinder::Body::measure(const Light& light) {
  if (const auto reason = refuse(light.component)) return unexpected(*reason);
  return estimator->measure(image, light);
}

Light MarkerFinder::Body::lightOf(const Component& component) const {
  return {component, map.ground(component.x(), component.y()), map.noise(component.x(), component.y())};
}

void MarkerFinder::Body::accept(const Component& component, const DetectedMarker& marker) {
  found.markers.push_back(marker);
  if (component.clipped_px > kSaturatedShare * component.area_px) ++found.exposure.saturated_markers;
}

void MarkerFinder::Body::reject(const Eigen::Vector2d& position_px, double extent_px, Rejection reason) {
  ++found.rejected[static_cast<std::size_t>(reason)];
  if (found.rejected_lights.size() < kMostRejectedLights)
    found.rejected_lights.push_back({position_px, extent_px, reason});
}

/// What the pixels alone tell, before anything is fitted.
std::optional<Rejection> MarkerFinder::Body::refuse(const Component& component) const {
  const int longer = std::max(component.box.width(), component.box.height());
  const auto frame = grown(image.frame(), -1);
  if (longer < 0.6 * settings.min_diameter_px) return Rejection::kTooSmall;
  if (longer > settings.max_diameter_px + kSkirt_px)
    return 2 * component.clipped_px > component.area_px ? Rejection::kSaturated : Rejection::kTooLarge;
  const Eigen::Matrix2d moments = component.moments_px2();
  const double half = 0.5 * moments.trace();
  const double root = std::sqrt(std::max(half * half - moments.determinant(), 0.0));
  const double most = kElongationSlack * settings.max_axis_ratio;
  if (half + root > most * most * (half - root)) return Rejection::kTooElongated;
  if (component.box.left < frame.left || component.box.top < frame.top || component.box.right > frame.right ||
      component.box.bottom > frame.bottom)
    return Rejection::kAtBorder;
  return std::nullopt;
}

/// A light that is no disc may be several, or one in a haze: looks at it again at half its height. False when
/// that gives nothing new.
bool MarkerFinder::Body::splits(const Light& light, std::size_t level) {
  const Component& component = light.component;
  if (level + 1 == kLevels || component.area_px < 4) return false;
  const double share = level == 0 ? 0.5 : 0.75;
  const double height = std::clamp(light.ground + share * light.height(), 0.0, 254.0);
  const auto parts = scanners[level + 1].scan(image, component.box, static_cast<std::uint8_t>(height));
  const bool same = parts.empty() || (parts.size() == 1 && 4 * parts[0].area_px > 3 * component.area_px);
  if (same) return false;
  for (const auto& part : parts) examine(part, level + 1);
  return true;
}

/// Median size of the markers that lie nearest to one.
double MarkerFinder::Body::sizeAround(const DetectedMarker& marker) {
  neighbours.clear();
  for (const auto& other : found.markers)
    neighbours.emplace_back((other.centre_px - marker.centre_px).squaredNorm(), sizeOf(other));
  const std::size_t count = std::min(kNeighbours, neighbours.size());
  std::partial_sort(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(count),
                    neighbours.end());
  neighbours.resize(count);
  const auto middle = neighbours.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(neighbours.begin(), middle, neighbours.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return middle->second;
}

void MarkerFinder::Body::dropSmall() {
  if (!(settings.min_size_of_neighbours > 0.0)) return;
  least_sizes.clear();
  for (const auto& marker : found.markers) least_sizes.push_back(sizeOf(marker));
  std::sort(least_sizes.begin(), least_sizes.end());
  const double usual = least_sizes.empty() ? 0.0 : least_sizes[least_sizes.size() / 2];
  least_sizes.clear();
  for (const auto& marker : found.markers)
    least_sizes.push_back(
        std::max(settings.min_size_of_neighbours * sizeAround(marker), kLeastOfUsual * usual));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.markers.size(); ++i) {
    const DetectedMarker& marker = found.markers[i];
    if (sizeOf(marker) < least_sizes[i])
      reject(marker.centre_px, 2.0 * marker.ellipse.semi_major_px, Rejection::kTooSmall);
    else
      found.markers[kept++] = marker;
  }
  found.markers.resize(kept);
}

void MarkerFinder::Body::judgeExposure() {
  auto& exposure = found.exposure;
  if (2 * exposure.saturated_markers > static_cast<int>(found.markers.size()))
    exposure.warning = ExposureWarning::kSaturated;
  else if (exposure.background > kLitGround)
    exposure.warning = ExposureWarning::kBrightBackground;
  else if (found.markers.empty() && exposure.brightest < exposure.background + kDark)
    exposure.warning = ExposureWarning::kTooDark;
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
  body.dropSmall();
  body.judgeExposure();
  return body.found;
}

}  // namespace mirrorarm::vision
