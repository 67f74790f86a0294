#include <gtest/gtest.h>

#include "core/calibration/clock_file.h"
#include "core/calibration/drift_file.h"
#include "tests/calibration/fuzz.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

ClockRecord clockExample() {
  return {-0.0123, 0.0002, "2026-01-31T09:05:00Z", "robot \"left\" and camera", 0.97, 412, 0.0011, 0.002};
}

DriftRecord driftExample() {
  DriftRecord record;
  record.date = "2026-01-31T09:05:00Z";
  record.findings.epipolar_px = 0.11;
  record.findings.reprojection_px = 0.08;
  record.findings.length_percent = -0.12;
  record.findings.points = 54;
  record.findings.grid = DriftFindings::Grid{Eigen::Vector3d(0.1, 0.2, 0.3), -0.2, 48};
  record.findings.verdict = DriftVerdict::kDoubtful;
  return record;
}

TEST(ClockFile, ComesBackAsWritten) {
  const test::ScratchFolder folder;
  const auto written = clockExample();
  ASSERT_TRUE(writeClockRecord(folder / "clock.yaml", written));
  const auto read = readClockRecord(folder / "clock.yaml");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_DOUBLE_EQ(read->offset_s, written.offset_s);
  EXPECT_DOUBLE_EQ(read->sigma_s, written.sigma_s);
  EXPECT_EQ(read->date, written.date);
  EXPECT_EQ(read->note, written.note);
  EXPECT_DOUBLE_EQ(read->correlation, written.correlation);
  EXPECT_EQ(read->poses, written.poses);
  EXPECT_NEAR(read->median_m, written.median_m, 1e-12);
  EXPECT_NEAR(read->median_rad, written.median_rad, 1e-12);
}

std::string clockRefusal(const std::string& text) {
  const test::ScratchFolder folder;
  writeText(folder / "clock.yaml", "format: mirrorarm/clock/1\n" + text);
  const auto read = readClockRecord(folder / "clock.yaml");
  return read ? "" : std::to_string(read.error().line) + ": " + read.error().reason;
}

TEST(ClockFile, RefusalsNameTheLineAndKey) {
  EXPECT_EQ(clockRefusal("offset_s: 0.1\nsigma_s: -1\n"), "3: sigma_s is negative");
  EXPECT_EQ(clockRefusal("offset_s: soon\nsigma_s: 0\n"), "2: offset_s is not a finite number");
  EXPECT_EQ(clockRefusal("offset_s: 0\nsigma_s: 0\ncalibration: {correlation: 1.5}\n"),
            "4: calibration.correlation is above 1");
  EXPECT_NE(clockRefusal("offset_s: 0\n"), "");
  EXPECT_NE(clockRefusal("offset_s: 0\nsigma_s: 0\ncolour: red\n"), "");
  EXPECT_EQ(clockRefusal("offset_s: 0\nsigma_s: 0\n"), "");
  EXPECT_FALSE(readClockRecord("/nowhere/clock.yaml"));
}

TEST(DriftFile, ComesBackAsWritten) {
  const test::ScratchFolder folder;
  for (const bool has_grid : {true, false}) {
    auto written = driftExample();
    if (!has_grid) written.findings.grid.reset();
    ASSERT_TRUE(writeDriftRecord(folder / "drift.yaml", written));
    const auto read = readDriftRecord(folder / "drift.yaml");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->date, written.date);
    EXPECT_EQ(read->findings.verdict, written.findings.verdict);
    EXPECT_DOUBLE_EQ(read->findings.epipolar_px, written.findings.epipolar_px);
    EXPECT_DOUBLE_EQ(read->findings.reprojection_px, written.findings.reprojection_px);
    EXPECT_DOUBLE_EQ(read->findings.length_percent, written.findings.length_percent);
    EXPECT_EQ(read->findings.points, written.findings.points);
    ASSERT_EQ(read->findings.grid.has_value(), has_grid);
    if (!has_grid) continue;
    EXPECT_EQ(read->findings.grid->std_mm, written.findings.grid->std_mm);
    EXPECT_DOUBLE_EQ(read->findings.grid->scale_percent, written.findings.grid->scale_percent);
    EXPECT_EQ(read->findings.grid->stations, written.findings.grid->stations);
  }
}

std::string driftRefusal(const std::string& text) {
  const test::ScratchFolder folder;
  writeText(folder / "drift.yaml", "format: mirrorarm/drift/1\n" + text);
  const auto read = readDriftRecord(folder / "drift.yaml");
  return read ? "" : std::to_string(read.error().line) + ": " + read.error().reason;
}

TEST(DriftFile, RefusalsNameTheLineAndKey) {
  const std::string figures =
      "date: today\nepipolar_px: 0.1\nreprojection_px: 0.1\nlength_percent: 0\npoints: 54\n";
  EXPECT_EQ(driftRefusal(figures + "verdict: perfect\n"), "7: verdict is none of holds, doubtful, failed");
  EXPECT_EQ(
      driftRefusal(figures + "verdict: holds\ngrid: {std_mm: [0, -1, 0], scale_percent: 0, stations: 3}\n"),
      "8: grid.std_mm is negative");
  EXPECT_NE(driftRefusal(figures), "");
  EXPECT_NE(driftRefusal(figures + "verdict: holds\nmood: good\n"), "");
  EXPECT_EQ(driftRefusal(figures + "verdict: holds\n"), "");
  EXPECT_FALSE(readDriftRecord("/nowhere/drift.yaml"));
}

TEST(RecordFiles, DamagedFilesNeverCrash) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(writeClockRecord(folder / "clock.yaml", clockExample()));
  fuzz(folder / "clock.yaml", 150, [](const auto& file) {
    const auto read = readClockRecord(file);
    EXPECT_TRUE(!read || read->sigma_s >= 0.0);
  });
  ASSERT_TRUE(writeDriftRecord(folder / "drift.yaml", driftExample()));
  fuzz(folder / "drift.yaml", 150, [](const auto& file) {
    const auto read = readDriftRecord(file);
    EXPECT_TRUE(!read || read->findings.epipolar_px >= 0.0);
  });
}

}  // namespace
}  // namespace mirrorarm::calibration
