#include <fstream>
#include <random>
#include <sstream>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/camera/rig_file.h"

namespace mirrorarm::camera {
namespace {

const std::string kRig =
    "format: mirrorarm/rig/1\n"
    "image_size_px: [1296, 964]\n"
    "left:\n"
    "  model: brown_conrady\n"
    "  fx_px: 720.9\n"
    "  fy_px: 719.4\n"
    "  cx_px: 651.7\n"
    "  cy_px: 478.3\n"
    "  distortion: [-0.21, 0.045]\n"
    "right:\n"
    "  model: kannala_brandt\n"
    "  fx_px: 551.2\n"
    "  fy_px: 550.7\n"
    "  cx_px: 640.1\n"
    "  cy_px: 490.4\n"
    "  distortion: [-0.03, 0.004, -0.003, 0.0004]\n"
    "right_from_left:\n"
    "  rotation_xyzw: [0.001, -0.02, 0.003, 0.9997950]\n"
    "  translation_m: [-0.12, 0.0003, 0.001]\n"
    "calibration: {date: 2024-03-01, method: chessboard, rms_px: 0.21, operator: A}\n";

class RigFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  FromFile<StereoRig> readWith(const std::string& from, const std::string& to) {
    auto text = kRig;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return readRig(write(text.replace(at, from.size(), to)));
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("mirrorarm_rig_" + std::to_string(::getpid()) + ".yaml");
};

TEST_F(RigFile, IsRead) {
  const auto rig = readRig(write(kRig));
  ASSERT_TRUE(rig) << describe(rig.error());
  EXPECT_EQ(rig->left.intrinsics().distortion[1], 0.045);
  EXPECT_EQ(rig->right.intrinsics().model, LensModel::kKannalaBrandt);
  EXPECT_EQ(rig->right.intrinsics().width_px, 1296);
  EXPECT_NEAR(rig->X_RC.translation().x(), -0.12, 1e-15);
  EXPECT_TRUE(isRigid(rig->X_RC, 1e-12));
  EXPECT_EQ(rig->calibration.method, "chessboard");
  EXPECT_EQ(rig->calibration.rms_px, 0.21);
}

TEST_F(RigFile, ComesBackAsWritten) {
  auto rig = *readRig(write(kRig));
  rig.calibration.left_serial = "02-2142 \"A\" \\";
  ASSERT_TRUE(writeRig(file_, rig));
  const auto back = readRig(file_);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(back->left.intrinsics().fx_px, rig.left.intrinsics().fx_px);
  EXPECT_EQ(back->right.intrinsics().distortion, rig.right.intrinsics().distortion);
  EXPECT_LT((back->X_RC.matrix() - rig.X_RC.matrix()).norm(), 1e-14);
  EXPECT_EQ(back->calibration.left_serial, rig.calibration.left_serial);
  EXPECT_EQ(back->calibration.date, "2024-03-01");
}

TEST_F(RigFile, TheWholeRecordComesBack) {
  auto rig = *readRig(write(kRig));
  auto& note = rig.calibration;
  note.software = "mirrorarm 1";
  note.board = "dots:9x7:0.03";
  note.images = {"left 1.png", "left\\2 \"x\".png"};
  note.held_out = {"left3.png"};
  note.outliers = {"left4.png"};
  note.hold_out_method = "cross-validation in 3 parts";
  note.hold_out_px = 0.02;
  note.square_mean_percent = -0.01;
  note.square_std_percent = 0.05;
  note.depth_rms_m = 4e-5;
  note.lens_sigma[0] = {0.1, 0.2, 0.3, 0.4, {1e-4, 2e-5, 0.0, 0.0, 0.0}};
  note.lens_sigma[1].fx_px = 0.5;
  note.bar_sigma << 1e-5, 2e-5, 3e-5, 4e-6, 5e-6, 6e-6;
  ASSERT_TRUE(writeRig(file_, rig));
  const auto read = readRig(file_);
  ASSERT_TRUE(read) << describe(read.error());
  const auto& back = read->calibration;
  EXPECT_EQ(back.software, note.software);
  EXPECT_EQ(back.board, note.board);
  EXPECT_EQ(back.images, note.images);
  EXPECT_EQ(back.held_out, note.held_out);
  EXPECT_EQ(back.outliers, note.outliers);
  EXPECT_EQ(back.hold_out_method, note.hold_out_method);
  EXPECT_EQ(back.hold_out_px, 0.02);
  EXPECT_EQ(back.square_mean_percent, -0.01);
  EXPECT_EQ(back.square_std_percent, 0.05);
  EXPECT_EQ(back.depth_rms_m, 4e-5);
  EXPECT_EQ(back.lens_sigma[0].distortion, note.lens_sigma[0].distortion);
  EXPECT_EQ(back.lens_sigma[1].fx_px, 0.5);
  EXPECT_TRUE(back.bar_sigma.isApprox(note.bar_sigma, 1e-9));
}

TEST_F(RigFile, RefusalsNameLineAndKey) {
  const auto wrong = readWith("fy_px: 719.4", "fy_px: .nan");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().line, 6);
  EXPECT_NE(wrong.error().reason.find("left.fy_px"), std::string::npos);
}

TEST_F(RigFile, EveryWrongNumberIsNamedByLineAndKey) {
  struct Wrong {
    const char* from;
    const char* to;
    int line;
    const char* key;
  };
  for (const auto& [from, to, line, key] :
       {Wrong{"fx_px: 720.9", "fx_px: 0", 5, "left.fx_px"},
        Wrong{"fx_px: 720.9", "fx_px: -.inf", 5, "left.fx_px"},
        Wrong{"fy_px: 550.7", "fy_px: .inf", 13, "right.fy_px"},
        Wrong{"cx_px: 640.1", "cx_px: nan", 14, "right.cx_px"},
        Wrong{"[1296, 964]", "[-1296, 964]", 2, "image_size_px[0]"},
        Wrong{"[1296, 964]", "[1296, 100000]", 2, "image_size_px[1]"},
        Wrong{"[-0.21, 0.045]", "[-0.21, .nan]", 9, "left.distortion[1]"},
        Wrong{"0.9997950", "0.9", 18, "right_from_left.rotation_xyzw"},
        Wrong{"0.9997950", ".nan", 18, "right_from_left.rotation_xyzw[3]"},
        Wrong{"[-0.12, 0.0003, 0.001]", "[0, 0, 0]", 19, "right_from_left.translation_m"},
        Wrong{"[-0.12, 0.0003, 0.001]", "[-0.12, .inf, 0.001]", 19, "right_from_left.translation_m[1]"}}) {
    const auto wrong = readWith(from, to);
    ASSERT_FALSE(wrong) << to;
    EXPECT_EQ(wrong.error().line, line) << to;
    EXPECT_NE(wrong.error().reason.find(key), std::string::npos) << describe(wrong.error());
  }
}

TEST_F(RigFile, RefusesWhatItDoesNotKnow) {
  EXPECT_FALSE(readWith("rig/1", "rig/2"));
  EXPECT_FALSE(readWith("brown_conrady", "pinhole"));
  EXPECT_FALSE(readWith("cx_px: 651.7", "cx_px: 651.7\n  skew: 0.1"));
  EXPECT_FALSE(readWith("right_from_left", "left_from_right"));
}

TEST_F(RigFile, RefusesNumbersThatCannotBe) {
  EXPECT_FALSE(readWith("fx_px: 720.9", "fx_px: -720.9"));
  EXPECT_FALSE(readWith("fx_px: 720.9", "fx_px: 0"));
  EXPECT_FALSE(readWith("[1296, 964]", "[1296, 0]"));
  EXPECT_FALSE(readWith("[1296, 964]", "[1296, 964, 1]"));
  EXPECT_FALSE(readWith("[1296, 964]", "[1296.5, 964]"));
  EXPECT_FALSE(readWith("[-0.21, 0.045]", "[-0.21]"));
  EXPECT_FALSE(readWith("[-0.21, 0.045]", "[-0.21, inf]"));
  EXPECT_FALSE(readWith("-0.003, 0.0004]", "-0.003]"));
  EXPECT_FALSE(readWith("0.9997950", "0.5"));
  EXPECT_FALSE(readWith("[-0.12, 0.0003, 0.001]", "[0, 0, 0]"));
}

TEST_F(RigFile, MissingFileIsNamed) {
  const auto rig = readRig("/nowhere/rig.yaml");
  ASSERT_FALSE(rig);
  EXPECT_EQ(rig.error().file, "/nowhere/rig.yaml");
}

TEST_F(RigFile, DamageNeverCrashesTheReader) {
  std::mt19937 random(7);
  for (int i = 0; i < 1500; ++i) {
    auto text = kRig.substr(0, i % 3 == 0 ? random() % kRig.size() : kRig.size());
    for (int change = 0; change < 4 && !text.empty(); ++change)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    const auto rig = readRig(write(text));
    if (rig) {
      EXPECT_GT(rig->left.intrinsics().fx_px, 0.0);
      EXPECT_TRUE(isRigid(rig->X_RC));
    }
  }
}

}  // namespace
}  // namespace mirrorarm::camera
