#include "core/calibration/grid_pixels.h"

#include <array>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace mirrorarm::calibration {
namespace {

constexpr int kReach = 2, kWideReach = 3;  // columns and rows to either side
constexpr std::size_t kMost = (2 * kWideReach + 1) * (2 * kWideReach + 1) - 1;
constexpr std::size_t kEnough = 8;  // else the wide reach
constexpr std::size_t kFewest = 5;
constexpr double kLeastSpread = 0.1;  // of the places across the line that they lie on best, steps^2
/// Where few places tell the perspective, it is held: steps change by that share of them from one to the
/// next,
constexpr double kUsualChange = 0.2;
constexpr double kUsualStraying = 0.01;  // and places stray by that.

struct Neighbour {
  Eigen::Vector2d step;
  Eigen::Vector2d pixel;
};

/// The neighbours of one place.
class Neighbours {
 public:
  void add(const Place& step, const Eigen::Vector2d& pixel) {
    places_[count_++] = {step.cast<double>(), pixel};
  }
  void clear() { count_ = 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::span<const Neighbour> all() const { return {places_.data(), count_}; }

 private:
  std::array<Neighbour, kMost> places_;
  std::size_t count_ = 0;
};

double weightOf(const Neighbour& neighbour) { return 1.0 / (1.0 + neighbour.step.squaredNorm()); }

bool onOneLine(std::span<const Neighbour> neighbours) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const auto& one : neighbours) {
    mean += one.step;
    squares += one.step * one.step.transpose();
  }
  const auto count = static_cast<double>(neighbours.size());
  const Eigen::Matrix2d spread = squares / count - mean * mean.transpose() / (count * count);
  const double half = 0.5 * spread.trace();
  return half - std::sqrt(std::max(half * half - spread.determinant(), 0.0)) < kLeastSpread;
}

/// The homography of steps to pixels about `middle`, least squares of its linear form: rows a1, a2 and the
/// change of scale g in pixel = (a1 x, a2 x) / (1 + g x).
LocalMap homographyThrough(std::span<const Neighbour> neighbours, const Eigen::Vector2d& middle) {
  using Unknowns = Eigen::Matrix<double, 8, 1>;
  Eigen::Matrix<double, 8, 8> N = Eigen::Matrix<double, 8, 8>::Zero();
  Unknowns right = Unknowns::Zero();
  double squares = 0.0, steps = 0.0;
  for (const auto& one : neighbours) {
    const Eigen::Vector2d u = one.pixel - middle;
    const double weight = weightOf(one);
    squares += u.squaredNorm();
    steps += one.step.squaredNorm();
    Unknowns along, down;
    along << one.step, 1.0, 0.0, 0.0, 0.0, -u.x() * one.step;
    down << 0.0, 0.0, 0.0, one.step, 1.0, -u.y() * one.step;
    N += weight * (along * along.transpose() + down * down.transpose());
    right += weight * (u.x() * along + u.y() * down);
  }
  const double step_px2 = squares / steps;
  N.diagonal().tail<2>().array() += step_px2 * std::pow(kUsualStraying / kUsualChange, 2);
  const Unknowns h = N.ldlt().solve(right);
  LocalMap map;
  map.pixel = Eigen::Vector2d(h[2], h[5]);
  map.steps_px.row(0) = h.segment<2>(0) - h[2] * h.tail<2>();
  map.steps_px.row(1) = h.segment<2>(3) - h[5] * h.tail<2>();
  map.pixel += middle;
  return map;
}

}  // namespace

std::optional<Eigen::Vector2d> GridPixels::at(const Place& place) const {
  const auto found = pixels_.find(key(place));
  return found == pixels_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<LocalMap> GridPixels::around(const Place& place) const {
  Neighbours neighbours;
  for (const int reach : {kReach, kWideReach}) {
    neighbours.clear();
    for (int row = -reach; row <= reach; ++row)
      for (int column = -reach; column <= reach; ++column) {
        const Place step(column, row);
        const auto pixel = at(place + step);
        if (pixel && step != Place::Zero()) neighbours.add(step, *pixel);
      }
    if (neighbours.size() >= kEnough) break;
  }
  if (neighbours.size() < kFewest || onOneLine(neighbours.all())) return std::nullopt;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& one : neighbours.all()) middle += one.pixel / static_cast<double>(neighbours.size());
  return homographyThrough(neighbours.all(), middle);
}

}  // namespace mirrorarm::calibration
