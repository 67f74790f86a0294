#include <gtest/gtest.h>

#include "core/calibration/rig_comparison.h"
#include "core/geometry/small_motion.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

TEST(RigComparison, EqualRigsDoNotDiffer) {
  ViewMaker maker{trueRig(camera::LensModel::kKannalaBrandt)};
  maker.noise_px = 0.02;
  const auto same = compareRigs(maker.rig, maker.rig, maker.board, maker.views(4));
  EXPECT_DOUBLE_EQ(same.turn_deg, 0.0);
  EXPECT_DOUBLE_EQ(same.shift_mm, 0.0);
  EXPECT_DOUBLE_EQ(same.focal_percent, 0.0);
  EXPECT_GT(same.epipolar_new_px, 0.0);
  EXPECT_DOUBLE_EQ(same.epipolar_new_px, same.epipolar_old_px);
  for (const auto& depth : same.depth) EXPECT_NEAR(depth.error_percent, 0.0, 1e-6);
}

TEST(RigComparison, AKnockedBarShowsInEveryFigure) {
  ViewMaker maker{trueRig(camera::LensModel::kKannalaBrandt)};
  maker.noise_px = 0.02;
  auto old = maker.rig;
  SmallMotion knock;
  knock << 0.002, 0.001, 0.0, 0.0, 0.0003, 0.0;
  old.X_RC = moved(old.X_RC, knock);
  const auto found = compareRigs(maker.rig, old, maker.board, maker.views(4));
  EXPECT_NEAR(found.turn_deg, std::hypot(0.002, 0.001) * 57.29578, 1e-4);
  EXPECT_GT(found.shift_mm, 0.25);
  EXPECT_GT(found.epipolar_old_px, 10.0 * found.epipolar_new_px);
  EXPECT_DOUBLE_EQ(found.depth[1].distance_m, 0.4);
  // A turn of 1 mrad about y shifts the disparity of 0.12 m f / z by 1e-3 f (1 + (x / z)^2): near 0.4 %.
  EXPECT_NEAR(std::abs(found.depth[1].error_percent), 0.36, 0.08);
  EXPECT_GT(std::abs(found.depth[2].error_percent), std::abs(found.depth[0].error_percent));
}

TEST(RigComparison, AnotherFocalLengthIsAShareOfIt) {
  ViewMaker maker{trueRig(camera::LensModel::kBrownConrady)};
  auto lens = maker.rig.right.intrinsics();
  lens.fy_px *= 1.01;
  auto next = maker.rig;
  next.right = camera::CameraModel(lens);
  EXPECT_NEAR(compareRigs(next, maker.rig, maker.board, maker.views(3)).focal_percent, 1.0, 1e-9);
}

}  // namespace
}  // namespace mirrorarm::calibration
