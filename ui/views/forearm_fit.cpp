#include "ui/views/forearm_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mirrorarm::ui {
namespace {

constexpr double kThinnest_m = 0.02, kThickest_m = 0.07, kUsual_m = 0.045;
constexpr double kWorstMisfit_m = 0.02;  // of all markers together
constexpr double kTilt_rad = 0.025;
constexpr int kTilts = 8;

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
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
  double misfit = 0.0;  ///< rms distance of the points from it
};

/// The circle through points (x, y, .), least squares of x^2 + y^2 = 2 a x + 2 b y + c.
Circle circleThrough(const Eigen::Matrix3Xd& points) {
  Eigen::MatrixX3d A(points.cols(), 3);
  A << 2.0 * points.topRows<2>().transpose(), Eigen::VectorXd::Ones(points.cols());
  const Eigen::VectorXd squares = points.topRows<2>().colwise().squaredNorm();
  const Eigen::Vector3d solved = A.colPivHouseholderQr().solve(squares);
  Circle circle;
  circle.centre = solved.head<2>();
  circle.radius = std::sqrt(std::max(0.0, solved[2] + circle.centre.squaredNorm()));
  const Eigen::VectorXd distances = (points.topRows<2>().colwise() - circle.centre).colwise().norm();
  circle.misfit = (distances.array() - circle.radius).matrix().norm();
  return circle;
}

bool isLikely(const Circle& circle) {
  return circle.radius > kThinnest_m && circle.radius < kThickest_m && circle.centre.y() < 0.0;
}

Eigen::Matrix3d tilted(int across, int outwards) {
  return (Eigen::AngleAxisd(kTilt_rad * across, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(kTilt_rad * outwards, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

struct Cylinder {
  Eigen::Matrix3d R_TA = Eigen::Matrix3d::Identity();
  Circle circle;
};

/// The greatest extent of scattered markers lies askew in the arm: of the axes near it the one that suits a
/// cylinder best.
Cylinder bestCylinder(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points_T) {
  Cylinder best{axes, {Eigen::Vector2d(0.0, -0.8 * kUsual_m), kUsual_m, kWorstMisfit_m}};
  for (int across = -kTilts; across <= kTilts; ++across)
    for (int outwards = -kTilts; outwards <= kTilts; ++outwards) {
      const Eigen::Matrix3d R_TA = axes * tilted(across, outwards);
      const Circle circle = circleThrough(R_TA.transpose() * points_T);
      if (isLikely(circle) && circle.misfit < best.circle.misfit) best = {R_TA, circle};
    }
  return best;
}

}  // namespace

ForearmFit fitForearm(std::span<const Eigen::Vector3d> markers_T, const Eigen::Vector3d& towards_camera_T) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& marker : markers_T) mean += marker / static_cast<double>(markers_T.size());
  Eigen::Matrix3Xd points_T(3, static_cast<Eigen::Index>(markers_T.size()));
  for (std::size_t i = 0; i < markers_T.size(); ++i)
    points_T.col(static_cast<Eigen::Index>(i)) = markers_T[i] - mean;
  const auto [R_TA, circle] = bestCylinder(axesOf(markers_T, mean, towards_camera_T), points_T);
  ForearmFit fit;
  fit.X_TA = makeTransform(R_TA, mean + R_TA.leftCols<2>() * circle.centre);
  fit.radius_m = circle.radius;
  fit.half_length_m = (R_TA.col(2).transpose() * points_T).cwiseAbs().maxCoeff();
  return fit;
}

}  // namespace mirrorarm::ui
