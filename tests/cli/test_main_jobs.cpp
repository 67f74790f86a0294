#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/common/csv.h"
#include "core/geometry/rigid_transform.h"
#include "program.h"

// The main jobs on real input, through the program itself.
namespace mirrorarm::cli {
namespace {

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << (path) << " is absent"

TEST(MainJobs, ARecordedArmIsTrackedFollowedAndRecorded) {
  const auto trc = shared("pyomeca-upper-limb/markers.trc");
  SKIP_WITHOUT(trc);
  const test::ScratchFolder scratch;
  const auto done = run("session --fast --seconds 12 --motion " + trc.string() + " --json --out " +
                        (scratch / "session").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto result = done.json();
  EXPECT_GT(result["frames"], 250);
  EXPECT_GE(result["tracked_share"], 0.95);
  EXPECT_LT(result["pose_error_mm"]["rms"], 1.0);
  EXPECT_LE(result["joint_speed_ratio"], 1.0 + 1e-9);
  EXPECT_LE(result["joint_acceleration_ratio"], 1.0 + 1e-9);
  EXPECT_GT(result["lag_ms"], 0.0);
  for (const char* file : {"store.sqlite", "session.json", "poses.csv", "robot.csv"})
    EXPECT_TRUE(std::filesystem::exists(scratch / "session" / file)) << file;
  EXPECT_TRUE(CsvTable::read(scratch / "session/poses.csv"));
  EXPECT_TRUE(CsvTable::read(scratch / "session/robot.csv"));
}

RigidTransform poseIn(const CsvTable& table, const CsvRow& row) {
  constexpr std::array<std::string_view, 7> names{"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"};
  const auto columns = table.columns(names).value();
  const auto at = [&](std::size_t i) { return table.number(row, columns[i]).value(); };
  return makeTransform(Eigen::Quaterniond(at(6), at(3), at(4), at(5)), Eigen::Vector3d(at(0), at(1), at(2)));
}

/// Root mean square distance of tracked and true target origin over all rows [mm].
double poseRms_mm(const std::filesystem::path& poses_file, const std::filesystem::path& truth_file) {
  const auto poses = CsvTable::read(poses_file).value();
  const auto truth = CsvTable::read(truth_file).value();
  EXPECT_EQ(poses.rows().size(), truth.rows().size());
  double sum = 0.0;
  for (std::size_t i = 0; i < poses.rows().size(); ++i)
    sum += (poseIn(poses, poses.rows()[i]).translation() - poseIn(truth, truth.rows()[i]).translation())
               .squaredNorm();
  return 1e3 * std::sqrt(sum / static_cast<double>(poses.rows().size()));
}

TEST(MainJobs, ThePapersCuboidIsTrackedToATwentiethOfAMillimetre) {
  const test::ScratchFolder scratch;
  const auto recording = scratch / "cuboid", poses = scratch / "poses.csv";
  const auto scene = std::filesystem::path(RESOURCES) / "scenes/paper_cuboid.yaml";
  const auto simulated = run("simulate " + scene.string() + " --out " + recording.string());
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  const auto tracked = run("track " + recording.string() + " --target " +
                           (recording / "target.yaml").string() + " --json --out " + poses.string());
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  EXPECT_EQ(tracked.json()["tracked_share"], 1.0);
  EXPECT_LE(poseRms_mm(poses, recording / "truth.csv"), 0.05);
}

TEST(MainJobs, AChessboardCalibratesAStereoRig) {
  const auto data = shared("opencv-chess-stereo");
  SKIP_WITHOUT(data);
  const test::ScratchFolder scratch;
  std::filesystem::create_directories(scratch / "left");
  std::filesystem::create_directories(scratch / "right");
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    if (entry.path().extension() != ".jpg") continue;
    const auto name = entry.path().filename().string();
    const auto side = name.starts_with("left") ? "left" : "right";
    std::filesystem::create_symlink(std::filesystem::absolute(entry.path()), scratch / side / name);
  }
  const auto rig = scratch / "rig.yaml";
  const std::string call = "calibrate stereo " + (scratch / "left").string() + " " +
                           (scratch / "right").string() +
                           " --board chessboard:9x6:0.025 --model brown_conrady --json --out " + rig.string();
  const auto all = run(call);
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_LE(all.json()["rms_px"], 0.23);
  EXPECT_TRUE(std::filesystem::exists(rig));
  const auto held_out = run(call + " --hold-out 2");
  ASSERT_EQ(held_out.exit_code, 0) << held_out.err;
  EXPECT_LE(held_out.json()["hold_out"]["epipolar_px"], 0.25);
}

/// A bright disc of `radius_px` in the middle of a dark image, its edge a pixel wide.
std::string discImage(int width, int height, double radius_px) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double inside = radius_px - std::hypot(x - 0.5 * width, y - 0.5 * height);
      const auto grey = static_cast<unsigned char>(20.0 + 180.0 * std::clamp(inside + 0.5, 0.0, 1.0));
      bytes += static_cast<char>(grey);
    }
  return bytes;
}

TEST(MainJobs, EveryMethodFindsADiscInImagesOfAnySize) {
  const test::ScratchFolder scratch;
  const auto images = scratch.holding("wide.pgm", discImage(120, 81, 6.0)).string() + " " +
                      scratch.holding("high.pgm", discImage(63, 140, 5.0)).string() + " " +
                      scratch.holding("dot.pgm", discImage(1, 1, 5.0)).string();
  for (const std::string method : {"maximum_likelihood", "dual_conic", "lindeberg_fitzgibbon"}) {
    const auto done = run("detect " + images + " --json --method " + method + " --out " +
                          (scratch / "centres.csv").string());
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const auto result = done.json();
    EXPECT_EQ(result["method"], method);
    EXPECT_EQ(result["images"], 3);
    EXPECT_EQ(result["discs"], 2) << method;
    EXPECT_EQ(result["cut"], 0) << method;
    ASSERT_EQ(result["exposure"].size(), 3U);
    const auto& wide = result["exposure"][0];
    EXPECT_EQ(wide["camera"], "wide.pgm");
    EXPECT_TRUE(wide["warning"].is_null() || wide["warning"].is_string());
    for (const char* key : {"background", "noise", "brightest", "saturated_markers"})
      EXPECT_TRUE(wide[key].is_number()) << key;
  }
}

TEST(MainJobs, AllDotsOfSixPlateImagesAreFound) {
  const auto data = shared("ucl-dots-metal");
  SKIP_WITHOUT(data);
  const test::ScratchFolder scratch;
  const auto done = run("detect --dark " + (data / "14_1*/*.png").string() + " --json --out " +
                        (scratch / "centres.csv").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.json()["images"], 6);
  EXPECT_EQ(done.json()["discs"], 6 * 14 * 16);
}

TEST(MainJobs, DoctorSpeaksJson) {
  const auto done = run("doctor --json");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_TRUE(done.json().is_object());
}

TEST(MainJobs, DoctorTellsTheCalibrationsInForce) {
  const test::ScratchFolder scratch;
  const auto none = run("doctor --json --calibrations " + scratch.path().string());
  ASSERT_EQ(none.exit_code, 0) << none.err;
  const auto result = none.json()["calibrations"];
  EXPECT_EQ(result["session_allowed"], false);
  for (const char* kind : {"rig", "hand_eye", "clock", "drift"})
    EXPECT_EQ(result[kind]["standing"], "missing");
  const auto broken = scratch.holding("in_force.yaml", "format: mirrorarm/in-force/1\nrig: \"gone\"\n");
  const auto refused = run("doctor --json --calibrations " + scratch.path().string());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("gone"), std::string::npos) << refused.err;
}

TEST(MainJobs, TwoRealClocksAreBroughtTogether) {
  const auto folder = shared("ethz-handeye");
  SKIP_WITHOUT(folder);
  const test::ScratchFolder scratch;
  const auto done = run("calibrate clock " + (folder / "2017-04-09-18-13-10_vicon_prime_sense.csv").string() +
                        " " + (folder / "2017-04-09-18-13-10_W_camera_rgb_image_raw.csv").string() +
                        " --json --out " + (scratch / "clock.yaml").string());
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const auto result = done.json();
  EXPECT_NEAR(result["offset_ms"], 40.0, 10.0);
  EXPECT_LE(result["residual_mm"], 9.0);
  EXPECT_LE(result["residual_deg"], 1.2);
  EXPECT_TRUE(std::filesystem::exists(scratch / "clock.yaml"));
}

TEST(MainJobs, ABoardOfAnotherSizeIsRefusedByName) {
  const auto folder = shared("opencv-chess-stereo");
  SKIP_WITHOUT(folder);
  const test::ScratchFolder scratch;
  const auto out = scratch / "rig.yaml";
  const auto done = run("calibrate stereo " + folder.string() + " " + folder.string() +
                        " --board chessboard:7x6:0.025 --out " + out.string());
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_NE(done.err.find("beyond 7x6"), std::string::npos) << done.err;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(MainJobs, EveryCommandShowsAnExample) {
  for (const std::string command :
       {"session", "simulate", "detect", "track", "teach", "calibrate stereo", "calibrate mono",
        "calibrate hand-eye", "calibrate clock", "doctor", "experiment accuracy", "experiment occlusion",
        "experiment timing", "listen", "serve robot", "serve tracking", "target check", "arm"}) {
    const auto help = run(command + " --help");
    EXPECT_EQ(help.exit_code, 0) << command;
    EXPECT_NE(help.out.find("Example:"), std::string::npos) << command;
    EXPECT_NE(help.out.find("--json"), std::string::npos) << command;
  }
}

}  // namespace
}  // namespace mirrorarm::cli
