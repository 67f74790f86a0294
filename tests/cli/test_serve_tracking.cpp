#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "background.h"
#include "core/common/csv.h"
#include "core/tracking/target_file.h"
#include "program.h"
#include "tests/tracking/synthetic_arm.h"

// The tracking host of the paper and its client, through the program itself.
namespace mirrorarm::cli {
namespace {

using tracking::test::forearm;

struct Heard {
  double time_s = 0.0;
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
};

std::vector<Heard> rowsOf(const std::filesystem::path& file, std::string_view time, double unit_s) {
  const auto table = CsvTable::read(file).value();
  const auto columns = table.columns(std::array<std::string_view, 4>{time, "tx_m", "ty_m", "tz_m"}).value();
  std::vector<Heard> rows;
  for (const auto& row : table.rows()) {
    const auto at = [&](std::size_t i) { return table.number(row, columns[i]); };
    if (!at(1)) continue;  // lost
    rows.push_back({unit_s * at(0).value(), {at(1).value(), at(2).value(), at(3).value()}});
  }
  return rows;
}

class ServeTracking : public testing::Test {
 protected:
  /// 25 Hz for 4 s; the forearm is away from 0.4 to 1.2 s.
  void SetUp() override {
    ASSERT_TRUE(tracking::writeTarget(folder_ / "forearm.yaml", forearm()));
    std::ofstream out(folder_ / "clouds.csv");
    out.precision(9);
    out << "index,time_ns,x_m,y_m,z_m\n";
    for (int i = 0; i < 100; ++i) {
      out << i << ',' << i * 40'000'000LL << ",0.3,0.3,0.9\n";
      if (i >= 10 && i < 30) continue;
      for (const auto& marker_T : forearm().markers_T)
        out << i << ',' << i * 40'000'000LL << ',' << marker_T.x() + 0.002 * i << ',' << marker_T.y() << ','
            << marker_T.z() + 0.4 << '\n';
    }
  }
  [[nodiscard]] std::string host(const std::string& more) const {
    return std::string(MIRRORARM_CLI) + " serve tracking --clouds " + (folder_ / "clouds.csv").string() +
           " --target " + (folder_ / "forearm.yaml").string() + " --port 0 --json " + more;
  }
  static std::string address(const Background& host) {
    EXPECT_TRUE(host.says("on port ")) << host.err();
    const auto err = host.err();
    return "127.0.0.1:" + std::to_string(std::stoi(err.substr(err.find("on port ") + 8)));
  }
  [[nodiscard]] cli::Run listen(const Background& host) const {
    return run("listen " + address(host) + " --seconds 2.5 --json --out " + (folder_ / "heard.csv").string());
  }
  test::ScratchFolder folder_;
};

TEST_F(ServeTracking, WhatIsToldIsHeard) {
  const auto tracked =
      run("track --clouds " + (folder_ / "clouds.csv").string() + " --target " +
          (folder_ / "forearm.yaml").string() + " --out " + (folder_ / "poses.csv").string());
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  Background serving(host(""));
  const auto done = listen(serving);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto told = done.json()["told"];
  EXPECT_GE(told["tracked"], 30);
  EXPECT_GE(told["lost"], 10) << done.out;
  EXPECT_EQ(done.json()["poses"], told["tracked"].get<int>() + told["predicted"].get<int>());

  const auto heard = rowsOf(folder_ / "heard.csv", "time_s", 1.0);
  const auto wanted = rowsOf(folder_ / "poses.csv", "time_ns", 1e-9);
  ASSERT_LE(heard.size(), wanted.size());
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_LT((heard[i].p_m - wanted[i].p_m).norm(), 1e-6) << i;
    EXPECT_NEAR(heard[i].time_s - heard[0].time_s, wanted[i].time_s - wanted[0].time_s, 1e-5) << i;
  }
  serving.end();
  EXPECT_EQ(nlohmann::json::parse(serving.out())["callers"], 1);
}

TEST_F(ServeTracking, StrangersHearNothing) {
  Background serving(host("--allow 127.0.0.2"));
  EXPECT_EQ(listen(serving).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "heard.csv"));
  EXPECT_EQ(serving.end(), 0) << serving.err();
  const auto told = nlohmann::json::parse(serving.out());
  EXPECT_EQ(told["turned_away"], 1);
  EXPECT_EQ(told["frames"], 0);
}

TEST_F(ServeTracking, TheSimulatedBenchIsServedLive) {
  Background serving(std::string(MIRRORARM_CLI) + " serve tracking --port 0 --json");
  ASSERT_TRUE(serving.says("on port ")) << serving.err();
  const auto done = listen(serving);
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_GE(done.json()["told"]["tracked"], 20);
  const auto heard = rowsOf(folder_ / "heard.csv", "time_s", 1.0);
  for (const auto& row : heard) EXPECT_NEAR(row.p_m.z(), 0.4, 0.15);
}

TEST_F(ServeTracking, NamesThatTheProtocolCannotTellAreRefused) {
  auto target = forearm();
  target.name = "the forearm of the healthy side";
  ASSERT_TRUE(tracking::writeTarget(folder_ / "forearm.yaml", target));
  Background serving(host(""));
  EXPECT_TRUE(serving.says("1 to 20 plain characters")) << serving.err();
}

}  // namespace
}  // namespace mirrorarm::cli
