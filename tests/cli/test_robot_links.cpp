#include <algorithm>

#include <gtest/gtest.h>

#include "background.h"
#include "core/common/csv.h"
#include "core/devices/udp_socket.h"
#include "core/records/store.h"
#include "program.h"

// Sessions whose robot is another program: the bench's world rides on what it measures.
namespace mirrorarm::cli {
namespace {

/// Cycles of 10 ms, so that a busy machine loses none of them.
struct Fri {
  std::string port = std::to_string(devices::UdpSocket::open("127.0.0.1", 0).value().port());
  std::string controller =
      std::string(MIRRORARM_FRI_CONTROLLER) + " --period-ms 10 --port " + port + " --json";
  std::string robot = " --robot fri:" + port + " --fri-period-ms 10";
};

/// How far the joint that moved most has moved [rad].
double travel(const std::filesystem::path& robot_file) {
  const auto table = CsvTable::read(robot_file).value();
  double longest = 0.0;
  for (const std::string_view name : {"q1", "q2", "q3", "q4", "q5", "q6", "q7"}) {
    const auto column = table.columns(std::array{name}).value()[0];
    double least = 1e9, most = -1e9;
    for (const auto& row : table.rows()) {
      const double q = table.number(row, column).value();
      least = std::min(least, q);
      most = std::max(most, q);
    }
    longest = std::max(longest, most - least);
  }
  return longest;
}

void expectFollowed(const Run& done, const std::filesystem::path& folder) {
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto result = done.json();
  EXPECT_EQ(result["stops"], 0) << done.err;
  EXPECT_GE(result["tracked_share"], 0.95);
  EXPECT_LT(result["pose_error_mm"]["rms"], 1.0);
  EXPECT_LE(result["joint_speed_ratio"], 1.0 + 1e-9);
  EXPECT_GT(travel(folder / "robot.csv"), 0.1);
}

TEST(RobotLinks, ASessionFollowsWithARobotOverFri) {
  const test::ScratchFolder scratch;
  const Fri fri;
  Background controller(fri.controller);
  expectFollowed(run("session --seconds 5 --json --out " + scratch.path().string() + fri.robot),
                 scratch.path());
  EXPECT_EQ(controller.end(), 0) << controller.err();
  const auto told = nlohmann::json::parse(controller.out());
  EXPECT_EQ(told["starts"], 1);
  EXPECT_EQ(told["mirror_errors"], 0);
}

TEST(RobotLinks, ASessionFollowsWithARobotOfAnotherHost) {
  const test::ScratchFolder scratch;
  Background host(std::string(MIRRORARM_CLI) + " serve robot --allow-motion --port 0 --json");
  ASSERT_TRUE(host.says("on port ")) << host.err();
  const auto err = host.err();
  const int port = std::stoi(err.substr(err.find("on port ") + 8));
  expectFollowed(run("session --seconds 5 --json --out " + scratch.path().string() +
                     " --robot igtl:127.0.0.1:" + std::to_string(port)),
                 scratch.path());
  EXPECT_EQ(host.end(), 0) << host.err();
  const auto told = nlohmann::json::parse(host.out());
  EXPECT_EQ(told["stops"], 0);
  EXPECT_GT(told["commands"], 500);
}

TEST(RobotLinks, AControllerThatDiesEndsTheSessionWithItsReason) {
  const test::ScratchFolder scratch;
  const Fri fri;
  Background controller(fri.controller);
  std::jthread killer([&] {
    std::this_thread::sleep_for(std::chrono::seconds(6));
    controller.end(SIGKILL);
  });
  const auto done = run("session --seconds 10 --json --out " + scratch.path().string() + fri.robot);
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("the session ended early: stop.robot_silent"), std::string::npos) << done.err;
  EXPECT_TRUE(done.out.empty()) << done.out;

  const auto store = records::Store::openExisting(scratch / "store.sqlite");
  ASSERT_TRUE(store) << store.error().reason;
  const auto session = (*store)->session(1);
  ASSERT_TRUE(session);
  EXPECT_FALSE(session->ended_at.empty());
  EXPECT_EQ(session->end_reason, "stop.robot_silent");
  int boxes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    const auto name = entry.path().filename().string();
    boxes += name.starts_with("stop-") && name.ends_with("-robot_silent.csv") ? 1 : 0;
  }
  EXPECT_EQ(boxes, 1);
}

TEST(RobotLinks, ARobotThatStandsElsewhereIsNotMoved) {
  const test::ScratchFolder scratch;
  const Fri fri;
  Background controller(fri.controller + " --start 0,45,0,-60,0,60,0");
  const auto out = scratch / "session";
  const auto done = run("session --seconds 5 --json --out " + out.string() + fri.robot);
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_EQ(done.lines(), 1) << done.err;
  EXPECT_NE(done.err.find("joint 4 is at -60.0 degrees"), std::string::npos) << done.err;
  EXPECT_FALSE(std::filesystem::exists(out));
  controller.end();
  EXPECT_EQ(nlohmann::json::parse(controller.out())["starts"], 0);
}

}  // namespace
}  // namespace mirrorarm::cli
