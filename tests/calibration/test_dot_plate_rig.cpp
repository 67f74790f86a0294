#include <gtest/gtest.h>

#include "core/calibration/board_finder.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/rig_file.h"
#include "core/simulation/stereo_renderer.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::size_t kViews = 16;

/// Photographs a dot plate with the bench's rig.
class DotPlateRig : public testing::Test {
 protected:
  DotPlateRig() {
    maker_.board = {BoardKind::kDotPlate, 9, 7, 0.03};
    maker_.reach = 0.9;
    const auto diameters_m = discDiameters_m(maker_.board);
    const auto points = boardPoints(maker_.board);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double radius_m = 0.5 * diameters_m[i];
      plate_.push_back(
          {points[i], radius_m * Eigen::Vector3d::UnitX(), -radius_m * Eigen::Vector3d::UnitY()});
    }
  }

  std::optional<BoardView> photograph(const RigidTransform& X_CM, std::size_t i) {
    simulation::StereoRenderer::Instant instant;
    for (const auto& patch : plate_) instant.push_back(transformed(X_CM, patch));
    const auto [left, right] = renderer_.render(std::span(&instant, 1), i);
    const auto left_seen = findBoard(left.view(), maker_.board);
    const auto right_seen = findBoard(right.view(), maker_.board);
    if (!left_seen || !right_seen) return std::nullopt;
    return BoardView{"view" + std::to_string(i), {*left_seen, *right_seen}};
  }

  ViewMaker maker_{*camera::readRig(std::string(RESOURCES) + "/rigs/fisheye.yaml")};
  simulation::StereoRenderer::Instant plate_;
  simulation::StereoRenderer renderer_{maker_.rig, {}, {}};
};

TEST_F(DotPlateRig, ImagesGiveTheTrueRigWithinItsCovariance) {
  std::vector<BoardView> views;
  for (std::size_t i = 0; i < 4 * kViews && views.size() < kViews; ++i)
    if (auto view = photograph(maker_.boardPose(), i)) views.push_back(std::move(*view));
  ASSERT_EQ(views.size(), kViews);
  const auto found = calibrateStereo(maker_.board, views, {1296, 964}, camera::LensModel::kKannalaBrandt);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->outliers.empty());
  EXPECT_LT(found->rms_px, 0.03);
  EXPECT_LT(found->hold_out->epipolar_px, 0.03);
  const RigidTransform X_CC = maker_.rig.X_RC.inverse() * found->rig.X_RC;
  const Eigen::Vector3d turns = rotationVector(X_CC.linear()).cwiseQuotient(found->bar_sigma.head<3>());
  const Eigen::Vector3d shifts = X_CC.translation().cwiseQuotient(found->bar_sigma.tail<3>());
  EXPECT_LT(turns.cwiseAbs().maxCoeff(), 4.0);
  EXPECT_LT(shifts.cwiseAbs().maxCoeff(), 4.0);
  EXPECT_LT(X_CC.translation().norm(), 5e-5);
}

}  // namespace
}  // namespace mirrorarm::calibration
