#include "core/tracking/triple_search.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::tracking {
namespace {

using Eigen::Vector3d;
using Points = std::span<const Vector3d>;

// A triangle flatter than this share of its longest side says too little about the turn about that side.
constexpr double kMinHeightShare = 0.1;
// Two poses nearer than this are the same guess.
constexpr double kSameTurn_rad = 0.15;
constexpr double kSameShift_m = 0.015;

double heightOver(double base, double a, double b) {
  const double along = (base * base + a * a - b * b) / (2.0 * base);
  return std::sqrt(std::max(0.0, a * a - along * along));
}

/// Origin at the centroid, x along the first side, z normal to the triangle: cheaper than a least-squares
/// pose, and good enough for a guess.
RigidTransform triangleFrame(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Eigen::Matrix3d axes;
  axes.col(0) = (b - a).normalized();
  axes.col(2) = (b - a).cross(c - a).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return makeTransform(axes, (a + b + c) / 3.0);
}

}  // namespace

std::span<const TripleSearch::Pose> TripleSearch::run(Points x, Points y,
                                                      const TripleSearchSettings& settings) {
  x_ = x;
  y_ = y;
  settings_ = settings;
  best_.clear();
  comparisons_ = 0;
  listSides(x, x_sides_, x_length_);
  listSides(y, y_sides_, y_length_);
  const auto shorter = [](const Side& side, double length_m) { return side.length_m < length_m; };
  // Long sides first: they fix the pose best.
  for (auto x_side = x_sides_.rbegin(); x_side != x_sides_.rend() && !isDone(); ++x_side) {
    auto y_side =
        std::lower_bound(y_sides_.begin(), y_sides_.end(), x_side->length_m - settings_.tolerance_m, shorter);
    for (; y_side != y_sides_.end() && y_side->length_m <= x_side->length_m + settings_.tolerance_m &&
           !isDone();
         ++y_side) {
      tryLongestSide(*x_side, *y_side);
      tryLongestSide(*x_side, {y_side->length_m, y_side->to, y_side->from});
    }
  }
  cut_off_ = comparisons_ >= settings_.max_comparisons;
  return best_;
}

void TripleSearch::listSides(Points points, std::vector<Side>& sides, Eigen::MatrixXd& lengths) const {
  const auto count = static_cast<int>(points.size());
  sides.clear();
  lengths.setZero(count, count);
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j) {
      const double length =
          (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(j)]).norm();
      lengths(i, j) = lengths(j, i) = length;
      sides.push_back({length, i, j});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.length_m < b.length_m; });
}

/// Completes a pair of sides by every third marker and point. Only triples whose longest side is the given
/// one: so each is met once.
void TripleSearch::tryLongestSide(const Side& x_side, const Side& y_side) {
  const auto points = static_cast<int>(y_.size());
  for (int j3 = 0; j3 < static_cast<int>(x_.size()) && !isDone(); ++j3) {
    if (!isLongestOfFlat(x_side, j3)) continue;
    const double first = x_length_(x_side.from, j3), second = x_length_(x_side.to, j3);
    comparisons_ += points;
    for (int k3 = 0; k3 < points; ++k3) {
      if (std::abs(y_length_(k3, y_side.from) - first) > settings_.tolerance_m ||
          std::abs(y_length_(k3, y_side.to) - second) > settings_.tolerance_m || k3 == y_side.from ||
          k3 == y_side.to)
        continue;
      tryTriple(x_side.from, x_side.to, j3, y_side.from, y_side.to, k3);
    }
  }
}

bool TripleSearch::isLongestOfFlat(const Side& x_side, int third) const {
  if (third == x_side.from || third == x_side.to) return false;
  const double first = x_length_(x_side.from, third), second = x_length_(x_side.to, third);
  return first <= x_side.length_m && second <= x_side.length_m &&
         heightOver(x_side.length_m, first, second) > kMinHeightShare * x_side.length_m;
}

void TripleSearch::tryTriple(int j1, int j2, int j3, int k1, int k2, int k3) {
  const auto at = [](Points points, int i) { return points[static_cast<std::size_t>(i)]; };
  comparisons_ += static_cast<long long>(x_.size() * y_.size());
  Pose pose{triangleFrame(at(y_, k1), at(y_, k2), at(y_, k3)) *
                triangleFrame(at(x_, j1), at(x_, j2), at(x_, j3)).inverse(),
            0};
  const bool full = static_cast<int>(best_.size()) == settings_.max_poses;
  pose.found = countFound(pose.X_YX, full ? best_.back().found : 2);
  if (pose.found > 0) keep(pose);
}

/// Markers with a point in the gate, or 0 as soon as they cannot be more than `to_beat`.
int TripleSearch::countFound(const RigidTransform& X_YX, int to_beat) const {
  int found = 0;
  auto left = static_cast<int>(x_.size());
  for (const auto& marker : x_) {
    const Vector3d moved = X_YX * marker;
    const bool here = std::any_of(y_.begin(), y_.end(), [&](const Vector3d& point) {
      return (point - moved).squaredNorm() < settings_.gate_m * settings_.gate_m;
    });
    found += here ? 1 : 0;
    if (found + --left <= to_beat) return 0;
  }
  return found;
}

void TripleSearch::keep(const Pose& pose) {
  const auto same = std::find_if(best_.begin(), best_.end(), [&](const Pose& kept) {
    return (kept.X_YX.translation() - pose.X_YX.translation()).norm() < kSameShift_m &&
           angleBetween(kept.X_YX, pose.X_YX) < kSameTurn_rad;
  });
  if (same == best_.end()) {
    best_.push_back(pose);
  } else if (pose.found > same->found) {
    *same = pose;
  }
  std::stable_sort(best_.begin(), best_.end(),
                   [](const Pose& a, const Pose& b) { return a.found > b.found; });
  if (static_cast<int>(best_.size()) > settings_.max_poses) best_.pop_back();
}

bool TripleSearch::isDone() const {
  return comparisons_ >= settings_.max_comparisons ||
         (!best_.empty() && best_.front().found == static_cast<int>(x_.size()));
}

}  // namespace mirrorarm::tracking
