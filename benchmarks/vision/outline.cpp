#include "benchmarks/vision/outline.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace mirrorarm::benchmarks::vision {
namespace {

constexpr double kPiece_px = 1.0;
constexpr std::array<double, 4> kNodes{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                       0.8611363115940526};
constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                         0.3478548451374538};

/// Calls `add(t, weight)` for the nodes of [from, to], a curve of `length_px`.
template <class Add>
void integrate(double from, double to, double length_px, Add add) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(length_px / kPiece_px)));
  const double half = 0.5 * (to - from) / pieces;
  for (int piece = 0; piece < pieces; ++piece)
    for (std::size_t node = 0; node < kNodes.size(); ++node)
      add(from + half * (2 * piece + 1 + kNodes[node]), half * kWeights[node]);
}

void addArc(const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes, double from, double to,
            Outline& outline) {
  integrate(from, to, axes.norm() * (to - from), [&](double t, double weight) {
    const Eigen::Vector2d p = centre + axes * Eigen::Vector2d(std::cos(t), std::sin(t));
    const double slope = axes.row(1).dot(Eigen::Vector2d(-std::sin(t), std::cos(t)));
    outline.push_back({p.x(), p.y(), weight * slope});
  });
}

void addLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Outline& outline) {
  const Eigen::Vector2d way = to - from;
  integrate(0.0, 1.0, way.norm(), [&](double t, double weight) {
    const Eigen::Vector2d p = from + t * way;
    outline.push_back({p.x(), p.y(), weight * way.y()});
  });
}

/// Share of the unit disc beyond `limit`.
double shareBeyond(double limit) {
  return (std::acos(limit) - limit * std::sqrt(1.0 - limit * limit)) / std::numbers::pi;
}

}  // namespace

Cut cutOfArea(double share, double direction_rad) {
  double low = -1.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shareBeyond(middle) > share ? low : high) = middle;
  }
  return {direction_rad, 0.5 * (low + high)};
}

Outline ellipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes) {
  Outline outline;
  addArc(centre, axes, 0.0, 2.0 * std::numbers::pi, outline);
  return outline;
}

Outline cutEllipseOutline(const Eigen::Vector2d& centre, const Eigen::Matrix2d& axes, const Cut& cut) {
  const double half = std::acos(cut.limit);
  const double from = cut.direction_rad + half;
  const double to = cut.direction_rad + 2.0 * std::numbers::pi - half;
  const auto at = [&](double t) -> Eigen::Vector2d {
    return centre + axes * Eigen::Vector2d(std::cos(t), std::sin(t));
  };
  Outline outline;
  addArc(centre, axes, from, to, outline);
  addLine(at(to), at(from), outline);
  return outline;
}

Outline polygonOutline(std::span<const Eigen::Vector2d> corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i)
    addLine(corners[i], corners[(i + 1) % corners.size()], outline);
  return outline;
}

}  // namespace mirrorarm::benchmarks::vision
