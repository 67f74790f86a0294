#pragma once

#include <optional>

#include <Eigen/Dense>

namespace mirrorarm::calibration {

/// Sum of w |S x - d|^2 over equations of three rows, solved for three unknowns x.
class LeastSquares3 {
 public:
  void add(const Eigen::Matrix3d& S, const Eigen::Vector3d& d, double weight) {
    normal_ += weight * S.transpose() * S;
    right_ += weight * S.transpose() * d;
  }
  /// Nothing when the equations do not fix x.
  [[nodiscard]] std::optional<Eigen::Vector3d> solve() const {
    constexpr double kSmallestPivotShare = 1e-9;
    const Eigen::LDLT<Eigen::Matrix3d> ldlt(normal_);
    const auto pivots = ldlt.vectorD();
    if (!(pivots.minCoeff() > kSmallestPivotShare * pivots.maxCoeff())) return std::nullopt;
    return ldlt.solve(right_);
  }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

}  // namespace mirrorarm::calibration
