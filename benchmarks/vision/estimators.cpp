#include "benchmarks/vision/estimators.h"

#include <algorithm>

#include "benchmarks/vision/visp_dot.h"
#include "core/vision/marker_finder.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kNear_px = 5.0;

Miss missIn(const product::Detection& found, const Eigen::Vector2d& near_px) {
  for (const auto& light : found.rejected_lights)
    if ((light.position_px - near_px).norm() < kNear_px) return {light.reason};
  return {};
}

class FinderEstimator : public CentreEstimator {
 public:
  explicit FinderEstimator(const product::FinderSettings& settings)
      : name_(product::id(settings.method)), finder_(settings) {}

  std::string name() const override { return name_; }
  bool isOurs() const override { return true; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    const product::Detection& found = finder_.find(image);
    const auto distance = [&](const product::DetectedMarker& marker) {
      return (marker.centre_px - near_px).norm();
    };
    const auto nearest = std::ranges::min_element(found.markers, {}, distance);
    if (nearest == found.markers.end() || !(distance(*nearest) < kNear_px))
      return unexpected(missIn(found, near_px));
    return Estimate{nearest->centre_px, nearest->covariance_px2, nearest->cut};
  }

 private:
  std::string name_;
  product::MarkerFinder finder_;
};

class VispEstimator : public CentreEstimator {
 public:
  std::string name() const override { return "vpDot2"; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    const auto centre =
        dot_.centre(image.data, image.width_px, image.height_px, image.stride, near_px.x(), near_px.y());
    if (!centre) return unexpected(Miss{});
    const Eigen::Vector2d centre_px((*centre)[0], (*centre)[1]);
    if (!((centre_px - near_px).norm() < kNear_px)) return unexpected(Miss{});
    return Estimate{centre_px, std::nullopt, false};
  }

 private:
  VispDot dot_;
};

}  // namespace

std::unique_ptr<CentreEstimator> finderEstimator(product::CentreMethod method) {
  product::FinderSettings settings;
  settings.method = method;
  return std::make_unique<FinderEstimator>(settings);
}

std::unique_ptr<CentreEstimator> vispDot() { return std::make_unique<VispEstimator>(); }

Estimators otherEstimators() {
  Estimators others;
  others.push_back(greyCentroid());
  others.push_back(cannyEllipse());
  others.push_back(contourEllipse());
  others.push_back(blobDetector());
  others.push_back(vispDot());
  return others;
}

Estimators defaultEstimator() {
  Estimators alone;
  alone.push_back(finderEstimator(product::FinderSettings{}.method));
  return alone;
}

Estimators allEstimators() {
  Estimators all;
  using enum product::CentreMethod;
  for (const auto method : {kMaximumLikelihood, kDualConic, kLindebergFitzgibbon})
    all.push_back(finderEstimator(method));
  for (auto& other : otherEstimators()) all.push_back(std::move(other));
  return all;
}

}  // namespace mirrorarm::benchmarks::vision
