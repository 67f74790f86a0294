#include <fstream>

#include <gtest/gtest.h>

#include "core/station/black_box_file.h"
#include "core/station/stop_log.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::station {
namespace {

using control::ServoState;
using control::StopCategory;
using control::StopReason;

ServoState cycleAt(double seconds, StopReason stop, bool at_rest = false,
                   StopCategory category = StopCategory::kTwo) {
  ServoState state;
  state.time = TimePoint(std::chrono::hours(1)) + toClock(Seconds(seconds));
  state.stop = stop;
  state.category = stop == StopReason::kNone ? StopCategory::kNone : category;
  state.at_rest = at_rest;
  return state;
}

ServoState fullState(int i) {
  ServoState state = cycleAt(0.001 * i, StopReason::kForce);
  robot::Joints values = robot::Joints::Constant(7, 0.1234567890123 * (1 + i));
  state.measured.q_rad = state.measured.v_rad_s = state.measured.external_torque_nm = values;
  state.commanded = {values, values, values};
  state.sent = {values, values, values};
  return state;
}

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST(StopLog, KeepsTheBoxOnceTheRobotRests) {
  StopLog log;
  EXPECT_FALSE(log.update(cycleAt(0.0, StopReason::kNone)).begun);
  const StopNews begun = log.update(cycleAt(0.1, StopReason::kTargetLost, true));
  EXPECT_TRUE(begun.begun);
  EXPECT_FALSE(begun.box_due);
  EXPECT_EQ(log.unkept(), StopReason::kTargetLost);
  EXPECT_FALSE(log.update(cycleAt(0.2, StopReason::kTargetLost)).box_due);
  const StopNews rest = log.update(cycleAt(0.4, StopReason::kTargetLost, true));
  EXPECT_TRUE(rest.box_due);
  EXPECT_EQ(rest.reason, StopReason::kTargetLost);
  EXPECT_FALSE(log.unkept());
  EXPECT_FALSE(log.update(cycleAt(0.5, StopReason::kTargetLost, true)).box_due) << "once";
  const StopNews ended = log.update(cycleAt(0.6, StopReason::kNone, true));
  EXPECT_TRUE(ended.ended);
  EXPECT_FALSE(ended.box_due);
}

TEST(StopLog, WaitsForRestNoLongerThanASecondAndTellsOfGraverStops) {
  StopLog log;
  static_cast<void>(log.update(cycleAt(0.0, StopReason::kOperator)));
  EXPECT_FALSE(log.update(cycleAt(0.99, StopReason::kOperator)).box_due);
  const StopNews news = log.update(cycleAt(1.01, StopReason::kOperator, false, StopCategory::kOne));
  EXPECT_TRUE(news.box_due);
  EXPECT_TRUE(news.graver);
}

TEST(BlackBox, HasARowACycleAndACellAColumn) {
  const test::ScratchFolder folder;
  std::vector<ServoState> states;
  for (int i = 0; i < 10240; ++i) states.push_back(fullState(i));
  states.front() = cycleAt(0.0, StopReason::kNone);  // before the robot answered
  const auto file = blackBoxFile(folder.path(), StopReason::kForce);
  ASSERT_TRUE(writeBlackBox(file, states));
  const auto lines = linesOf(file);
  ASSERT_EQ(lines.size(), states.size() + 1);
  const auto columns = std::count(lines[0].begin(), lines[0].end(), ',');
  for (const auto& line : lines) ASSERT_EQ(std::count(line.begin(), line.end(), ','), columns);
  EXPECT_NE(lines.back().find("force,2,"), std::string::npos);
  EXPECT_NE(lines.back().find("1264.19"), std::string::npos);
}

TEST(BlackBox, NamesTheJointOrTheContactOfTheGuard) {
  const test::ScratchFolder folder;
  std::vector<ServoState> states(3, fullState(0));
  states[0].guard_joint = 3;
  states[1].guard_contact = {robot::ArmPart::kSling, robot::ObstacleKind::kHead};
  states[2].guard_contact = {robot::ArmPart::kCameraBar, std::nullopt};
  const auto file = blackBoxFile(folder.path(), StopReason::kForce);
  ASSERT_TRUE(writeBlackBox(file, states));
  const auto lines = linesOf(file);
  EXPECT_NE(lines[0].find(",guard_joint,guard_part,guard_thing,"), std::string::npos);
  EXPECT_NE(lines[1].find(",4,,,"), std::string::npos);
  EXPECT_NE(lines[2].find(",,sling,head,"), std::string::npos);
  EXPECT_NE(lines[3].find(",,camera_bar,arm,"), std::string::npos);
}

TEST(BlackBox, TwoStopsOfOneMomentHaveTwoFiles) {
  const test::ScratchFolder folder;
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE(writeBlackBox(blackBoxFile(folder.path(), StopReason::kOperator), {}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
}

TEST(BlackBox, IsWrittenWholeOrNotAtAll) {
  const test::ScratchFolder folder;
  const std::vector<ServoState> states(100, fullState(1));
  std::ofstream(folder.path() / "occupied") << "a file";
  const auto written = writeBlackBox(folder.path() / "occupied" / "box.csv", states);
  ASSERT_FALSE(written);
  EXPECT_FALSE(written.error().empty());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace mirrorarm::station
