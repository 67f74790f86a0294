#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/camera/camera_model.h"

namespace mirrorarm::calibration {

/// The numbers of a lens that a calibration solves for, in this order: fx fy cx cy k1 k2 (brown_conrady, as
/// the paper's model) or fx fy cx cy k1 k2 k3 k4 (kannala_brandt).
inline constexpr int kPinholeTerms = 4;
inline constexpr int kMostLensTerms = 8;
using LensNumbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostLensTerms, 1>;
using LensJacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMostLensTerms>;

[[nodiscard]] int lensTerms(camera::LensModel model);
[[nodiscard]] LensNumbers lensNumbers(const camera::Intrinsics& lens);
/// `lens` with these numbers in place of its own.
[[nodiscard]] camera::Intrinsics withNumbers(camera::Intrinsics lens, const LensNumbers& numbers);

/// A lens that projects with derivatives by the point and by its numbers.
class SolvedLens {
 public:
  explicit SolvedLens(const camera::Intrinsics& lens);

  [[nodiscard]] const camera::CameraModel& camera() const { return camera_; }
  /// Nothing where the lens model does not hold; d(pixel)/d(p_K) [px/m] and d(pixel)/d(numbers).
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_K,
                                                       camera::CameraModel::ProjectJacobian& by_point,
                                                       LensJacobian& by_numbers) const;

 private:
  camera::CameraModel camera_;
  std::vector<camera::CameraModel> beside_;  ///< one for each distortion term, that a step larger
};

}  // namespace mirrorarm::calibration
