#include <gtest/gtest.h>

#include "program.h"

// Wrong input gives one line that says which file, where and why; exit 2; nothing half-written.
namespace mirrorarm::cli {
namespace {

void expectRefused(const std::string& arguments, const std::string& named,
                   const std::filesystem::path& out = {}) {
  const auto refused = run(arguments);
  EXPECT_EQ(refused.exit_code, 2) << arguments << "\n" << refused.err;
  EXPECT_EQ(refused.lines(), 1) << arguments << "\n" << refused.err;
  EXPECT_NE(refused.err.find(named), std::string::npos) << arguments << "\n" << refused.err;
  EXPECT_TRUE(refused.out.empty()) << refused.out;
  EXPECT_FALSE(!out.empty() && std::filesystem::exists(out)) << arguments;
}

const std::string kTarget =
    "format: mirrorarm/target/1\nname: forearm\nmarker_diameter_m: 0.007\n"
    "markers_m:\n  - [0, 0, 0]\n  - [0.05, 0, 0]\n  - [0, 0.07, 0.01]\n  - [0.03, 0.02, 0.04]\n";

TEST(BadInput, WrongUse) {
  expectRefused("", "subcommand");
  expectRefused("session", "--out");
  expectRefused("session --out x --seconds many", "seconds");
  expectRefused("calibrate stereo", "");
  expectRefused("serve", "subcommand");
  expectRefused("serve robot --robot kuka:1", "--robot");
  expectRefused("serve tracking recording", "--target");
  expectRefused("session --robot kuka:1 --out x", "--robot");
  expectRefused("session --fast --robot fri:49938 --out x", "--fast", "x");
}

TEST(BadInput, MissingFiles) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "out";
  const auto missing = (scratch / "missing").string();
  expectRefused("session --fast --seconds 2 --motion " + missing + " --out " + out.string(), "missing", out);
  expectRefused("simulate " + missing + " --out " + out.string(), "missing", out);
  expectRefused("detect " + missing + ".png --out " + out.string(), "missing", out);
  expectRefused("track " + missing + " --target " + missing + " --out " + out.string(), "missing", out);
  expectRefused("teach " + missing + " --out " + out.string(), "missing", out);
  expectRefused("calibrate stereo " + missing + " " + missing +
                    " --board chessboard:9x6:0.025 --model brown_conrady --out " + out.string(),
                "missing", out);
  expectRefused("calibrate hand-eye " + missing + " --out " + out.string(), "missing", out);
}

TEST(BadInput, WrongTargetsNameTheLine) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "poses.csv";
  const auto clouds = scratch.holding("clouds.csv", "index,time_ns,x_m,y_m,z_m\n0,0,0,0,0.4\n");
  const auto track = [&](const std::filesystem::path& target) {
    return "track --clouds " + clouds.string() + " --target " + target.string() + " --out " + out.string();
  };
  expectRefused(track(scratch.holding("format.yaml", "format: mirrorarm/target/9\n")), "format.yaml:1", out);
  expectRefused(track(scratch.holding("few.yaml",
                                      "format: mirrorarm/target/1\nname: a\nmarker_diameter_m: 0.007\n"
                                      "markers_m:\n  - [0, 0, 0]\n")),
                "few.yaml", out);
  expectRefused(track(scratch.holding("cut.yaml", kTarget.substr(0, 60))), "cut.yaml", out);
  auto nan = kTarget;
  expectRefused(track(scratch.holding("nan.yaml", nan.replace(nan.find("0.05"), 4, ".nan"))), "nan.yaml:6",
                out);
}

TEST(BadInput, WrongCloudsNameTheLine) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "poses.csv";
  const auto target = scratch.holding("target.yaml", kTarget);
  const auto track = [&](const std::filesystem::path& clouds) {
    return "track --clouds " + clouds.string() + " --target " + target.string() + " --out " + out.string();
  };
  expectRefused(track(scratch.holding("empty.csv", "")), "empty.csv", out);
  expectRefused(track(scratch.holding("column.csv", "index,time_ns,x_m,y_m\n0,0,0,0\n")), "z_m", out);
  expectRefused(track(scratch.holding("word.csv", "index,time_ns,x_m,y_m,z_m\n0,0,0,0,0.4\n0,0,left,0,0\n")),
                "word.csv:3", out);
  expectRefused(track(scratch.holding("cut.csv", "index,time_ns,x_m,y_m,z_m\n0,0,0,0,0.4\n1,4")), "cut.csv:3",
                out);
}

TEST(BadInput, BrokenImages) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "centres.csv";
  const auto broken = scratch.holding("broken.png", "\x89PNG\r\n\x1a\n and then nothing");
  expectRefused("detect " + broken.string() + " --out " + out.string(), "broken.png", out);
}

std::string greyMap(int width, int height) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" +
         std::string(static_cast<std::size_t>(width * height), '\x10');
}

TEST(BadInput, DeepImagesAreToldWhatToDo) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "centres.csv";
  const auto deep = scratch.holding("deep.pgm", std::string("P5\n2 1\n65535\n\1\2\3\4", 17));
  expectRefused("detect " + deep.string() + " --out " + out.string(), "16-bit", out);
}

TEST(BadInput, UnknownMethods) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "out";
  for (const std::string command : {"detect a.png", "track a --target b", "teach a", "session --fast"})
    expectRefused(command + " --method centroid --out " + out.string(), "centroid", out);
}

TEST(BadInput, WrongRecordings) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "poses.csv";
  const auto target = scratch.holding("target.yaml", kTarget);
  std::filesystem::create_directories(scratch / "recording");
  scratch.holding("recording/rig.yaml", "format: mirrorarm/rig/1\nimage_size_px: [1296]\n");
  scratch.holding("recording/frames.csv",
                  "index,time_ns,exposure_us,left,right\n0,0,1500,left/0.png,right/0.png\n");
  expectRefused(
      "track " + (scratch / "recording").string() + " --target " + target.string() + " --out " + out.string(),
      "rig.yaml:2", out);
}

TEST(BadInput, ImagesOfAnotherSizeThanTheRigs) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "out.csv";
  std::filesystem::create_directories(scratch / "recording");
  const std::string camera =
      "model: brown_conrady, fx_px: 60, fy_px: 60, cx_px: 32, cy_px: 24, distortion: [0, 0]";
  scratch.holding("recording/rig.yaml",
                  "format: mirrorarm/rig/1\nimage_size_px: [64, 48]\nleft: {" + camera + "}\nright: {" +
                      camera +
                      "}\nright_from_left: {rotation_xyzw: [0, 0, 0, 1], translation_m: [-0.1, 0, 0]}\n");
  scratch.holding("recording/frames.csv",
                  "index,time_ns,exposure_us,left,right\n0,0,1500,left.pgm,right.pgm\n");
  scratch.holding("recording/left.pgm", greyMap(64, 48));
  scratch.holding("recording/right.pgm", greyMap(48, 64));
  const auto detect = "detect " + (scratch / "recording").string() + " --out " + out.string();
  expectRefused(detect, "right.pgm: is 48x64 where the rig has 64x48", out);
  scratch.holding("recording/right.pgm", greyMap(64, 48));
  EXPECT_EQ(run(detect).exit_code, 0);
}

TEST(BadInput, WrongMotion) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "session";
  const auto cut = scratch.holding("cut.trc", "PathFileType\t4\t(X/Y/Z)\tcut.trc\nDataRate\tCameraRate\n");
  expectRefused("session --fast --seconds 2 --motion " + cut.string() + " --out " + out.string(), "cut.trc",
                out);
  expectRefused("session --fast --seconds 2 --exercise somersault --out " + out.string(), "somersault", out);
}

TEST(BadInput, WrongPosePairs) {
  const test::ScratchFolder scratch;
  const auto out = scratch / "hand_eye.yaml";
  const auto pairs = scratch.holding(
      "pairs.csv",
      "bx_m,by_m,bz_m,bqx,bqy,bqz,bqw,cx_m,cy_m,cz_m,cqx,cqy,cqz,cqw\n0,0,0,0,0,0,1,0,0,0,0,0,0,1\n");
  expectRefused("calibrate hand-eye " + pairs.string() + " --out " + out.string(), "pairs.csv", out);
}

}  // namespace
}  // namespace mirrorarm::cli
