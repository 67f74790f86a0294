#include "core/calibration/grid_pixels.h"

#include <array>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace mirrorarm::calibration {
namespace {

constexpr int kNarrowReach = 2;
constexpr std::size_t kMost = (2 * GridPixels::kReach + 1) * (2 * GridPixels::kReach + 1) - 1;
constexpr std::size_t kEnough = 8;  // else all within reach
constexpr std::size_t kFewest = 5;
constexpr double kLeastSpread = 0.1;  // of the places across the line that they lie on best, steps^2
/// Where few places tell how steps change, they are held: usual changes by perspective and by the lens, from
/// one step to the next, and how far places stray, all in steps.
constexpr double kUsualChange = 0.1;
constexpr double kUsualBend = 0.02;
constexpr double kUsualStraying = 0.002;

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

/// What a neighbour says about the coefficients of one pixel coordinate.
Eigen::Matrix<double, 6, 1> termsOf(const Eigen::Vector2d& step) {
  const double x = step.x(), y = step.y();
  Eigen::Matrix<double, 6, 1> terms;
  terms << 1.0, x, y, x * x, x * y, y * y;
  return terms;
}

/// pixel = (quadratic in the step) / (1 + g step) about `middle`, least squares of its linear form: a
/// homography and what the lens bends.
LocalMap mapThrough(std::span<const Neighbour> neighbours, const Eigen::Vector2d& middle) {
  using Unknowns = Eigen::Matrix<double, 14, 1>;
  Eigen::Matrix<double, 14, 14> N = Eigen::Matrix<double, 14, 14>::Zero();
  Unknowns right = Unknowns::Zero();
  double squares = 0.0, steps = 0.0;
  for (const auto& one : neighbours) {
    const Eigen::Vector2d u = one.pixel - middle;
    squares += u.squaredNorm();
    steps += one.step.squaredNorm();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      Unknowns row = Unknowns::Zero();
      row.segment<6>(6 * axis) = termsOf(one.step);
      row.tail<2>() = -u[axis] * one.step;
      N += row * row.transpose();
      right += u[axis] * row;
    }
  }
  const double held_px2 = squares / steps * kUsualStraying * kUsualStraying;
  for (const Eigen::Index first : {3, 9})
    N.diagonal().segment<3>(first).array() += held_px2 / (squares / steps * kUsualBend * kUsualBend);
  N.diagonal().tail<2>().array() += held_px2 / (kUsualChange * kUsualChange);
  const Unknowns h = N.ldlt().solve(right);
  LocalMap map;
  map.pixel = Eigen::Vector2d(h[0], h[6]);
  map.steps_px.row(0) = h.segment<2>(1) - h[0] * h.tail<2>();
  map.steps_px.row(1) = h.segment<2>(7) - h[6] * h.tail<2>();
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
  for (const int reach : {kNarrowReach, kReach}) {
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
  return mapThrough(neighbours.all(), middle);
}

}  // namespace mirrorarm::calibration
