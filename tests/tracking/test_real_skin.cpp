// A real arm's recorded motion: the skin model alone, about the forearm's ten markers among all of the body.
#include <gtest/gtest.h>

#include "core/tracking/constellation_search.h"
#include "core/tracking/teacher.h"
#include "tests/tracking/real_forearm.h"
#include "tests/tracking/skin_loop.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

constexpr double kSensor_m = 0.0002;

std::vector<CloudPoint> measured(const std::vector<Eigen::Vector3d>& points_C) {
  std::vector<CloudPoint> cloud;
  for (const auto& p_C : points_C)
    cloud.push_back({p_C, kSensor_m * kSensor_m * Eigen::Matrix3d::Identity(), {}});
  return cloud;
}

RigidTransform found(const Target& target, const std::vector<CloudPoint>& cloud) {
  ConstellationSettings wide;
  wide.tolerance_m = 0.002;
  ConstellationSearch search(wide);
  const std::span<const Eigen::Vector3d> markers(target.markers_T);
  search.setTargets({&markers, 1});
  const auto results = search.run(cloud);
  EXPECT_EQ(results[0].verdict, SearchVerdict::kFound);
  return results[0].best.X_CT;
}

}  // namespace

TEST(RealSkin, KeepsAllTenMarkersInEveryFrameAmongAllOfTheBody) {
  const RealForearm forearm(std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb" / "markers.trc");
  if (forearm.frames() == 0) GTEST_SKIP() << "shared data pyomeca-upper-limb is absent";
  ASSERT_GT(forearm.frames(), 50U);
  std::mt19937 rng(43);
  Teacher teacher{TeacherSettings{}};
  for (std::size_t i = 0; i < 20; ++i) teacher.add(measured(forearm.shuffled(i, false, rng).points_C));
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  ASSERT_EQ(taught->target.markers_T.size(), 10U);

  const RigidTransform X_CT = found(taught->target, measured(forearm.shuffled(0, true, rng).points_C));
  SkinLoop loop(taught->target, X_CT, X_CT);
  IdentityCheck identities;
  for (std::size_t i = 0; i < forearm.frames(); ++i) {
    const auto frame = forearm.shuffled(i, true, rng);
    const TimePoint time(toClock(Seconds(1.0 + RealForearm::kFrame_s * static_cast<double>(i))));
    ASSERT_TRUE(loop.track(measured(frame.points_C), time)) << i;
    EXPECT_TRUE(identities.add(loop.fit->point_of_marker, 10, frame.names)) << i;
    EXPECT_EQ(loop.event, SkinEvent::kNone) << i;
  }
  EXPECT_EQ(identities.different(), 10U);
}
