#include <filesystem>
#include <fstream>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "core/camera/camera_model.h"
#include "core/camera/image_file.h"
#include "core/vision/marker_finder.h"
#include "plate_lattice.h"

namespace mirrorarm::vision {
namespace {

// SOURCE.txt of the images: 14 rows of 16 dots, four of them larger.
constexpr int kColumns = 16, kRows = 14;
constexpr double kRim = 3.5;  // of bare metal around the dots, in steps

/// Numbers as NumPy writes them, separated by blanks and line ends.
std::vector<double> numbersIn(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;) numbers.push_back(number);
  return numbers;
}

class Plate : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto folder = std::filesystem::path(SHARED_DATA) / "ucl-dots-metal";
    const auto file = folder / GetParam();
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
    const auto image = camera::readImage(file);
    ASSERT_TRUE(image);
    const auto camera = file.filename().string().starts_with("left") ? "calib.left." : "calib.right.";
    const auto K = numbersIn(folder / (std::string(camera) + "intrinsics.txt"));
    const auto k = numbersIn(folder / (std::string(camera) + "distortion.txt"));
    ASSERT_EQ(K.size(), 9U);
    ASSERT_EQ(k.size(), 5U);
    camera_ = camera::CameraModel({camera::LensModel::kBrownConrady,
                                   image->width(),
                                   image->height(),
                                   K[0],
                                   K[4],
                                   K[2],
                                   K[5],
                                   {k[0], k[1], k[2], k[3], k[4]}});
    MarkerFinder finder(plateSettings());
    for (const auto& marker : finder.find(image->view()).markers) dots_.push_back(marker.centre_px);
  }

  /// Lens and perspective taken away: pixels of an image without distortion.
  Eigen::Vector2d straight(const Eigen::Vector2d& pixel) const {
    return camera_.intrinsics().fx_px * camera_.unproject(pixel).value();
  }

  camera::CameraModel camera_;
  std::vector<Eigen::Vector2d> dots_;
};

TEST_P(Plate, EveryDotIsFoundAndNothingElseOnThePlate) {
  const PlateLattice lattice(dots_);
  ASSERT_EQ(lattice.size(), Eigen::Vector2i(kColumns, kRows));
  std::vector<Place> places;
  std::vector<Eigen::Vector2d> points;
  std::set<std::pair<int, int>> taken;
  for (std::size_t i = 0; i < dots_.size(); ++i) {
    if (!lattice.places()[i]) continue;
    places.push_back(*lattice.places()[i]);
    points.push_back(straight(dots_[i]));
    EXPECT_TRUE(taken.insert({places.back().x(), places.back().y()}).second) << "a dot found twice";
  }
  ASSERT_EQ(places.size(), static_cast<std::size_t>(kColumns * kRows));

  // In steps of the plate; the calibration that came with the images is good to a twentieth in the corners.
  const Eigen::Matrix3d to_place = homographyOf(places, points).inverse();
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d found = (to_place * points[i].homogeneous()).hnormalized();
    const double off = (found - places[i].cast<double>()).norm();
    EXPECT_LT(off, 0.1) << places[i].transpose();
    sum += off * off;
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(places.size())), 0.02);

  for (std::size_t i = 0; i < dots_.size(); ++i) {
    if (lattice.places()[i]) continue;
    const Eigen::Vector2d place = (to_place * straight(dots_[i]).homogeneous()).hnormalized();
    const bool on_plate = place.x() > -kRim && place.x() < kColumns - 1 + kRim && place.y() > -kRim &&
                          place.y() < kRows - 1 + kRim;
    EXPECT_FALSE(on_plate) << "no dot is at " << dots_[i].transpose() << ", place " << place.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(SixImages, Plate,
                         testing::Values("14_10_22/left_image.png", "14_10_22/right_image.png",
                                         "14_11_22/left_image.png", "14_11_22/right_image.png",
                                         "14_12_44/left_image.png", "14_12_44/right_image.png"));

}  // namespace
}  // namespace mirrorarm::vision
