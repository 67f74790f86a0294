#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/vision/stereo_vision.h"
#include "fuzz_pictures.h"

// Whatever comes in: no crash, and every number that goes out is one.
namespace mirrorarm::vision {
namespace {

constexpr double kBeyond_px = 4.0;  // a disc at the border may have its centre a little outside

template <class Matrix>
bool isPositiveDefinite(const Matrix& covariance) {
  return covariance.allFinite() && Eigen::LLT<Matrix>(covariance).info() == Eigen::Success;
}

void expectSound(const DetectedMarker& marker, const Eigen::Vector2d& size_px) {
  const auto& centre = marker.centre_px;
  ASSERT_TRUE(centre.allFinite());
  EXPECT_GE(centre.minCoeff(), -kBeyond_px);
  EXPECT_LE((centre - size_px).maxCoeff(), kBeyond_px) << centre.transpose();
  EXPECT_TRUE(isPositiveDefinite(marker.covariance_px2)) << marker.covariance_px2;
  EXPECT_TRUE(marker.shape_covariance_px4.allFinite());
  EXPECT_TRUE(marker.ellipse.centre_px.allFinite());
  EXPECT_GT(marker.ellipse.semi_minor_px, 0.0);
  EXPECT_GE(marker.ellipse.semi_major_px, marker.ellipse.semi_minor_px);
  EXPECT_TRUE(std::isfinite(marker.ellipse.semi_major_px) && std::isfinite(marker.ellipse.angle_rad));
  EXPECT_GE(marker.outline_fraction, 0.0);
  EXPECT_LE(marker.outline_fraction, 1.0);
}

void expectCounted(const Detection& found) {
  const auto all = static_cast<std::size_t>(std::accumulate(found.rejected.begin(), found.rejected.end(), 0));
  EXPECT_EQ(found.rejected_lights.size(), std::min(all, kMostRejectedLights));
  std::array<int, kRejectionCount> told{};
  for (const auto& light : found.rejected_lights) {
    EXPECT_TRUE(light.position_px.allFinite());
    EXPECT_GE(light.extent_px, 0.0);
    ++told[static_cast<std::size_t>(light.reason)];
  }
  for (std::size_t i = 0; i < kRejectionCount; ++i) {
    EXPECT_LE(told[i], found.rejected[i]);
    if (all <= kMostRejectedLights) {
      EXPECT_EQ(told[i], found.rejected[i]) << id(static_cast<Rejection>(i));
    }
  }
}

void expectSound(const Detection& found, int width, int height) {
  for (const auto& marker : found.markers) expectSound(marker, Eigen::Vector2d(width - 1, height - 1));
  expectCounted(found);
  const auto& light = found.exposure;
  EXPECT_TRUE(std::isfinite(light.background) && std::isfinite(light.noise) &&
              std::isfinite(light.brightest));
  EXPECT_GE(light.saturated_markers, 0);
}

void expectSound(const StereoObservation& seen, int width, int height) {
  expectSound(seen.left, width, height);
  expectSound(seen.right, width, height);
  for (const auto& point : seen.points) {
    EXPECT_TRUE(point.p_C.allFinite());
    EXPECT_TRUE(isPositiveDefinite(point.covariance_m2)) << point.covariance_m2;
    EXPECT_TRUE(std::isfinite(point.epipolar_px) && std::isfinite(point.radius_m) &&
                std::isfinite(point.support));
    EXPECT_TRUE(point.normal_C.allFinite() && point.left_px.allFinite() && point.right_px.allFinite());
    EXPECT_GE(point.rivals, 0);
    ASSERT_GE(std::min(point.left, point.right), 0);
    ASSERT_LT(point.left, static_cast<int>(seen.left.markers.size()));
    ASSERT_LT(point.right, static_cast<int>(seen.right.markers.size()));
  }
}

/// A block of seeds, so that one that crashes is soon found.
class Fuzz : public testing::TestWithParam<unsigned> {
 protected:
  template <class Try>
  void everySeed(unsigned count, Try attempt) {
    for (unsigned i = 0; i < count && !HasFatalFailure(); ++i) {
      const unsigned seed = 1000 * GetParam() + i;
      SCOPED_TRACE("seed " + std::to_string(seed));
      FuzzSource source(seed);
      attempt(source);
    }
  }
};

TEST_P(Fuzz, TheFinderAnswersAnyPicture) {
  everySeed(60, [](FuzzSource& source) {
    const auto settings = source.settings();
    std::optional<camera::CameraModel> camera;
    if (source.oneIn(2)) camera = source.camera(source.whole(1, 300), source.whole(1, 300));
    MarkerFinder finder(settings, camera);
    for (int frame = 0; frame < 2; ++frame) {
      const SpacedPicture picture(source.picture(), source.oneIn(2) ? 0 : source.whole(1, 70));
      const auto view = picture.view();
      expectSound(finder.find(view, source.regions(view.width_px, view.height_px)), view.width_px,
                  view.height_px);
    }
  });
}

TEST_P(Fuzz, EveryMethodAnswersBrightAndDark) {
  everySeed(20, [](FuzzSource& source) {
    const SpacedPicture picture(source.picture(), source.whole(0, 3));
    const auto view = picture.view();
    for (const bool dark : {false, true})
      for (const auto method :
           {CentreMethod::kMaximumLikelihood, CentreMethod::kDualConic, CentreMethod::kLindebergFitzgibbon}) {
        FinderSettings settings = dark ? plateSettings() : FinderSettings{};
        settings.method = method;
        MarkerFinder finder(settings);
        expectSound(finder.find(view), view.width_px, view.height_px);
      }
  });
}

TEST_P(Fuzz, StereoAnswersAnyPairOnAnyRig) {
  everySeed(50, [](FuzzSource& source) {
    const int width = source.oneIn(4) ? source.whole(1, 60) : source.whole(80, 260);
    const int height = source.whole(1, 160);
    StereoVision vision(source.rig(width, height), source.oneIn(2) ? FinderSettings{} : source.settings(),
                        MatcherSettings{});
    for (int pair = 0; pair < 2; ++pair) {
      camera::StereoFrame frame;
      frame.left = source.oneIn(2) ? source.markers(width, height) : source.picture(width, height);
      frame.right = source.oneIn(4) ? source.picture(width, height) : source.partnerOf(frame.left);
      if (source.oneIn(6)) frame.right = source.picture();
      vision.expect(source.points(), source.oneIn(4) ? source.real(-1.0, 1e6) : 0.004);
      expectSound(vision.observe(frame), width, height);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Seeds, Fuzz, testing::Range(1U, 9U));

TEST(BadRigs, NumbersThatAreNoneGiveNoMarkers) {
  FuzzSource source(7);
  const auto image = source.markers(96, 72);
  const double nan = std::nan("");
  for (const int wrong : {0, 1, 2, 3}) {
    auto rig = source.rig(96, 72);
    auto intrinsics = camera::Intrinsics{camera::LensModel::kBrownConrady, 96, 72, 90, 90, 48, 36, {}};
    if (wrong == 0) intrinsics.fx_px = nan;
    if (wrong == 1) intrinsics.cy_px = nan;
    if (wrong == 2) intrinsics.distortion[1] = nan;
    rig.left = rig.right = camera::CameraModel(intrinsics);
    rig.X_RC = RigidTransform::Identity();
    rig.X_RC.translation().x() = wrong == 3 ? nan : -0.1;
    StereoVision vision(rig, FinderSettings{}, MatcherSettings{});
    const auto& seen = vision.observe({image, image, {}, {}, 0});
    EXPECT_TRUE(seen.points.empty()) << wrong;
    if (wrong < 3) {
      EXPECT_TRUE(seen.left.markers.empty()) << wrong;
    }
  }
}

TEST(BadImages, OfAnotherSizeThanTheRigsGiveNothing) {
  FuzzSource source(3);
  StereoVision vision(source.rig(96, 72), FinderSettings{}, MatcherSettings{});
  for (const auto& [width, height] : {std::pair(95, 72), {96, 73}, {1, 1}, {72, 96}}) {
    const auto& seen = vision.observe({source.picture(96, 72), source.picture(width, height), {}, {}, 5});
    EXPECT_TRUE(seen.left.markers.empty() && seen.right.markers.empty() && seen.points.empty());
    EXPECT_EQ(seen.sequence, 5U);
  }
  EXPECT_TRUE(vision.observe({}).points.empty());
}

}  // namespace
}  // namespace mirrorarm::vision
