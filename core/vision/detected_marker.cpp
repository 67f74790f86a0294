#include "core/vision/detected_marker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace mirrorarm::vision {

Eigen::Matrix2d shapeOf(const Ellipse& ellipse) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(ellipse.angle_rad).toRotationMatrix();
  const Eigen::Vector2d axes(ellipse.semi_major_px, ellipse.semi_minor_px);
  return turn * axes.cwiseAbs2().asDiagonal() * turn.transpose();
}

Ellipse ellipseOf(const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& shape_px2) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(shape_px2);
  const Eigen::Vector2d major = eigen.eigenvectors().col(1);
  double angle = std::atan2(major.y(), major.x());
  if (angle <= -std::numbers::pi / 2) angle += std::numbers::pi;
  if (angle > std::numbers::pi / 2) angle -= std::numbers::pi;
  return {centre_px, std::sqrt(std::max(eigen.eigenvalues()(1), 0.0)),
          std::sqrt(std::max(eigen.eigenvalues()(0), 0.0)), angle};
}

std::string_view id(Rejection reason) {
  switch (reason) {
    case Rejection::kTooSmall:
      return "too_small";
    case Rejection::kTooLarge:
      return "too_large";
    case Rejection::kTooElongated:
      return "too_elongated";
    case Rejection::kNotAnEllipse:
      return "not_an_ellipse";
    case Rejection::kAtBorder:
      return "at_border";
    case Rejection::kSaturated:
      return "saturated";
    case Rejection::kCut:
      return "cut";
  }
  return "";
}

std::string_view id(ExposureWarning warning) {
  switch (warning) {
    case ExposureWarning::kSaturated:
      return "saturated";
    case ExposureWarning::kBrightBackground:
      return "bright_background";
    case ExposureWarning::kTooDark:
      return "too_dark";
  }
  return "";
}

}  // namespace mirrorarm::vision
