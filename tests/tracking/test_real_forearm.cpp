// A real arm's recorded motion: ten skin markers of the forearm, labels stripped, order shuffled, among all
// markers of the body; as clouds from a file give them, without covariance, and with the sensor's.
#include <gtest/gtest.h>

#include "core/tracking/teacher.h"
#include "core/tracking/tracker.h"
#include "tests/tracking/real_forearm.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

constexpr std::size_t kLesson = 20;
constexpr std::size_t kMarkers = 10;

struct View {
  bool whole_body = true;
  double sigma_m = 0.0;  ///< told of each point; 0 where it is not known
  unsigned seed = 1;
};

class RealForearmTracked : public testing::TestWithParam<View> {
 protected:
  [[nodiscard]] std::vector<vision::StereoPoint> points(const RealForearm::Frame& frame) const {
    std::vector<vision::StereoPoint> points(frame.points_C.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].p_C = frame.points_C[i];
      points[i].covariance_m2 = GetParam().sigma_m * GetParam().sigma_m * Eigen::Matrix3d::Identity();
    }
    return points;
  }
};

}  // namespace

TEST_P(RealForearmTracked, EveryMarkerIsItselfInEveryFrame) {
  const RealForearm forearm(std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb" / "markers.trc");
  if (forearm.frames() == 0) GTEST_SKIP() << "shared data pyomeca-upper-limb is absent";
  ASSERT_GT(forearm.frames(), 50U);
  std::mt19937 rng(GetParam().seed);
  Teacher teacher{TeacherSettings{}};
  std::vector<CloudPoint> cloud;
  for (std::size_t i = 0; i < kLesson; ++i) {
    collectCloud(points(forearm.shuffled(i, false, rng)), cloud);
    teacher.add(cloud);
  }
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  ASSERT_EQ(taught->target.markers_T.size(), kMarkers);

  Tracker tracker{TrackerSettings{}};
  tracker.setTargets({&taught->target, 1});
  IdentityCheck identities;
  for (std::size_t i = 0; i < forearm.frames(); ++i) {
    const auto frame = forearm.shuffled(i, GetParam().whole_body, rng);
    const TimePoint time(toClock(Seconds(RealForearm::kFrame_s * static_cast<double>(i))));
    const auto answer = tracker.track(points(frame), time)[0];
    ASSERT_EQ(answer.status, TrackStatus::kTracked) << i << " " << id(answer.reason);
    EXPECT_TRUE(identities.add(answer.point_of_marker, kMarkers, frame.names)) << i;
  }
  EXPECT_EQ(identities.different(), kMarkers);
}

INSTANTIATE_TEST_SUITE_P(Views, RealForearmTracked,
                         testing::Values(View{false, 0.0002, 41}, View{true, 0.0002, 42}, View{true, 0.0, 43},
                                         View{true, 0.0, 44}, View{true, 0.0, 45}));
