#include "ui/views/forearm_fit.h"

#include <algorithm>

#include <Eigen/Dense>

namespace mirrorarm::ui {
namespace {

constexpr double kThinnest_m = 0.02, kThickest_m = 0.07, kUsual_m = 0.045;

/// Axes of the cloud: z along it, y outwards, x across.
Eigen::Matrix3d axesOf(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& mean,
                       const Eigen::Vector3d& outwards) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& point : points) scatter += (point - mean) * (point - mean).transpose();
  const Eigen::Matrix3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors();
  Eigen::Matrix3d axes;
  axes.col(2) = principal.col(2);
  axes.col(1) = (outwards - outwards.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return axes;
}

struct Circle {
  double centre_y = 0.0;
  double radius = 0.0;
};

/// The circle with its centre at x = 0 through points (x, y), least squares: x^2 + y^2 = 2 c y + (r^2 - c^2).
Circle circleThrough(const Eigen::Matrix3Xd& points) {
  Eigen::MatrixX2d A(points.cols(), 2);
  A << 2.0 * points.row(1).transpose(), Eigen::VectorXd::Ones(points.cols());
  const Eigen::VectorXd squares = points.topRows<2>().colwise().squaredNorm();
  const Eigen::Vector2d solved = A.colPivHouseholderQr().solve(squares);
  const double radius = std::sqrt(std::max(0.0, solved[1] + solved[0] * solved[0]));
  const bool likely = radius > kThinnest_m && radius < kThickest_m && solved[0] < 0.0;
  return likely ? Circle{solved[0], radius} : Circle{-0.8 * kUsual_m, kUsual_m};
}

}  // namespace

ForearmFit fitForearm(std::span<const Eigen::Vector3d> markers_T, const Eigen::Vector3d& towards_camera_T) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& marker : markers_T) mean += marker / static_cast<double>(markers_T.size());
  const Eigen::Matrix3d R_TA = axesOf(markers_T, mean, towards_camera_T);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(markers_T.size()));
  for (std::size_t i = 0; i < markers_T.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = R_TA.transpose() * (markers_T[i] - mean);
  const Circle circle = circleThrough(points);
  ForearmFit fit;
  fit.X_TA = makeTransform(R_TA, mean + circle.centre_y * R_TA.col(1));
  fit.radius_m = circle.radius;
  fit.half_length_m = points.row(2).cwiseAbs().maxCoeff();
  return fit;
}

}  // namespace mirrorarm::ui
