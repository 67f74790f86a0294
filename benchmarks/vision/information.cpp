#include "benchmarks/vision/information.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr int kParameters = 10;  // centre first, the ramp last
constexpr int kImage_px = 48;
using Information = Eigen::Matrix<double, kParameters, kParameters>;

Disc shifted(Disc disc, int parameter, double step) {
  switch (parameter) {
    case 0:
    case 1:
      disc.centre_px[parameter] += step;
      break;
    case 2:
      disc.axes_px(0, 0) += step;
      break;
    case 3:
      disc.axes_px(0, 1) += step;
      disc.axes_px(1, 0) += step;
      break;
    case 4:
      disc.axes_px(1, 1) += step;
      break;
    case 5:
      disc.background += step;
      break;
    case 6:
      disc.contrast += step;
      break;
    case 7:
      disc.spread_px += step;
      break;
    default:
      disc.slope[parameter - 8] += step;
  }
  return disc;
}

/// The disc in the middle of an image just large enough; a shift by whole pixels changes nothing.
Disc inSmallImage(Disc disc) {
  const Eigen::Vector2d whole = disc.centre_px.array().round();
  disc.centre_px += Eigen::Vector2d::Constant(0.5 * kImage_px) - whole;
  return disc;
}

/// The ramp is around the given disc's centre, not around the shifted one: a shift must not carry it along.
Light lightShifted(const Disc& disc, int parameter, double step) {
  const Disc moved = shifted(disc, parameter, step);
  Light light(kImage_px, kImage_px, moved.background);
  addSurface(light, ellipseOutline(moved.centre_px, moved.axes_px), moved.spread_px,
             {moved.contrast, disc.centre_px, moved.slope});
  return light;
}

Information informationOf(const Disc& disc, double sigma) {
  constexpr double kStep = 1e-3;
  Eigen::MatrixXd J(kImage_px * kImage_px, kParameters);
  for (int parameter = 0; parameter < kParameters; ++parameter) {
    const Light above = lightShifted(disc, parameter, kStep);
    const Light below = lightShifted(disc, parameter, -kStep);
    for (int i = 0; i < J.rows(); ++i) {
      const auto pixel = static_cast<std::size_t>(i);
      J(i, parameter) = (above.grey[pixel] - below.grey[pixel]) / (2.0 * kStep * sigma);
    }
  }
  return J.transpose() * J;
}

double boundOf(const Information& information, int parameters) {
  const Eigen::MatrixXd known = information.topLeftCorner(parameters, parameters);
  const Eigen::MatrixXd covariance = known.ldlt().solve(Eigen::MatrixXd::Identity(parameters, parameters));
  return std::sqrt(0.5 * covariance.topLeftCorner<2, 2>().trace());
}

}  // namespace

CentreBound centreBound(const Disc& disc, double sigma) {
  const Information information = informationOf(inSmallImage(disc), sigma);
  return {boundOf(information, 2), boundOf(information, 8), boundOf(information, kParameters)};
}

double centreBoundFormula(const Disc& disc, double sigma) {
  constexpr int kSteps = 256;
  Eigen::Matrix2d normals = Eigen::Matrix2d::Zero();  // integral of n n^T around the outline
  for (int i = 0; i < kSteps; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kSteps;
    const Eigen::Vector2d tangent = disc.axes_px * Eigen::Vector2d(-std::sin(t), std::cos(t));
    const Eigen::Vector2d normal = Eigen::Vector2d(tangent.y(), -tangent.x()).normalized();
    normals += 2.0 * std::numbers::pi / kSteps * tangent.norm() * normal * normal.transpose();
  }
  const double snr = disc.contrast / sigma;
  const double blur = std::hypot(disc.spread_px, std::sqrt(1.0 / 12.0));
  const double per_circle = 0.5 * std::numbers::pi;  // of that integral, for diameter 1
  const double effective_diameter = 2.0 / (per_circle * normals.inverse().trace());
  return std::sqrt(4.0 * blur / (std::sqrt(std::numbers::pi) * effective_diameter)) / snr;
}

}  // namespace mirrorarm::benchmarks::vision
