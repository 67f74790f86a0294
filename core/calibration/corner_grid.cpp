#include "core/calibration/corner_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirrorarm::calibration {
namespace {

constexpr double kLook = 0.25;  // of a square, from a corner along its sides: outer squares may be narrower
constexpr double kLeastContrast = 0.5;  // of the board's usual one
constexpr double kLeastContrast_grey = 8.0;
constexpr double kLeastShare = 0.95;       // of a board's corners that must look like corners
constexpr double kLeastShareBeyond = 0.7;  // of the next column's or row's that the image shows
constexpr int kFewestBeyond = 3;

double signOf(const Place& place) { return (place.x() + place.y()) % 2 == 0 ? 1.0 : -1.0; }

}  // namespace

CornerGrid::CornerGrid(const camera::ImageView& image, std::span<const Eigen::Vector2d> pixels, int columns)
    : image_(image), columns_(columns), rows_(static_cast<int>(pixels.size()) / columns) {
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      pixels_.set({column, row}, pixels[static_cast<std::size_t>(row * columns_ + column)]);
  std::vector<double> contrasts;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
      if (const auto contrast = contrastAt({column, row}))
        contrasts.push_back(signOf({column, row}) * *contrast);
  if (contrasts.empty()) return;
  const auto middle = contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() / 2);
  std::nth_element(contrasts.begin(), middle, contrasts.end());
  contrast_ = *middle;
}

bool CornerGrid::isChessboard() const {
  if (std::abs(contrast_) < kLeastContrast_grey) return false;
  int corners = 0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) corners += isCorner({column, row}) ? 1 : 0;
  return corners >= kLeastShare * columns_ * rows_;
}

bool CornerGrid::goesOn() const {
  return hasCorners({0, -1}, {1, 0}, columns_) || hasCorners({0, rows_}, {1, 0}, columns_) ||
         hasCorners({-1, 0}, {0, 1}, rows_) || hasCorners({columns_, 0}, {0, 1}, rows_);
}

bool CornerGrid::hasCorners(const Place& first, const Place& step, int count) const {
  int shown = 0, corners = 0;
  for (int i = 0; i < count; ++i) {
    const Place place = first + i * step;
    if (!contrastAt(place)) continue;
    ++shown;
    corners += isCorner(place) ? 1 : 0;
  }
  return corners >= kFewestBeyond && corners >= kLeastShareBeyond * shown;
}

bool CornerGrid::isCorner(const Place& place) const {
  const auto contrast = contrastAt(place);
  return contrast && *contrast * signOf(place) * contrast_ > kLeastContrast * contrast_ * contrast_;
}

std::optional<double> CornerGrid::contrastAt(const Place& place) const {
  const auto map = pixels_.around(place);
  if (!map) return std::nullopt;
  const Eigen::Vector2d middle = pixels_.at(place).value_or(map->pixel);
  std::array<double, 4> grey{};
  for (std::size_t i = 0; i < grey.size(); ++i) {
    const Eigen::Vector2d towards(i % 2 == 0 ? -kLook : kLook, i / 2 == 0 ? -kLook : kLook);
    const auto found = greyAt(middle + map->steps_px * towards);
    if (!found) return std::nullopt;
    grey[i] = *found;
  }
  const auto [low, high] = std::minmax(grey[0], grey[3]);
  const auto [other_low, other_high] = std::minmax(grey[1], grey[2]);
  // The squares that are most alike of both colours: the white rim of a board has no second dark one.
  return low > other_high ? low - other_high : std::min(high - other_low, 0.0);
}

std::optional<double> CornerGrid::greyAt(const Eigen::Vector2d& pixel) const {
  const auto x = static_cast<int>(std::lround(pixel.x())), y = static_cast<int>(std::lround(pixel.y()));
  if (!pixel.allFinite() || x < 1 || y < 1 || x >= image_.width_px - 1 || y >= image_.height_px - 1)
    return std::nullopt;
  int sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) sum += image_.at(x + dx, y + dy);
  return sum / 9.0;
}

}  // namespace mirrorarm::calibration
