#include "benchmarks/vision/reference_chain.h"

#include <vector>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "benchmarks/vision/opencv_view.h"

namespace mirrorarm::benchmarks::vision {
namespace {

/// One camera's way from the raw to the rectified image.
class Side {
 public:
  /// `R_EK` turns the camera's frame into the rectified one.
  Side(const camera::CameraModel& camera, const Eigen::Matrix3d& R_EK) {
    const auto& size = camera.intrinsics();
    cv::Mat x(size.height_px, size.width_px, CV_32FC1), y(size.height_px, size.width_px, CV_32FC1);
    for (int row = 0; row < x.rows; ++row)
      for (int column = 0; column < x.cols; ++column) {
        const Eigen::Vector3d ray_E((column - size.cx_px) / size.fx_px, (row - size.cy_px) / size.fy_px, 1.0);
        const auto pixel = camera.project(R_EK.transpose() * ray_E);
        x.at<float>(row, column) = pixel ? static_cast<float>(pixel->x()) : -1.0F;
        y.at<float>(row, column) = pixel ? static_cast<float>(pixel->y()) : -1.0F;
      }
    cv::convertMaps(x, y, map_, fraction_, CV_16SC2);
  }

  int run(const camera::GreyImage& image) {
    constexpr std::size_t kLeastPoints = 6;
    cv::remap(viewOf(image.view()), rectified_, map_, fraction_, cv::INTER_LINEAR);
    cv::GaussianBlur(rectified_, smooth_, {5, 5}, 1.0);
    cv::Canny(smooth_, edges_, 50.0, 100.0);
    cv::findContours(edges_, contours_, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    int ellipses = 0;
    for (const auto& contour : contours_)
      if (contour.size() >= kLeastPoints && cv::fitEllipseDirect(contour).size.area() > 0.0F) ++ellipses;
    return ellipses;
  }

 private:
  cv::Mat map_, fraction_, rectified_, smooth_, edges_;
  std::vector<std::vector<cv::Point>> contours_;
};

/// x along the baseline, z as the left camera's as far as that goes.
Eigen::Matrix3d rectifiedFromLeft(const camera::StereoRig& rig) {
  const Eigen::Vector3d x = rig.X_RC.inverse().translation().normalized();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitZ().cross(x).normalized();
  Eigen::Matrix3d R_EC;
  R_EC << x.transpose(), y.transpose(), x.cross(y).transpose();
  return R_EC;
}

}  // namespace

struct ReferenceChain::Body {
  Side left, right;
};

ReferenceChain::ReferenceChain(const camera::StereoRig& rig) {
  const Eigen::Matrix3d R_EC = rectifiedFromLeft(rig);
  body_ = std::make_unique<Body>(
      Body{Side(rig.left, R_EC), Side(rig.right, R_EC * rig.X_RC.linear().transpose())});
}
ReferenceChain::~ReferenceChain() = default;

int ReferenceChain::run(const camera::StereoFrame& frame) {
  return body_->left.run(frame.left) + body_->right.run(frame.right);
}

}  // namespace mirrorarm::benchmarks::vision
