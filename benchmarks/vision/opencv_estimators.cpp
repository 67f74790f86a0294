#include <algorithm>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "benchmarks/vision/estimators.h"
#include "benchmarks/vision/opencv_view.h"

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kNear_px = 5.0;

Answer nearEnough(const cv::Point2d& centre, const Eigen::Vector2d& near_px) {
  const Eigen::Vector2d centre_px(centre.x, centre.y);
  if (!((centre_px - near_px).norm() < kNear_px)) return unexpected(Miss{});
  return Estimate{centre_px, std::nullopt, false};
}

/// Half-way between the ground and the brightest pixel.
double middleGrey(const cv::Mat& image) {
  std::vector<std::uint8_t> pixels;
  image.reshape(1, 1).copyTo(pixels);
  const auto middle = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
  std::nth_element(pixels.begin(), middle, pixels.end());
  double brightest = 0.0;
  cv::minMaxLoc(image, nullptr, &brightest);
  return 0.5 * (*middle + brightest);
}

using Contours = std::vector<std::vector<cv::Point>>;

const std::vector<cv::Point>* longest(const Contours& contours) {
  constexpr std::size_t kLeastPoints = 6;
  const auto most = std::ranges::max_element(contours, {}, [](const auto& each) { return each.size(); });
  return most == contours.end() || most->size() < kLeastPoints ? nullptr : &*most;
}

class GreyCentroid : public CentreEstimator {
 public:
  std::string name() const override { return "grey_centroid"; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    const cv::Mat grey = viewOf(image).clone();
    cv::subtract(grey, middleGrey(grey), above_);  // below it saturates at 0
    const cv::Moments moments = cv::moments(above_);
    if (moments.m00 <= 0.0) return unexpected(Miss{});
    return nearEnough({moments.m10 / moments.m00, moments.m01 / moments.m00}, near_px);
  }

 private:
  cv::Mat above_;
};

class ContourEllipse : public CentreEstimator {
 public:
  std::string name() const override { return "contour_fitEllipse"; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    const cv::Mat grey = viewOf(image).clone();
    cv::threshold(grey, above_, middleGrey(grey), 255.0, cv::THRESH_BINARY);
    cv::findContours(above_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    const auto* outline = longest(contours_);
    if (outline == nullptr) return unexpected(Miss{});
    return nearEnough(cv::fitEllipse(*outline).center, near_px);
  }

 private:
  cv::Mat above_;
  Contours contours_;
};

class CannyEllipse : public CentreEstimator {
 public:
  std::string name() const override { return "canny_fitEllipseDirect"; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    cv::GaussianBlur(viewOf(image), smooth_, {5, 5}, 1.0);
    cv::Canny(smooth_, edges_, 50.0, 100.0);
    cv::findContours(edges_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    const auto* outline = longest(contours_);
    if (outline == nullptr) return unexpected(Miss{});
    return nearEnough(cv::fitEllipseDirect(*outline).center, near_px);
  }

 private:
  cv::Mat smooth_;
  cv::Mat edges_;
  Contours contours_;
};

class BlobDetector : public CentreEstimator {
 public:
  BlobDetector() {
    cv::SimpleBlobDetector::Params params;
    params.minThreshold = 20.0F;
    params.maxThreshold = 240.0F;
    params.blobColor = 255;
    params.minArea = 8.0F;
    params.maxArea = 5000.0F;
    params.minDistBetweenBlobs = 4.0F;
    params.filterByCircularity = params.filterByConvexity = params.filterByInertia = false;
    detector_ = cv::SimpleBlobDetector::create(params);
  }

  std::string name() const override { return "SimpleBlobDetector"; }

  Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) override {
    detector_->detect(viewOf(image), blobs_);
    const auto distance = [&](const cv::KeyPoint& blob) {
      return (Eigen::Vector2d(blob.pt.x, blob.pt.y) - near_px).norm();
    };
    const auto nearest = std::ranges::min_element(blobs_, {}, distance);
    if (nearest == blobs_.end()) return unexpected(Miss{});
    return nearEnough(nearest->pt, near_px);
  }

 private:
  cv::Ptr<cv::SimpleBlobDetector> detector_;
  std::vector<cv::KeyPoint> blobs_;
};

}  // namespace

std::unique_ptr<CentreEstimator> greyCentroid() { return std::make_unique<GreyCentroid>(); }
std::unique_ptr<CentreEstimator> contourEllipse() { return std::make_unique<ContourEllipse>(); }
std::unique_ptr<CentreEstimator> cannyEllipse() { return std::make_unique<CannyEllipse>(); }
std::unique_ptr<CentreEstimator> blobDetector() { return std::make_unique<BlobDetector>(); }

}  // namespace mirrorarm::benchmarks::vision
