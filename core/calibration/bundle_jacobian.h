#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/calibration/bundle.h"

namespace mirrorarm::calibration {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// A bundle's numbers are shared (intrinsics of each camera, then turn and shift of X_RC) or belong to one
/// view (turn and shift of X_CM). Turns are rotation vectors applied from the left.

/// Normal equations of one view.
struct ViewEquations {
  Matrix6 own = Matrix6::Zero();
  Vector6 own_gradient = Vector6::Zero();
  Eigen::Matrix<double, Eigen::Dynamic, 6> mixed;  ///< shared times own
};

/// Normal equations at one point: J^T J and J^T r with residual r = projected minus seen [px].
struct Linearised {
  Eigen::MatrixXd shared;
  Eigen::VectorXd shared_gradient;
  std::vector<ViewEquations> views;
};

/// A change of all numbers.
struct BundleStep {
  Eigen::VectorXd shared;
  std::vector<Vector6> views;
};

/// Nothing when a point cannot be projected.
[[nodiscard]] std::optional<Linearised> linearise(const Bundle& bundle,
                                                  std::span<const Eigen::Vector3d> board,
                                                  std::span<const BoardView> views);

/// Sum of squared distances [px^2]; nothing when a point cannot be projected.
[[nodiscard]] std::optional<double> sumOfSquares(const Bundle& bundle, std::span<const Eigen::Vector3d> board,
                                                 std::span<const BoardView> views);

[[nodiscard]] Bundle moved(const Bundle& bundle, const BundleStep& step);

/// Where camera `k`'s numbers (fx fy cx cy k1 ..) begin among the shared ones.
[[nodiscard]] Eigen::Index firstIntrinsic(const Bundle& bundle, std::size_t k);

}  // namespace mirrorarm::calibration
