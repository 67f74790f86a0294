// Simulated skin through the whole tracker: found from nothing, followed, its shape learnt.
#include <gtest/gtest.h>

#include "core/tracking/tracker.h"
#include "tests/tracking/skin_play.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

constexpr double kSession_s = 20.0;
constexpr int kStrangers = 3;

std::vector<vision::StereoPoint> stereoPoints(const SkinFrame& frame) {
  std::vector<vision::StereoPoint> points(frame.cloud.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k].p_C = frame.cloud[k].p_C;
    points[k].covariance_m2 = frame.cloud[k].covariance_m2;
  }
  return points;
}

struct Tally {
  int frames = 0, tracked = 0, shown = 0, found = 0, wrong = 0;
};

Tally follow(double best_fit_rms_m, int hidden, unsigned seed) {
  SkinMotion motion;
  motion.best_fit_rms_m = best_fit_rms_m;
  SimulatedSkin skin(motion, seed);
  const Target taught = skin.taughtAt(0.0);
  Tracker tracker{TrackerSettings{}};
  tracker.setTargets({&taught, 1});
  Tally tally;
  for (double t = 0.0; t < kSession_s; t += SimulatedSkin::kFrame_s) {
    const SkinFrame frame = skin.look(t, hiddenAt(t, hidden, 6.0), kStrangers);
    const auto answer = tracker.track(stereoPoints(frame), timeOf(frame))[0];
    tracker.learn();
    ++tally.frames;
    for (const int marker : frame.marker_of_point) tally.shown += marker >= 0 ? 1 : 0;
    if (answer.status != TrackStatus::kTracked) continue;
    ++tally.tracked;
    for (int i = 0; i < SimulatedSkin::kMarkers; ++i) {
      const int point = answer.point_of_marker[static_cast<std::size_t>(i)];
      if (point < 0) continue;
      ++tally.found;
      tally.wrong += frame.marker_of_point[static_cast<std::size_t>(point)] != i ? 1 : 0;
    }
  }
  return tally;
}

}  // namespace

TEST(TrackedSkin, EveryMarkerKeepsItsIdentityWhateverTheSkinDoes) {
  for (const double size_m : {0.002, 0.005, 0.008})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Tally tally = follow(size_m, 0, seed);
      EXPECT_EQ(tally.tracked, tally.frames) << size_m << " " << seed;
      EXPECT_EQ(tally.wrong, 0) << size_m << " " << seed;
      EXPECT_GE(tally.found, tally.shown * 999 / 1000) << size_m << " " << seed;
    }
}

TEST(TrackedSkin, HiddenMarkersCostNoFrames) {
  for (const double size_m : {0.002, 0.005, 0.008})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Tally tally = follow(size_m, 3, seed);
      EXPECT_GE(tally.tracked, tally.frames * 99 / 100) << size_m << " " << seed;
      EXPECT_LE(tally.wrong, tally.found / 200) << size_m << " " << seed;
    }
}
