#include <gtest/gtest.h>

#include "core/calibration/hand_eye_file.h"
#include "core/calibration/pose_pairs.h"
#include "tests/calibration/fuzz.h"
#include "tests/calibration/stations.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

constexpr auto kHeader = "bx_m,by_m,bz_m,bqx,bqy,bqz,bqw,cx_m,cy_m,cz_m,cqx,cqy,cqz,cqw\n";

TEST(PosePairs, ComeBackAsWritten) {
  const test::ScratchFolder folder;
  StationMaker maker;
  const auto stations = maker.stations(4);
  ASSERT_TRUE(writePosePairs(folder / "pairs.csv", stations));
  const auto read = readPosePairs(folder / "pairs.csv");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE((*read)[i].X_BF.isApprox(stations[i].X_BF, 1e-12));
    EXPECT_TRUE((*read)[i].X_CM.isApprox(stations[i].X_CM, 1e-12));
  }
}

std::string refusalOf(const std::string& text) {
  const test::ScratchFolder folder;
  writeText(folder / "pairs.csv", text);
  const auto read = readPosePairs(folder / "pairs.csv");
  return read ? "" : std::to_string(read.error().line) + ": " + read.error().reason;
}

TEST(PosePairs, RefusalsNameTheLine) {
  const std::string header = kHeader;
  EXPECT_EQ(refusalOf(header + "0,0,0,0,0,0,1,0,0,0,0,0,0,1\n0,0,0,0,0,0,2,0,0,0,0,0,0,1\n"),
            "3: the quaternion from bqx on is not of unit norm");
  EXPECT_EQ(refusalOf(header + "0,0,0,0,0,0,1,0,0,0,0,0,0,0\n"),
            "2: the quaternion from cqx on is not of unit norm");
  EXPECT_EQ(refusalOf(header + "0,0,nan,0,0,0,1,0,0,0,0,0,0,1\n"), "2: bz_m is not a finite number: 'nan'");
  EXPECT_EQ(refusalOf("bx_m,by_m\n1,2\n"), "1: has no column bz_m");
  EXPECT_EQ(refusalOf("bx_m,weight\n1,2\n"), "1: column 'weight' is unknown");
  EXPECT_FALSE(readPosePairs("/nowhere/pairs.csv"));
}

TEST(PosePairs, DamagedFilesNeverCrash) {
  const test::ScratchFolder folder;
  StationMaker maker;
  ASSERT_TRUE(writePosePairs(folder / "pairs.csv", maker.stations(3)));
  fuzz(folder / "pairs.csv", 300, [](const auto& file) {
    const auto read = readPosePairs(file);
    if (!read) return;
    for (const auto& pair : *read) EXPECT_TRUE(isRigid(pair.X_BF) && isRigid(pair.X_CM));
  });
}

HandEye example(CameraMount mount) {
  HandEye hand_eye;
  hand_eye.mount = mount;
  hand_eye.X_PC = StationMaker().X_FC;
  hand_eye.calibration = {"2026-01-31T09:05:00Z", "tsai-lenz (visp)", 14, 0.0005, 0.001, 0.0002};
  return hand_eye;
}

TEST(HandEyeFile, ComesBackAsWritten) {
  const test::ScratchFolder folder;
  for (const auto mount : {CameraMount::kInHand, CameraMount::kToHand}) {
    const auto written = example(mount);
    ASSERT_TRUE(writeHandEye(folder / "hand_eye.yaml", written));
    const auto read = readHandEye(folder / "hand_eye.yaml");
    ASSERT_TRUE(read) << read.error().reason;
    EXPECT_EQ(read->mount, mount);
    EXPECT_TRUE(read->X_PC.isApprox(written.X_PC, 1e-12));
    EXPECT_EQ(read->calibration.date, written.calibration.date);
    EXPECT_EQ(read->calibration.method, written.calibration.method);
    EXPECT_EQ(read->calibration.pairs, 14);
    EXPECT_NEAR(read->calibration.rms_rad, 0.001, 1e-12);
    EXPECT_NEAR(read->calibration.sigma_m.value(), 0.0002, 1e-12);
  }
}

TEST(HandEyeFile, ReadsTheShortestForm) {
  const test::ScratchFolder folder;
  writeText(folder / "h.yaml",
            "format: mirrorarm/hand-eye/1\n"
            "flange_from_camera: {translation_m: [0.1, 0, 0], rotation_xyzw: [0, 0, 0, 1]}\n");
  const auto read = readHandEye(folder / "h.yaml");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->mount, CameraMount::kInHand);
  EXPECT_DOUBLE_EQ(read->X_PC.translation().x(), 0.1);
  EXPECT_FALSE(read->calibration.sigma_m);
}

TEST(HandEyeFile, Refuses) {
  const test::ScratchFolder folder;
  const std::string format = "format: mirrorarm/hand-eye/1\n";
  const std::string pose = "_from_camera: {translation_m: [0, 0, 0], rotation_xyzw: [0, 0, 0, 1]}\n";
  for (const std::string& text :
       {std::string("format: mirrorarm/hand-eye/2\n"), format, format + "flange" + pose + "base" + pose,
        format + "flange_from_camera: {translation_m: [0, 0], rotation_xyzw: [0, 0, 0, 1]}\n",
        format + "flange_from_camera: {translation_m: [0, 0, 0], rotation_xyzw: [0, 0, 0, 2]}\n",
        format + "flange" + pose + "colour: red\n"}) {
    writeText(folder / "h.yaml", text);
    EXPECT_FALSE(readHandEye(folder / "h.yaml")) << text;
  }
}

TEST(HandEyeFile, DamagedFilesNeverCrash) {
  const test::ScratchFolder folder;
  ASSERT_TRUE(writeHandEye(folder / "h.yaml", example(CameraMount::kInHand)));
  fuzz(folder / "h.yaml", 300, [](const auto& file) {
    const auto read = readHandEye(file);
    EXPECT_TRUE(!read || isRigid(read->X_PC));
  });
}

}  // namespace
}  // namespace mirrorarm::calibration
