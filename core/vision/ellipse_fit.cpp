#include "core/vision/ellipse_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace mirrorarm::vision {
namespace {

constexpr int kRounds = 3;
constexpr double kGateSigmas = 3.0;
constexpr double kMadToSigma = 1.4826;

struct Scatter {
  Eigen::Matrix3d quadratic = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d linear = Eigen::Matrix3d::Zero();
};

Scatter scatterOf(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& centre, double scale) {
  Scatter scatter;
  for (const auto& point : points) {
    const Eigen::Vector2d p = (point - centre) / scale;
    const Eigen::Vector3d second(p.x() * p.x(), p.x() * p.y(), p.y() * p.y());
    const Eigen::Vector3d first(p.x(), p.y(), 1.0);
    scatter.quadratic += second * second.transpose();
    scatter.mixed += second * first.transpose();
    scatter.linear += first * first.transpose();
  }
  return scatter;
}

/// Conic a b c d e f of a x^2 + b xy + c y^2 + d x + e y + f = 0 that is an ellipse, from the reduced
/// eigenproblem.
std::optional<Eigen::Matrix<double, 6, 1>> ellipticConic(const Scatter& scatter) {
  const auto solver = scatter.linear.fullPivLu();
  if (!solver.isInvertible()) return std::nullopt;
  const Eigen::Matrix3d linear_of_quadratic = -solver.solve(scatter.mixed.transpose());
  const Eigen::Matrix3d reduced = scatter.quadratic + scatter.mixed * linear_of_quadratic;
  Eigen::Matrix3d system;
  system << 0.5 * reduced.row(2), -reduced.row(1), 0.5 * reduced.row(0);
  if (!system.allFinite()) return std::nullopt;
  const Eigen::EigenSolver<Eigen::Matrix3d> eigen(system);
  if (eigen.info() != Eigen::Success) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d quadratic = eigen.eigenvectors().col(i).real();
    if (4.0 * quadratic(0) * quadratic(2) - quadratic(1) * quadratic(1) <= 0.0) continue;
    Eigen::Matrix<double, 6, 1> conic;
    conic << quadratic, linear_of_quadratic * quadratic;
    return conic;
  }
  return std::nullopt;
}

std::optional<EllipseMap> toMap(const Eigen::Matrix<double, 6, 1>& conic) {
  Eigen::Matrix2d form;
  form << conic(0), 0.5 * conic(1), 0.5 * conic(1), conic(2);
  const Eigen::Vector2d half_linear = 0.5 * conic.segment<2>(3);
  const Eigen::Vector2d centre = -form.inverse() * half_linear;
  const double level = -(conic(5) + half_linear.dot(centre));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(form / level);
  if (!centre.allFinite() || !eigen.eigenvalues().allFinite() || eigen.eigenvalues()(0) <= 0.0)
    return std::nullopt;
  return EllipseMap{centre, eigen.operatorInverseSqrt()};
}

/// A point as the ellipse sees it: signed distance from the outline (to first order) and the outward normal.
struct Offset {
  double distance;
  Eigen::Vector2d normal;
};

Offset offsetFrom(const EllipseMap& ellipse, const Eigen::Matrix2d& inverse_axes,
                  const Eigen::Vector2d& point) {
  const Eigen::Vector2d u = inverse_axes * (point - ellipse.centre);
  const Eigen::Vector2d gradient = 2.0 * inverse_axes.transpose() * u;
  const double steepness = gradient.norm();
  if (steepness < 1e-12) return {-1e12, Eigen::Vector2d::UnitX()};
  return {(u.squaredNorm() - 1.0) / steepness, gradient / steepness};
}

/// How the outline moves along its normal at a point: centre x, y, and the three ways to stretch the plane.
Eigen::Matrix<double, 5, 1> motions(const Offset& offset, const Eigen::Vector2d& arm) {
  const auto& n = offset.normal;
  Eigen::Matrix<double, 5, 1> row;
  row << n.x(), n.y(), n.x() * arm.x(), n.y() * arm.y(), n.x() * arm.y() + n.y() * arm.x();
  return row;
}

/// Normal equations of the motions that bring the outline onto the supporting points.
struct NormalEquations {
  Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> vector = Eigen::Matrix<double, 5, 1>::Zero();
  double squares = 0.0;
  int count = 0;
};

NormalEquations gather(const EllipseMap& ellipse, const Eigen::Matrix2d& inverse_axes,
                       std::span<const Eigen::Vector2d> points, const std::vector<char>& supports) {
  NormalEquations equations;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (supports[i] == 0) continue;
    const auto offset = offsetFrom(ellipse, inverse_axes, points[i]);
    const auto row = motions(offset, points[i] - ellipse.centre);
    equations.matrix += row * row.transpose();
    equations.vector += row * offset.distance;
    equations.squares += offset.distance * offset.distance;
    ++equations.count;
  }
  return equations;
}

void move(EllipseMap& ellipse, const Eigen::Matrix<double, 5, 1>& change) {
  Eigen::Matrix2d stretch;
  stretch << change(2), change(4), change(4), change(3);
  ellipse.centre += change.head<2>();
  ellipse.axes += stretch * ellipse.axes;
}

}  // namespace

std::optional<EllipseMap> fitDirect(std::span<const Eigen::Vector2d> points) {
  if (points.size() < 6) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  double spread = 0.0;
  for (const auto& point : points) spread += (point - mean).squaredNorm();
  const double scale = std::sqrt(spread / static_cast<double>(points.size()));
  if (!(scale > 0.0) || !std::isfinite(scale)) return std::nullopt;
  const auto conic = ellipticConic(scatterOf(points, mean, scale));
  if (!conic) return std::nullopt;
  auto ellipse = toMap(*conic);
  if (!ellipse) return std::nullopt;
  ellipse->centre = mean + scale * ellipse->centre;
  ellipse->axes *= scale;
  return ellipse;
}

std::optional<EllipseFit> EllipseRefiner::refine(const EllipseMap& start,
                                                 std::span<const Eigen::Vector2d> points, double least_gate,
                                                 std::vector<char>& supports) {
  EllipseFit fit{start, 0.0, Eigen::Matrix2d::Zero()};
  for (int round = 0; round <= kRounds; ++round) {
    const Eigen::Matrix2d inverse_axes = fit.ellipse.axes.inverse();
    if (!inverse_axes.allFinite()) return std::nullopt;
    chooseSupport(fit.ellipse, inverse_axes, points, least_gate, supports);
    const auto equations = gather(fit.ellipse, inverse_axes, points, supports);
    const auto solver = equations.matrix.ldlt();
    if (equations.count < 6 || solver.info() != Eigen::Success) return std::nullopt;
    fit.rms = std::sqrt(equations.squares / equations.count);
    fit.cofactor = solver.solve(Eigen::Matrix<double, 5, 5>::Identity()).topLeftCorner<2, 2>();
    if (round < kRounds) move(fit.ellipse, solver.solve(equations.vector));
  }
  const bool finite =
      fit.ellipse.centre.allFinite() && fit.ellipse.axes.allFinite() && fit.cofactor.allFinite();
  return finite ? std::optional(fit) : std::nullopt;
}

void EllipseRefiner::chooseSupport(const EllipseMap& ellipse, const Eigen::Matrix2d& inverse_axes,
                                   std::span<const Eigen::Vector2d> points, double least_gate,
                                   std::vector<char>& supports) {
  supports.assign(points.size(), 0);
  distances_.resize(points.size());
  if (points.empty()) return;
  for (std::size_t i = 0; i < points.size(); ++i)
    distances_[i] = std::abs(offsetFrom(ellipse, inverse_axes, points[i]).distance);
  sorted_ = distances_;
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  const double gate = std::max(kGateSigmas * kMadToSigma * *middle, least_gate);
  for (std::size_t i = 0; i < points.size(); ++i) supports[i] = distances_[i] <= gate ? 1 : 0;
}

}  // namespace mirrorarm::vision
