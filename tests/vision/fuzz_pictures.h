#pragma once

#include <random>
#include <vector>

#include "core/camera/image.h"
#include "core/camera/stereo_rig.h"
#include "core/vision/finder_settings.h"
#include "core/vision/region.h"

namespace mirrorarm::vision {

/// Anything that may come out of a camera or a file, from one seed: sizes from 1x1, black, white, noise, salt
/// and pepper, gradients, boards, discs, bars, columns, cuttings of real photographs with changed bytes.
class FuzzSource {
 public:
  explicit FuzzSource(unsigned seed) : random_(seed) {}

  /// `width` or `height` 0: any.
  [[nodiscard]] camera::GreyImage picture(int width = 0, int height = 0);
  /// Bright discs on dark ground.
  [[nodiscard]] camera::GreyImage markers(int width, int height);
  /// What a second camera may see of it: shifted to the left, now and then with something before it.
  [[nodiscard]] camera::GreyImage partnerOf(const camera::GreyImage& image);
  /// A setting now and then is zero, negative, huge, or no number.
  [[nodiscard]] FinderSettings settings();
  [[nodiscard]] camera::CameraModel camera(int width, int height);
  [[nodiscard]] camera::StereoRig rig(int width, int height);
  /// Also outside of the image, inverted, and at the ends of what an int holds.
  [[nodiscard]] std::vector<Region> regions(int width, int height);
  [[nodiscard]] std::vector<Eigen::Vector3d> points();

  [[nodiscard]] int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  [[nodiscard]] double real(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  [[nodiscard]] bool oneIn(int times) { return whole(1, times) == 1; }

 private:
  [[nodiscard]] double absurdOr(double sensible);

  std::mt19937 random_;
};

/// The picture in memory of its own whose rows stand apart and which ends with its last pixel, so that a
/// sanitizer sees a step beyond.
class SpacedPicture {
 public:
  SpacedPicture(const camera::GreyImage& image, int gap_px);
  [[nodiscard]] camera::ImageView view() const { return {bytes_.data(), width_, height_, stride_}; }

 private:
  int width_;
  int height_;
  std::ptrdiff_t stride_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace mirrorarm::vision
