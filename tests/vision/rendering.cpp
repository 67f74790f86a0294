#include "rendering.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace mirrorarm::vision {
namespace {

constexpr int kFiner = 8;

/// Gaussian on the finer grid, from minus to plus four sigmas.
std::vector<double> gaussian(double sigma_px) {
  const double sigma = sigma_px * kFiner;
  const int reach = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<double> kernel;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i) sum += kernel.emplace_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  for (auto& value : kernel) value /= sum;
  return kernel;
}

/// Rows of `image` (side x side) blurred along x and written as columns: twice gives both directions.
std::vector<double> blurredAndTurned(const std::vector<double>& image, int side,
                                     const std::vector<double>& kernel) {
  const int reach = static_cast<int>(kernel.size() / 2);
  std::vector<double> turned(image.size());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double sum = 0.0;
      for (int k = std::max(-reach, -x); k <= std::min(reach, side - 1 - x); ++k)
        sum +=
            kernel[static_cast<std::size_t>(k + reach)] * image[static_cast<std::size_t>(y * side + x + k)];
      turned[static_cast<std::size_t>(x * side + y)] = sum;
    }
  return turned;
}

}  // namespace

Rendering::Rendering(int width_px, int height_px, double background, double spread_px)
    : width_px_(width_px),
      height_px_(height_px),
      kernel_(gaussian(spread_px)),
      light_(static_cast<std::size_t>(width_px * height_px), background) {}

template <class Inside>
void Rendering::add(const Eigen::Vector2d& centre_px, double reach_px, double level, Inside inside) {
  const int half = static_cast<int>(std::ceil(reach_px)) + 4;
  const int left = static_cast<int>(std::floor(centre_px.x())) - half;
  const int top = static_cast<int>(std::floor(centre_px.y())) - half;
  const int side_px = 2 * half + 2;
  const int side = side_px * kFiner;
  std::vector<double> fine(static_cast<std::size_t>(side * side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Eigen::Vector2d at(left - 0.5 + (x + 0.5) / kFiner, top - 0.5 + (y + 0.5) / kFiner);
      fine[static_cast<std::size_t>(y * side + x)] = inside(Eigen::Vector2d(at - centre_px)) ? 1.0 : 0.0;
    }
  fine = blurredAndTurned(blurredAndTurned(fine, side, kernel_), side, kernel_);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int px = left + x / kFiner;
      const int py = top + y / kFiner;
      if (px < 0 || py < 0 || px >= width_px_ || py >= height_px_) continue;
      light_[static_cast<std::size_t>(py * width_px_ + px)] +=
          level * fine[static_cast<std::size_t>(y * side + x)] / (kFiner * kFiner);
    }
}

void Rendering::disc(const Eigen::Vector2d& centre_px, const Eigen::Matrix2d& axes_px, double level) {
  const Eigen::Matrix2d inverse = axes_px.inverse();
  add(centre_px, axes_px.norm(), level,
      [&](const Eigen::Vector2d& p) { return (inverse * p).squaredNorm() <= 1.0; });
}

void Rendering::disc(const Eigen::Vector2d& centre_px, double diameter_px, double level) {
  disc(centre_px, 0.5 * diameter_px * Eigen::Matrix2d::Identity(), level);
}

void Rendering::cutDisc(const Eigen::Vector2d& centre_px, double diameter_px, double cut_px, double level) {
  add(centre_px, 0.5 * diameter_px, level,
      [&](const Eigen::Vector2d& p) { return p.norm() <= 0.5 * diameter_px && p.x() <= cut_px; });
}

void Rendering::strip(const Eigen::Vector2d& centre_px, double length_px, double width_px, double angle_rad,
                      double level) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-angle_rad).toRotationMatrix();
  add(centre_px, 0.5 * std::hypot(length_px, width_px), level, [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d q = turn * p;
    return std::abs(q.x()) <= 0.5 * length_px && std::abs(q.y()) <= 0.5 * width_px;
  });
}

void Rendering::speck(int x, int y, double level) {
  light_[static_cast<std::size_t>(y * width_px_ + x)] += level;
}

camera::GreyImage Rendering::expose(double sigma, std::mt19937& random) const {
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<std::uint8_t> pixels(light_.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] =
        static_cast<std::uint8_t>(std::clamp(std::round(light_[i] + sigma * noise(random)), 0.0, 255.0));
  return {width_px_, height_px_, std::move(pixels)};
}

}  // namespace mirrorarm::vision
