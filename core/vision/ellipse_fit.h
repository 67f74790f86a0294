#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::vision {

/// An ellipse as the image of the unit circle: centre + axes * u with |u| = 1.
struct EllipseMap {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();
};

/// Direct least squares: the ellipse with the least algebraic distance under 4ac - b^2 = 1, the one positive
/// eigenvalue of a generalized eigenproblem, in its partitioned form on centred and scaled points, which
/// stays stable when the points lie on an exact ellipse. Nothing for fewer than six points or points on a
/// line. Source: paper equations 1 to 9; Fitzgibbon, Pilu, Fisher, PAMI 21(5), 1999; Halir and Flusser, WSCG
/// 1998.
[[nodiscard]] std::optional<EllipseMap> fitDirect(std::span<const Eigen::Vector2d> points);

/// What refining found out about the fit.
struct EllipseFit {
  EllipseMap ellipse;
  double rms = 0.0;  ///< distance of the supporting points from the outline
  Eigen::Matrix2d cofactor =
      Eigen::Matrix2d::Zero();  ///< centre covariance for unit noise of independent points
};

/// Refines a fit to least distance from the outline, by Gauss-Newton steps over the points that support it;
/// `supports` gets one flag a point. Points farther than three robust standard deviations (and `least_gate`)
/// do not support. Keeps its buffers.
class EllipseRefiner {
 public:
  [[nodiscard]] std::optional<EllipseFit> refine(const EllipseMap& start,
                                                 std::span<const Eigen::Vector2d> points, double least_gate,
                                                 std::vector<char>& supports);

 private:
  void chooseSupport(const EllipseMap& ellipse, const Eigen::Matrix2d& inverse_axes,
                     std::span<const Eigen::Vector2d> points, double least_gate, std::vector<char>& supports);

  std::vector<double> distances_;
  std::vector<double> sorted_;
};

}  // namespace mirrorarm::vision
