#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace mirrorarm::vision {

/// How a disc's centre is measured.
enum class CentreMethod : std::uint8_t {
  kMaximumLikelihood,   ///< a blurred ellipse on its ground, with a ramp, fitted to the pixels
  kDualConic,           ///< one linear solution from the gradients: Ouellet and Hebert, MVA 21(1), 2009
  kLindebergFitzgibbon  ///< the paper's: differential edges, direct ellipse fit of undistorted points
};
/// "maximum_likelihood", "dual_conic", "lindeberg_fitzgibbon".
[[nodiscard]] std::string_view id(CentreMethod method);
[[nodiscard]] std::optional<CentreMethod> centreMethodOf(std::string_view id);

/// What the finder takes for a disc. Defaults suit the bench: 7 mm discs at 0.25 to 0.8 m, f about 550 to 720
/// px.
struct FinderSettings {
  CentreMethod method = CentreMethod::kMaximumLikelihood;
  double min_diameter_px = 3.4;  ///< of the disc itself, without the blur
  double max_diameter_px = 60.0;
  double max_axis_ratio = 2.6;  ///< major to minor axis; film sends no light back when seen flatter
  double max_fit_rms_px =
      0.35;               ///< edge points from the fitted ellipse; less for small discs (the paper's method)
  double blur_px = 0.75;  ///< usual standard deviation of the lens's blur and a pixel's area together
  double blur_tolerance_px = 0.1;  ///< of it; discs hardly larger than the blur are told from specks by this
  double outline_tolerance_px = 0.04;         ///< that a real disc's outline may deviate from an ellipse
  double outline_tolerance_of_radius = 0.01;  ///< and more, in shares of its radius
  double light_tolerance = 0.03;     ///< that a disc's light may vary besides noise and ramp, in shares of it
  double max_centre_sigma_px = 0.3;  ///< a centre less certain than that is no measurement
  double min_outline_fraction = 0.5;  ///< share of the outline that the image must support
  double edge_sigma_px = 1.0;   ///< scale of the paper's edges; twice that for discs beyond 14 times as much
  bool dark_on_bright = false;  ///< calibration plates: dark dots on bright ground
  double min_size_of_neighbours = 0.0;  ///< plates: dirt is smaller than the dots around it, which are alike
};

/// For calibration plates: dark dots on bright ground, 6 to 100 px wide, also on coarse prints and
/// interlaced video.
[[nodiscard]] inline FinderSettings plateSettings() {
  FinderSettings settings;
  settings.min_diameter_px = 6.0;
  settings.max_diameter_px = 100.0;
  settings.max_axis_ratio = 2.5;
  settings.max_fit_rms_px = 1.0;
  settings.blur_px = 1.5;
  settings.blur_tolerance_px = 1.0;
  settings.outline_tolerance_px = 0.2;
  settings.outline_tolerance_of_radius = 0.03;
  settings.light_tolerance = 0.15;
  settings.max_centre_sigma_px = 0.45;
  settings.dark_on_bright = true;
  settings.min_size_of_neighbours = 0.8;
  return settings;
}

}  // namespace mirrorarm::vision
