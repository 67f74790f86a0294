#include "core/vision/edge_detector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorarm::vision {
namespace {

constexpr double kKernelReach = 4.0;  // sigmas
constexpr int kRim = 2;               // pixels that the third differences need
constexpr int kUnknown = -2;
constexpr int kNone = -1;

std::vector<float> halfGaussian(double sigma_px) {
  const int reach = std::max(1, static_cast<int>(std::ceil(kKernelReach * sigma_px)));
  std::vector<float> half;
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    const double value = std::exp(-0.5 * i * i / (sigma_px * sigma_px));
    half.push_back(static_cast<float>(value));
    sum += i == 0 ? value : 2.0 * value;
  }
  for (auto& value : half) value /= static_cast<float>(sum);
  return half;
}

/// out[x] = sum of kernel over `taps`, which holds `reach` values more on each side of out's range.
void convolve(const float* taps, std::ptrdiff_t stride, const std::vector<float>& kernel, float* out,
              int count) {
  for (int x = 0; x < count; ++x) out[x] = kernel[0] * taps[x];
  for (std::size_t k = 1; k < kernel.size(); ++k) {
    const float* before = taps - static_cast<std::ptrdiff_t>(k) * stride;
    const float* behind = taps + static_cast<std::ptrdiff_t>(k) * stride;
    const float weight = kernel[k];
    for (int x = 0; x < count; ++x) out[x] += weight * (before[x] + behind[x]);
  }
}

}  // namespace

EdgeDetector::EdgeDetector(double sigma_px) : sigma_px_(sigma_px), kernel_(halfGaussian(sigma_px)) {}

std::span<const EdgePoint> EdgeDetector::detect(const Brightness& image, const Region& region,
                                                const EdgeThresholds& thresholds) {
  thresholds_ = thresholds;
  region_ = region;
  width_ = region.width();
  height_ = region.height();
  points_.clear();
  parents_.clear();
  if (width_ <= 2 * kRim || height_ <= 2 * kRim) return points_;
  smooth(image);
  differentiate();
  crossings_.assign(2 * at(0, height_), kUnknown);
  for (int y = kRim; y + 1 < height_ - kRim; ++y)
    for (int x = kRim; x + 1 < width_ - kRim; ++x) linkCell(x, y);
  keepStrong();
  return points_;
}

void EdgeDetector::smooth(const Brightness& image) {
  const int reach = static_cast<int>(kernel_.size()) - 1;
  const int tall = height_ + 2 * reach;
  line_.resize(static_cast<std::size_t>(width_ + 2 * reach));
  rows_.resize(at(0, tall));
  smoothed_.resize(at(0, height_));
  for (int i = 0; i < tall; ++i) {
    const int y = std::clamp(region_.top + i - reach, 0, image.image.height_px - 1);
    for (int j = 0; j < width_ + 2 * reach; ++j) {
      const int x = std::clamp(region_.left + j - reach, 0, image.image.width_px - 1);
      line_[static_cast<std::size_t>(j)] = image.at(x, y);
    }
    convolve(line_.data() + reach, 1, kernel_, rows_.data() + at(0, i), width_);
  }
  for (int i = 0; i < height_; ++i)
    convolve(rows_.data() + at(0, i + reach), width_, kernel_, smoothed_.data() + at(0, i), width_);
}

void EdgeDetector::differentiate() {
  differential_.resize(at(0, height_));
  const std::ptrdiff_t w = width_;
  for (int y = kRim; y < height_ - kRim; ++y) {
    for (int x = kRim; x < width_ - kRim; ++x) {
      const float* p = smoothed_.data() + at(x, y);
      const float Lx = 0.5F * (p[1] - p[-1]);
      const float Ly = 0.5F * (p[w] - p[-w]);
      const float Lxx = p[1] - 2.0F * p[0] + p[-1];
      const float Lyy = p[w] - 2.0F * p[0] + p[-w];
      const float Lxy = 0.25F * (p[w + 1] - p[w - 1] - p[-w + 1] + p[-w - 1]);
      const float Lxxx = 0.5F * (p[2] - 2.0F * p[1] + 2.0F * p[-1] - p[-2]);
      const float Lyyy = 0.5F * (p[2 * w] - 2.0F * p[w] + 2.0F * p[-w] - p[-2 * w]);
      const float Lxxy = 0.5F * (p[w + 1] - 2.0F * p[w] + p[w - 1] - p[-w + 1] + 2.0F * p[-w] - p[-w - 1]);
      const float Lxyy = 0.5F * (p[w + 1] - 2.0F * p[1] + p[-w + 1] - p[w - 1] + 2.0F * p[-1] - p[-w - 1]);
      const float norm2 = Lx * Lx + Ly * Ly + 1e-12F;
      const float second = Lx * Lx * Lxx + 2.0F * Lx * Ly * Lxy + Ly * Ly * Lyy;
      const float third =
          Lx * Lx * Lx * Lxxx + 3.0F * Lx * Ly * (Lx * Lxxy + Ly * Lxyy) + Ly * Ly * Ly * Lyyy;
      differential_[at(x, y)] = {second / norm2, third / (norm2 * std::sqrt(norm2)), Lx, Ly};
    }
  }
}

void EdgeDetector::linkCell(int x, int y) {
  const std::array<int, 4> sides{crossing(x, y, false), crossing(x, y, true), crossing(x, y + 1, false),
                                 crossing(x + 1, y, true)};
  int first = kNone;
  for (const int side : sides) {
    if (side == kNone) continue;
    if (first == kNone)
      first = side;
    else
      join(first, side);
  }
}

int EdgeDetector::crossing(int x, int y, bool down) {
  int& known = crossings_[2 * at(x, y) + (down ? 1 : 0)];
  if (known != kUnknown) return known;
  known = kNone;
  const auto& a = differential_[at(x, y)];
  const auto& b = differential_[down ? at(x, y + 1) : at(x + 1, y)];
  if ((a.second < 0.0F) == (b.second < 0.0F)) return known;
  const float share = a.second / (a.second - b.second);
  const float third = std::lerp(a.third, b.third, share);
  const Eigen::Vector2f gradient(std::lerp(a.gx, b.gx, share), std::lerp(a.gy, b.gy, share));
  if (!(third < 0.0F) || gradient.squaredNorm() < thresholds_.weak * thresholds_.weak) return known;
  known = static_cast<int>(points_.size());
  const Eigen::Vector2f step = down ? Eigen::Vector2f(0.0F, share) : Eigen::Vector2f(share, 0.0F);
  const Eigen::Vector2f corner(static_cast<float>(region_.left + x), static_cast<float>(region_.top + y));
  points_.push_back({corner + step, gradient, -third, known});
  parents_.push_back(known);
  return known;
}

int EdgeDetector::root(int point) {
  while (parents_[static_cast<std::size_t>(point)] != point) {
    auto& parent = parents_[static_cast<std::size_t>(point)];
    parent = parents_[static_cast<std::size_t>(parent)];
    point = parent;
  }
  return point;
}

void EdgeDetector::join(int a, int b) { parents_[static_cast<std::size_t>(root(b))] = root(a); }

void EdgeDetector::keepStrong() {
  strong_.assign(points_.size(), 0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].contour = root(static_cast<int>(i));
    if (points_[i].gradient.norm() >= thresholds_.strong)
      strong_[static_cast<std::size_t>(points_[i].contour)] = 1;
  }
  std::erase_if(
      points_, [&](const EdgePoint& point) { return strong_[static_cast<std::size_t>(point.contour)] == 0; });
}

}  // namespace mirrorarm::vision
