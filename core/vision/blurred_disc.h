#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/vision/brightness.h"

namespace mirrorarm::vision {

/// What a disc's light on a sensor is taken to be: an ellipse with a soft rim on even ground,
///
///   I(p) = ground + (light + ramp . r) S(r) + blur^2 ramp . grad S,   r = p - centre,
///   S(r) = Phi(-d(r) / blur),   d = (s^2 - s) / |B B r| + blur^2 curvature / 2,   s = |B r|,
///
/// where B is the symmetric matrix that takes the outline to the unit circle, d the distance from the
/// outline to second order, with what the blur draws a curved outline inwards, and Phi the normal
/// distribution: the lens's Gaussian blur and the pixel's area together. A reflectance that changes linearly
/// over the disc is blurred with it, which the last term says exactly. Where something straight covers a part
/// of the disc, S also falls off beyond that edge, and there is no ramp.
struct BlurredDisc {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Matrix2d B_per_px = Eigen::Matrix2d::Identity();
  double blur_px = 0.75;
  double ground = 0.0;                                    ///< [grey]
  double light = 0.0;                                     ///< [grey] above the ground at the centre
  Eigen::Vector2d ramp_per_px = Eigen::Vector2d::Zero();  ///< [grey/px]

  /// A straight cover: everything beyond `cover_offset_px` from the centre along the direction is hidden.
  bool covered = false;
  double cover_direction_rad = 0.0;
  double cover_offset_px = 0.0;
};

/// Order of the parameters in normal equations. The last two are the ramp, or the cover's direction and
/// offset.
enum DiscParameter { kCentreX, kCentreY, kBxx, kBxy, kByy, kBlur, kGround, kLight, kExtra1, kExtra2 };
inline constexpr int kDiscParameters = 10;
using DiscVector = Eigen::Matrix<double, kDiscParameters, 1>;
using DiscMatrix = Eigen::Matrix<double, kDiscParameters, kDiscParameters>;

/// Variance of a pixel [grey^2]: `dark` in the ground, `lit` more where the disc's light is full.
struct PixelNoise {
  double dark = 1.0;
  double lit = 0.0;
};

/// Weighted normal equations of one Gauss-Newton step.
struct DiscEquations {
  DiscMatrix matrix = DiscMatrix::Zero();
  DiscVector vector = DiscVector::Zero();
  double squares = 0.0;  ///< sum of squared residuals by their variance
  /// Sums over the pixels that say something, to learn the noise from: their number, S, S^2, the squared
  /// residual [grey^2] and S times that.
  double pixels = 0.0, share = 0.0, share2 = 0.0, square = 0.0, share_square = 0.0;
};

/// What the model leaves over, pixel by pixel, rows of `width` without gaps.
struct DiscResiduals {
  int width = 0;
  int height = 0;
  std::vector<float> residual;  ///< image minus model [grey]; exactly 0 where the pixel says nothing
  std::vector<float> share;     ///< S
  std::vector<float> slope;     ///< what moving the outline by a pixel outwards adds [grey/px]
  std::vector<float> ux;        ///< B r: where around the outline
  std::vector<float> uy;
};

/// `window` is what normalEquations and residuals see of the image: inside it, at least eight pixels wide,
/// its width a multiple of eight. Pixels at the sensor's upper end say only that the light is at least as
/// strong; pixels outside the disc that are far brighter than the model belong to something else and say
/// nothing.
void normalEquations(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
                     const Region& window, DiscEquations& equations);
void residuals(const BlurredDisc& disc, const PixelNoise& noise, const Brightness& image,
               const Region& window, DiscResiduals& result);

}  // namespace mirrorarm::vision
