// A real arm's recorded motion: ten skin markers of the forearm, labels stripped, order shuffled.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/tracking/teacher.h"
#include "core/tracking/tracker.h"
#include "tests/tracking/world.h"

using namespace mirrorarm;
using namespace mirrorarm::tracking;
using namespace mirrorarm::tracking::test;

namespace {

const std::string kForearm[] = {"EPICl",    "EPICm", "LARMm",    "LARMl", "LARM_elb",
                                "LARM_ant", "STYLr", "STYLr_up", "STYLu", "WRIST"};

/// Marker positions frame by frame, by name [m]; empty when the file is absent.
std::vector<std::map<std::string, Vector3d>> readMotion() {
  std::ifstream in(std::filesystem::path(SHARED_DATA) / "pyomeca-upper-limb" / "markers.trc");
  std::vector<std::map<std::string, Vector3d>> motion;
  std::string line;
  std::vector<std::string> names;
  for (int number = 1; std::getline(in, line); ++number) {
    const auto cells = splitCells(line, ',');
    if (number == 4) names = cells;
    if (number < 6 || cells.size() < 5 || cells[0].empty()) continue;
    auto& frame = motion.emplace_back();
    for (std::size_t c = 2; c + 2 < cells.size(); c += 3) {
      Vector3d p_mm;
      if (parseNumber(cells[c], p_mm[0]) && parseNumber(cells[c + 1], p_mm[1]) &&
          parseNumber(cells[c + 2], p_mm[2]))
        frame[names[c]] = 0.001 * p_mm;
    }
  }
  return motion;
}

struct Frame {
  std::vector<Vector3d> points_C;
  std::vector<std::string> name;
};

/// Points of one frame in another order each time; with or without the rest of the body.
Frame shuffled(const std::map<std::string, Vector3d>& markers, bool whole_body, Noise& noise) {
  std::vector<std::pair<std::string, Vector3d>> chosen;
  for (const auto& marker : markers)
    if (whole_body || std::find(std::begin(kForearm), std::end(kForearm), marker.first) != std::end(kForearm))
      chosen.push_back(marker);
  std::shuffle(chosen.begin(), chosen.end(), noise.rng);
  Frame frame;
  for (const auto& [name, p] : chosen) {
    frame.name.push_back(name);
    frame.points_C.push_back(p);
  }
  return frame;
}

class RealForearm : public testing::TestWithParam<bool> {};

}  // namespace

TEST_P(RealForearm, IsTrackedWithRightIdentities) {
  const auto motion = readMotion();
  if (motion.empty()) GTEST_SKIP() << "shared data pyomeca-upper-limb is absent";
  ASSERT_GT(motion.size(), 50u);
  Noise noise(41);
  Teacher teacher{TeacherSettings{}};
  for (std::size_t i = 0; i < 20; ++i) teacher.add(shuffled(motion[i], false, noise).points_C);
  const auto taught = teacher.finish("forearm");
  ASSERT_TRUE(taught);
  ASSERT_EQ(taught->target.markers_T.size(), 10u);

  Tracker tracker{TrackerSettings{}};
  tracker.setTargets({&taught->target, 1});
  std::map<int, std::string> name_of_marker;
  int right = 0, tracked = 0;
  double rms_m = 0.0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Frame frame = shuffled(motion[i], GetParam(), noise);
    const auto answer = tracker.track(asStereo(frame.points_C),
                                      TimePoint(toClock(Seconds(0.01 * static_cast<double>(i)))))[0];
    if (answer.status != TrackStatus::kTracked) continue;
    ++tracked;
    rms_m += answer.rms_m;
    bool all_right = true;
    for (int m = 0; m < 10; ++m) {
      const int point = answer.point_of_marker[static_cast<std::size_t>(m)];
      if (point < 0) continue;
      const auto& name = frame.name[static_cast<std::size_t>(point)];
      all_right = all_right && name_of_marker.emplace(m, name).first->second == name;
    }
    if (all_right) ++right;
  }
  std::vector<std::string> names;
  for (const auto& [marker, name] : name_of_marker) names.push_back(name);
  std::sort(names.begin(), names.end());
  std::vector<std::string> expected(std::begin(kForearm), std::end(kForearm));
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(names, expected);
  EXPECT_GE(right, static_cast<int>(0.95 * static_cast<double>(motion.size())));
  RecordProperty("tracked", tracked);
  RecordProperty("rms_um", static_cast<int>(1e6 * rms_m / tracked));
}

INSTANTIATE_TEST_SUITE_P(AloneAndAmongAllMarkersOfTheBody, RealForearm, testing::Bool());
