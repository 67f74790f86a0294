#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace mirrorarm::camera {

enum class LensModel {
  kBrownConrady,   ///< pinhole with radial k1 k2 [p1 p2 [k3]]; Brown 1971, the paper's with two radial terms
  kKannalaBrandt,  ///< fisheye, angle polynomial k1..k4; Kannala and Brandt, PAMI 28(8), 2006
};

/// "brown_conrady" or "kannala_brandt", as the files write it.
[[nodiscard]] std::string_view name(LensModel model);
/// The model of that name, or nothing.
[[nodiscard]] std::optional<LensModel> lensModelOf(std::string_view name);

/// Calibrated numbers of one camera. Pixel centres lie at integers.
struct Intrinsics {
  LensModel model = LensModel::kBrownConrady;
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
  /// brown_conrady: k1 k2 p1 p2 k3; kannala_brandt: k1 k2 k3 k4 0. Unused terms are 0.
  std::array<double, 5> distortion{};
};

/// Projects points of camera frame C (x right, y down, z forward) into raw pixels and back. A value; any
/// thread.
class CameraModel {
 public:
  using ProjectJacobian = Eigen::Matrix<double, 2, 3>;
  using UnprojectJacobian = Eigen::Matrix2d;

  CameraModel() = default;
  explicit CameraModel(const Intrinsics& intrinsics);

  [[nodiscard]] const Intrinsics& intrinsics() const { return intrinsics_; }

  /// Pixel of a point, also outside the image. Nothing where the lens model does not hold: behind the camera
  /// (brown_conrady), or so far out that the radial curve has turned back.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;
  /// The same with d(pixel)/d(p_C) [px/m].
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C, ProjectJacobian& J) const;

  /// Point (x, y) of the plane z = 1 that projects to the pixel: the undistorted point. Nothing outside the
  /// lens model's range, or at 90 degrees and more from the axis. Exact to 1e-10.
  [[nodiscard]] std::optional<Eigen::Vector2d> unproject(const Eigen::Vector2d& pixel) const;
  /// The same with d(x, y)/d(pixel) [1/px].
  [[nodiscard]] std::optional<Eigen::Vector2d> unproject(const Eigen::Vector2d& pixel,
                                                         UnprojectJacobian& J) const;

  /// True when a pixel lies inside the image, `margin_px` away from its border.
  [[nodiscard]] bool sees(const Eigen::Vector2d& pixel, double margin_px = 0.0) const;

 private:
  Intrinsics intrinsics_;
  double max_radius_ =
      0.0;  ///< largest undistorted radius (brown_conrady) or angle (kannala_brandt) that is valid
};

}  // namespace mirrorarm::camera
