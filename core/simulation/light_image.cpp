#include "core/simulation/light_image.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::simulation {
namespace {

constexpr int kRoughSteps = 32;
constexpr int kMostSteps = 8192;
constexpr double kStep_px = 0.75;

}  // namespace

LightImage::LightImage(const camera::CameraModel& camera, double spread_sigma_px)
    : camera_(camera),
      spread_(spread_sigma_px),
      width_(camera.intrinsics().width_px),
      height_(camera.intrinsics().height_px),
      light_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
      edge_(static_cast<std::size_t>(width_)) {}

bool LightImage::project(const Patch& patch_C, int count) {
  outline_.clear();
  for (int i = 0; i < count; ++i) {
    const auto point = outlineAt(patch_C, (i + 0.5) / count);
    camera::CameraModel::ProjectJacobian J;
    const auto pixel = camera_.project(point.p, J);
    if (!pixel) return false;
    outline_.push_back({pixel->x(), pixel->y(), J.row(1).dot(point.dp) / count});
  }
  return true;
}

bool LightImage::traceOutline(const Patch& patch_C) {
  if (!project(patch_C, kRoughSteps)) return false;
  double length_px = 0.0;
  const Step* before = &outline_.back();
  for (const Step& step : outline_) {
    length_px += std::hypot(step.x - before->x, step.y - before->y);
    before = &step;
  }
  // A multiple of four, so that a rectangle's corners lie between two steps.
  const double quarter =
      std::clamp(std::ceil(length_px / (4.0 * kStep_px)), kRoughSteps / 4.0, kMostSteps / 4.0);
  return project(patch_C, 4 * static_cast<int>(quarter));
}

PixelBox LightImage::boxOfOutline() const {
  const auto [left, right] =
      std::minmax_element(outline_.begin(), outline_.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [top, bottom] =
      std::minmax_element(outline_.begin(), outline_.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const auto first = [this](double v, int size) {
    return static_cast<int>(std::clamp(std::ceil(v - spread_.reach_px()), 0.0, static_cast<double>(size)));
  };
  const auto past = [this](double v, int size) {
    return static_cast<int>(
        std::clamp(std::floor(v + spread_.reach_px()) + 1.0, 0.0, static_cast<double>(size)));
  };
  return {first(left->x, width_), first(top->y, height_), past(right->x, width_), past(bottom->y, height_)};
}

void LightImage::add(const Patch& patch_C, double level) {
  if (level <= 0.0 || !traceOutline(patch_C)) return;
  const PixelBox box = boxOfOutline();
  if (box.empty()) return;
  double area_px2 = 0.0;  // its sign tells which way round the outline runs in the image
  for (const Step& step : outline_) area_px2 += step.x * step.dy;
  const double inwards = area_px2 > 0.0 ? -level : level;
  for (const Step& step : outline_) addStep(step, box, static_cast<float>(inwards));
  lit_.push_back(box);
}

void LightImage::addStep(const Step& step, const PixelBox& box, float level) {
  const double reach = spread_.reach_px();
  const int left = std::max(box.left, static_cast<int>(std::ceil(std::max(step.x - reach, -1.0))));
  const int top = std::max(box.top, static_cast<int>(std::ceil(std::max(step.y - reach, -1.0))));
  const int bottom = std::min(box.bottom, static_cast<int>(std::floor(std::min(step.y + reach, 1e6))) + 1);
  if (top >= bottom) return;
  const int past =
      std::clamp(static_cast<int>(std::min(step.x + reach, 1e6)) + 1, left, std::max(left, box.right));
  for (int x = left; x < past; ++x) edge_[static_cast<std::size_t>(x)] = spread_.edge(x - step.x);
  std::fill(edge_.begin() + past, edge_.begin() + std::max(past, box.right), 1.0F);
  for (int y = top; y < bottom; ++y) {
    const float weight = level * static_cast<float>(step.dy) * spread_.line(y - step.y);
    float* const row = light_.data() + static_cast<std::ptrdiff_t>(y) * width_;
    for (int x = left; x < box.right; ++x) row[x] += weight * edge_[static_cast<std::size_t>(x)];
  }
}

void LightImage::clear() {
  for (const PixelBox& box : lit_)
    for (int y = box.top; y < box.bottom; ++y) {
      float* const row = light_.data() + static_cast<std::ptrdiff_t>(y) * width_;
      std::fill(row + box.left, row + box.right, 0.0F);
    }
  lit_.clear();
}

}  // namespace mirrorarm::simulation
