#include <cmath>

#include <gtest/gtest.h>

#include "core/calibration/point_residuals.h"
#include "tests/calibration/board_views.h"

namespace mirrorarm::calibration {
namespace {

TEST(PointResiduals, AreTheNoiseAndNameTheBadPoint) {
  ViewMaker maker{trueRig(camera::LensModel::kKannalaBrandt)};
  maker.noise_px = 0.05;
  auto views = maker.views(4);
  views[2].seen[1][17].pixel += Eigen::Vector2d(3.0, -4.0);
  const auto residuals = pointResiduals(maker.rig, maker.board, views);
  ASSERT_EQ(residuals.size(), 4u * 2u * 54u);
  double squares = 0.0;
  for (const auto& residual : residuals) {
    if (residual.view == views[2].name && residual.camera == 1 && residual.point == 17)
      EXPECT_NEAR(residual.offset_px.norm(), 5.0, 0.5);
    else
      squares += residual.offset_px.squaredNorm();
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(residuals.size())), 0.3);
}

}  // namespace
}  // namespace mirrorarm::calibration
