#include "core/vision/conic_estimator.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/vision/small_cholesky.h"

namespace mirrorarm::vision {
namespace {

constexpr int kMargin_px = 2;
constexpr double kLeastGradient = 0.04;  // of the light a pixel
constexpr double kGradientNoises = 2.0;
constexpr double kOverBound = 1.6 * 1.6;      // variance over the Cramer-Rao bound, as measured
constexpr double kQuantisation = 1.0 / 12.0;  // grey^2
constexpr double kMostResidual = 0.08;        // of the radius, that lines may miss the conic by

/// Gradient by Sobel's operator [grey/px].
Eigen::Vector2d gradientAt(const Brightness& image, int x, int y) {
  const auto at = [&](int dx, int dy) { return static_cast<double>(image.at(x + dx, y + dy)); };
  const double right = at(1, -1) + 2.0 * at(1, 0) + at(1, 1);
  const double left = at(-1, -1) + 2.0 * at(-1, 0) + at(-1, 1);
  const double below = at(-1, 1) + 2.0 * at(0, 1) + at(1, 1);
  const double above = at(-1, -1) + 2.0 * at(0, -1) + at(1, -1);
  return {(right - left) / 8.0, (below - above) / 8.0};
}

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/// Normal equations of l^T C l = 0 over all lines, C(2, 2) = 1.
struct LineSums {
  Matrix5 matrix = Matrix5::Zero();
  Vector5 vector = Vector5::Zero();
  double squares = 0.0;
  double weight = 0.0;
  int lines = 0;
  /// What the same gradients know, in units of the image's noise, of moving the disc and of stretching it
  /// (xx, xy, yy): Fisher's information.
  Matrix5 information = Matrix5::Zero();

  void add(const Eigen::Vector2d& gradient, const Eigen::Vector2d& p) {
    Vector5 motion;
    motion << gradient, gradient.x() * p.x(), gradient.x() * p.y() + gradient.y() * p.x(),
        gradient.y() * p.y();
    information += motion * motion.transpose();
    const double c = -gradient.dot(p);
    Vector5 row;
    row << gradient.x() * gradient.x(), gradient.x() * gradient.y(), gradient.y() * gradient.y(),
        gradient.x() * c, gradient.y() * c;
    matrix += row * row.transpose();
    vector -= row * (c * c);
    squares += c * c * c * c;
    weight += gradient.squaredNorm() * gradient.squaredNorm();
    ++lines;
  }
};

LineSums linesAround(const Brightness& image, const Light& light, double scale_px) {
  const Region window = intersection(grown(light.component.box, kMargin_px), grown(image.frame(), -1));
  const double least =
      std::max(kLeastGradient * light.height(), kGradientNoises * light.noise * std::sqrt(12.0) / 8.0);
  LineSums sums;
  for (int y = window.top; y <= window.bottom; ++y)
    for (int x = window.left; x <= window.right; ++x) {
      const Eigen::Vector2d gradient = gradientAt(image, x, y);
      const Eigen::Vector2d p = (Eigen::Vector2d(x, y) - light.middle_px()) / scale_px;
      if (gradient.norm() > least && gradient.dot(p) < 0.0) sums.add(gradient / light.height(), p);
    }
  return sums;
}

/// Covariance of a shape's (xx, xy, yy) from that of a small stretch E of the plane: Q becomes Q + EQ + QE.
Eigen::Matrix3d shapeCovariance(const Eigen::Matrix2d& shape, const Eigen::Matrix3d& of_stretch) {
  Eigen::Matrix3d J;
  const Eigen::Matrix2d bases[] = {(Eigen::Matrix2d() << 1.0, 0.0, 0.0, 0.0).finished(),
                                   (Eigen::Matrix2d() << 0.0, 1.0, 1.0, 0.0).finished(),
                                   (Eigen::Matrix2d() << 0.0, 0.0, 0.0, 1.0).finished()};
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix2d change = bases[k] * shape + shape * bases[k];
    J.col(k) << change(0, 0), change(0, 1), change(1, 1);
  }
  return J * of_stretch * J.transpose();
}

/// Fills in how certain centre and shape are; false when the gradients do not tell.
bool setCertainty(const LineSums& sums, const Light& light, double scale_px, DetectedMarker& marker) {
  SmallCholesky<5> factor;
  if (!factor.factorise(sums.information)) return false;
  const double variance =
      kOverBound * (light.noise * light.noise + kQuantisation) / (light.height() * light.height());
  const Matrix5 covariance = variance * factor.inverse();
  marker.covariance_px2 = covariance.topLeftCorner<2, 2>();
  marker.shape_covariance_px4 =
      shapeCovariance(shapeOf(marker.ellipse), covariance.bottomRightCorner<3, 3>() / (scale_px * scale_px));
  return true;
}

}  // namespace

Expected<DetectedMarker, Rejection> ConicEstimator::measure(const Brightness& image, const Light& light) {
  const double scale_px = std::sqrt(2.0 * light.component.moments_px2().trace());
  const LineSums sums = linesAround(image, light, scale_px);
  SmallCholesky<5> factor;
  if (sums.lines < 12 || !factor.factorise(sums.matrix)) return unexpected(Rejection::kNotAnEllipse);
  const Vector5 conic = factor.solve(sums.vector);
  const Eigen::Vector2d centre = 0.5 * conic.tail<2>();
  Eigen::Matrix2d quadratic;
  quadratic << conic(0), 0.5 * conic(1), 0.5 * conic(1), conic(2);
  const Eigen::Matrix2d shape = centre * centre.transpose() - quadratic;
  if (!shape.allFinite() || !(shape(0, 0) > 0.0) || !(shape.determinant() > 0.0))
    return unexpected(Rejection::kNotAnEllipse);

  DetectedMarker marker;
  marker.centre_px = light.middle_px() + scale_px * centre;
  marker.ellipse = ellipseOf(marker.centre_px, scale_px * scale_px * shape);
  if (!setCertainty(sums, light, scale_px, marker)) return unexpected(Rejection::kNotAnEllipse);
  marker.outline_fraction = 1.0;
  // A line that touches the unit circle and is moved by e changes l^T C l by 2 e.
  const double left_over = std::max(sums.squares - conic.dot(sums.vector), 0.0);
  const double miss = 0.5 * std::sqrt(left_over / std::max(sums.weight, 1e-12));
  const double tolerance = settings_.outline_tolerance_px / scale_px + settings_.outline_tolerance_of_radius;
  if (!(miss < kMostResidual + 2.0 * tolerance)) return unexpected(Rejection::kNotAnEllipse);
  return withinLimits(marker, settings_);
}

}  // namespace mirrorarm::vision
