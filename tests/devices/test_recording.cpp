#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "core/camera/image_file.h"
#include "core/common/csv.h"
#include "core/devices/recording.h"
#include "tests/devices/small_recording.h"

namespace mirrorarm::devices {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

bool samePixels(const camera::GreyImage& a, const camera::GreyImage& b) {
  return a.width() == b.width() && a.height() == b.height() &&
         std::memcmp(a.view().data, b.view().data, static_cast<std::size_t>(a.width() * a.height())) == 0;
}

struct Refusal {
  const char* why;
  const char* from;
  const char* to;
  int line;
};

class RecordingTest : public ::testing::Test {
 protected:
  OwnFolder own_;
  fs::path folder_ = own_.path() / "rec";
};

TEST_F(RecordingTest, ReadsWhatWasWritten) {
  ASSERT_TRUE(writeSmall(folder_, 4));
  const auto recording = Recording::open(folder_);
  ASSERT_TRUE(recording) << describe(recording.error());
  ASSERT_EQ(recording->size(), 4u);
  EXPECT_EQ(recording->index(3), 4);
  for (int i = 0; i < 4; ++i) {
    const auto frame = recording->frame(static_cast<std::size_t>(i));
    ASSERT_TRUE(frame) << describe(frame.error());
    const auto truth = smallFrame(i);
    EXPECT_TRUE(samePixels(frame->left, truth.left));
    EXPECT_TRUE(samePixels(frame->right, truth.right));
    EXPECT_EQ(frame->exposed_at, truth.exposed_at);
    EXPECT_EQ(frame->sequence, truth.sequence);
    EXPECT_NEAR(frame->exposure.count(), 0.0015, 1e-12);
  }
}

TEST_F(RecordingTest, AppearsWholeOrNotAtAll) {
  {
    auto writer = RecordingWriter::create(folder_, smallRig());
    ASSERT_TRUE(writer) << writer.error();
    ASSERT_TRUE(writer->add(smallFrame(0)));
    EXPECT_FALSE(fs::exists(folder_));
  }
  EXPECT_TRUE(fs::is_empty(own_.path()));
}

TEST_F(RecordingTest, NeverOverwritesARecording) {
  ASSERT_TRUE(writeSmall(folder_, 1));
  const auto again = RecordingWriter::create(folder_, smallRig());
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().find("not an empty folder"), std::string::npos);
  EXPECT_TRUE(Recording::open(folder_));
}

TEST_F(RecordingTest, TruthAndFlangeStandBesideTheFrames) {
  auto writer = RecordingWriter::create(folder_, smallRig());
  ASSERT_TRUE(writer) << writer.error();
  ASSERT_TRUE(writer->add(smallFrame(0)));
  writer->addTruth(
      {0, "forearm", makeTransform(Eigen::Quaterniond(0.8, 0.6, 0.0, 0.0), {0.1, -0.2, 0.4}), 9});
  writer->addFlange(fromNanoseconds(7), robot::Joints::Constant(7, 0.25), RigidTransform::Identity());
  write(writer->stagingFolder() / "meta.yaml", "format: test\n");
  ASSERT_TRUE(writer->finish());
  const auto truth = CsvTable::read(folder_ / "truth.csv");
  ASSERT_TRUE(truth);
  ASSERT_EQ(truth->rows().size(), 1u);
  EXPECT_NEAR(*truth->number(truth->rows()[0], truth->column("qx")), 0.6, 1e-12);
  EXPECT_EQ(*truth->integer(truth->rows()[0], truth->column("visible")), 9);
  const auto robot = CsvTable::read(folder_ / "robot.csv");
  ASSERT_TRUE(robot);
  EXPECT_EQ(*robot->number(robot->rows().front(), robot->column("q7")), 0.25);
  EXPECT_TRUE(fs::exists(folder_ / "meta.yaml"));
}

TEST_F(RecordingTest, RefusesWrongFrameTables) {
  ASSERT_TRUE(writeSmall(folder_, 2));
  const std::string good = contents(folder_ / "frames.csv");
  for (const auto& wrong :
       {Refusal{"cut row", "1,5041666667", "1", 3}, Refusal{"words", "1500,left/000001", "x,left/1", 3},
        Refusal{"order of index", "\n1,", "\n0,", 3}, Refusal{"negative", "\n0,", "\n-1,", 2},
        Refusal{"order of time", "5041666667", "4041666667", 3},
        Refusal{"a way out", "left/000000.png", "../rec.png", 2},
        Refusal{"no column", "time_ns", "time", 1}}) {
    std::string bad = good;
    bad.replace(bad.find(wrong.from), std::strlen(wrong.from), wrong.to);
    write(folder_ / "frames.csv", bad);
    const auto recording = Recording::open(folder_);
    ASSERT_FALSE(recording) << wrong.why;
    EXPECT_EQ(recording.error().line, wrong.line) << wrong.why << ": " << describe(recording.error());
    EXPECT_EQ(recording.error().file.filename(), "frames.csv");
  }
  write(folder_ / "frames.csv", good.substr(0, good.find('\n') + 1));
  EXPECT_FALSE(Recording::open(folder_));
}

TEST_F(RecordingTest, RefusesWhatIsMissingOrBroken) {
  EXPECT_FALSE(Recording::open(folder_));
  ASSERT_TRUE(writeSmall(folder_, 2));
  const auto recording = Recording::open(folder_);
  ASSERT_TRUE(recording);
  const auto image = folder_ / "left/000000.png";
  write(image, contents(image).substr(0, 40));
  EXPECT_FALSE(recording->frame(0));
  fs::remove(image);
  EXPECT_EQ(recording->frame(0).error().file, image);
  fs::remove(folder_ / "rig.yaml");
  EXPECT_EQ(Recording::open(folder_).error().file.filename(), "rig.yaml");
}

TEST_F(RecordingTest, RefusesImagesOfAnotherSize) {
  ASSERT_TRUE(writeSmall(folder_, 1));
  ASSERT_TRUE(camera::writeImage(folder_ / "right/000000.png", camera::GreyImage(2, 2, {1, 2, 3, 4})));
  const auto frame = Recording::open(folder_)->frame(0);
  ASSERT_FALSE(frame);
  EXPECT_NE(frame.error().reason.find("2x2"), std::string::npos);
}

TEST_F(RecordingTest, SurvivesRandomChanges) {
  ASSERT_TRUE(writeSmall(folder_, 3));
  const std::string good = contents(folder_ / "frames.csv");
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string bad = good;
    for (int n = 0; n < 1 + i % 4; ++n) bad[random() % bad.size()] = static_cast<char>(random());
    if (i % 5 == 0) bad.resize(random() % bad.size());
    write(folder_ / "frames.csv", bad);
    const auto recording = Recording::open(folder_);
    if (recording)
      EXPECT_GT(recording->size(), 0u);
    else
      EXPECT_FALSE(recording.error().reason.empty());
  }
}

}  // namespace
}  // namespace mirrorarm::devices
