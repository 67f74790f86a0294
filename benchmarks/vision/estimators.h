#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/camera/image.h"
#include "core/common/expected.h"
#include "core/vision/detected_marker.h"
#include "core/vision/finder_settings.h"

namespace mirrorarm::benchmarks::vision {

namespace product = mirrorarm::vision;

/// What a method says about the disc of a small image.
struct Estimate {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  std::optional<Eigen::Matrix2d> covariance_px2;  ///< of methods that tell one
  bool cut = false;                               ///< says that something covers a part
};

/// Why there is no estimate: what a method of ours says about the light within 5 px, or that none is there.
struct Miss {
  std::optional<product::Rejection> reason;
};
using Answer = Expected<Estimate, Miss>;

/// One way to measure the centre of a bright disc. Keeps its buffers; one thread.
class CentreEstimator {
 public:
  virtual ~CentreEstimator() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// True for the methods of this project: goals speak of them.
  [[nodiscard]] virtual bool isOurs() const { return false; }
  /// The disc nearest to `near_px`.
  [[nodiscard]] virtual Answer estimate(const camera::ImageView& image, const Eigen::Vector2d& near_px) = 0;
};

using Estimators = std::vector<std::unique_ptr<CentreEstimator>>;

/// The finder of this project with one of its methods, on raw pixels.
[[nodiscard]] std::unique_ptr<CentreEstimator> finderEstimator(product::CentreMethod method);

/// Threshold in the middle between the ground (median) and the brightest pixel; what is above it weighs.
[[nodiscard]] std::unique_ptr<CentreEstimator> greyCentroid();
/// The same threshold, cv::findContours, cv::fitEllipse of the longest contour.
[[nodiscard]] std::unique_ptr<CentreEstimator> contourEllipse();
/// cv::GaussianBlur, cv::Canny, cv::findContours, cv::fitEllipseDirect of the longest contour.
[[nodiscard]] std::unique_ptr<CentreEstimator> cannyEllipse();
/// cv::SimpleBlobDetector for bright blobs of any shape.
[[nodiscard]] std::unique_ptr<CentreEstimator> blobDetector();
/// vpDot2, started at the disc, without its test of the shape.
[[nodiscard]] std::unique_ptr<CentreEstimator> vispDot();

/// The methods of others.
[[nodiscard]] Estimators otherEstimators();
/// The default method of ours alone.
[[nodiscard]] Estimators defaultEstimator();
/// All of them, ours first, the default method at the front.
[[nodiscard]] Estimators allEstimators();

}  // namespace mirrorarm::benchmarks::vision
