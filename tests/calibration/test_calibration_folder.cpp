#include <fstream>

#include <gtest/gtest.h>

#include "core/calibration/calibration_folder.h"
#include "core/calibration/validity.h"
#include "core/common/calendar.h"
#include "tests/calibration/board_views.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::calibration {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class InAFolder : public testing::Test {
 protected:
  static camera::StereoRig rig() {
    auto rig = trueRig(camera::LensModel::kKannalaBrandt);
    rig.calibration.date = "2026-11-01T08:00:00Z";
    return rig;
  }
  static HandEye handEye() {
    HandEye hand_eye;
    hand_eye.X_PC = makeTransform(Eigen::Matrix3d::Identity(), {0.06, 0.08, 0.03});
    hand_eye.calibration.date = "2026-11-01T09:00:00Z";
    return hand_eye;
  }
  static DriftRecord drift(DriftVerdict verdict) {
    DriftRecord record;
    record.date = "2026-11-02T07:00:00Z";
    record.findings.points = 63;
    record.findings.verdict = verdict;
    return record;
  }
  InForce inForce() const {
    const auto read = folder.read();
    EXPECT_TRUE(read);
    return read ? *read : InForce{};
  }
  std::size_t recordCount() const {
    const auto records = folder.path() / "records";
    return fs::exists(records) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(records), {}))
                               : 0;
  }

  test::ScratchFolder scratch;
  CalibrationFolder folder{scratch / "calibrations"};
};

TEST_F(InAFolder, NothingIsInForceBeforeAnythingIsAccepted) {
  const auto in_force = inForce();
  EXPECT_FALSE(in_force.rig || in_force.hand_eye || in_force.clock || in_force.drift);
}

TEST_F(InAFolder, WhatIsAcceptedIsInForceWithItsImages) {
  const auto work = folder.makeWorkFolder();
  ASSERT_TRUE(work);
  std::ofstream(*work / "left_01.png") << "picture";
  const auto name = folder.accept(rig(), *work);
  ASSERT_TRUE(name) << name.error();
  EXPECT_FALSE(fs::exists(*work));
  EXPECT_TRUE(fs::exists(folder.path() / "records" / *name / "left_01.png"));
  ASSERT_TRUE(inForce().rig);
  EXPECT_TRUE(inForce().rig->X_RC.isApprox(rig().X_RC, 1e-12));
}

TEST_F(InAFolder, ANewRigTakesWhatStoodOnTheOldOneOutOfForce) {
  ASSERT_TRUE(folder.accept(rig()));
  ASSERT_TRUE(folder.accept(handEye()));
  ASSERT_TRUE(folder.accept(ClockRecord{}));
  ASSERT_TRUE(folder.accept(drift(DriftVerdict::kHolds)));
  EXPECT_TRUE(inForce().hand_eye && inForce().clock && inForce().drift);
  ASSERT_TRUE(folder.accept(handEye()));
  EXPECT_FALSE(inForce().drift);
  ASSERT_TRUE(folder.accept(rig()));
  EXPECT_TRUE(inForce().rig && inForce().clock);
  EXPECT_FALSE(inForce().hand_eye || inForce().drift);
  EXPECT_EQ(recordCount(), 6u);  // the old ones stay
}

TEST_F(InAFolder, WhatCannotBeWrittenLeavesTheOldOneInForce) {
  ASSERT_TRUE(folder.accept(rig()));
  fs::create_directories(scratch / "blocked");
  std::ofstream(scratch / "blocked/records") << "a file where a folder should be";
  EXPECT_FALSE(CalibrationFolder(scratch / "blocked").accept(rig()));
  EXPECT_FALSE(CalibrationFolder(scratch / "blocked").read()->rig);
  fs::remove_all(folder.path() / "work");
  std::ofstream(folder.path() / "work") << "a file where a folder should be";
  auto other = rig();
  other.calibration.method = "other";
  EXPECT_FALSE(folder.accept(other));
  EXPECT_EQ(inForce().rig->calibration.method, rig().calibration.method);
}

TEST_F(InAFolder, BrokenListsAreRefusedWithTheFile) {
  ASSERT_TRUE(folder.accept(rig()));
  const auto list = folder.path() / "in_force.yaml";
  for (const std::string text :
       {"format: mirrorarm/in-force/2\n", "format: mirrorarm/in-force/1\nrig: \"../../etc\"\n",
        "format: mirrorarm/in-force/1\nlens: a\n", "format: mirrorarm/in-force/1\nrig: \"gone\"\n", ""}) {
    std::ofstream(list) << text;
    EXPECT_FALSE(folder.read()) << text;
  }
}

class ValidityTest : public InAFolder {
 protected:
  static std::chrono::system_clock::time_point at(const char* date) { return *timeOfIsoUtc(date); }
  static InForce all() { return {rig(), handEye(), std::nullopt, drift(DriftVerdict::kHolds)}; }
};

TEST_F(ValidityTest, AllowsASessionWhileEverythingHolds) {
  const auto validity = validityOf(all(), at("2026-11-02T12:00:00Z"));
  EXPECT_TRUE(validity.allowsSession());
  EXPECT_EQ(validity.of(CalibrationKind::kRig).age, 28h);
  EXPECT_EQ(validity.of(CalibrationKind::kClock).standing, Standing::kMissing);
}

TEST_F(ValidityTest, RefusesWhatIsMissingOldUndatedOrFailed) {
  const auto noon = at("2026-11-02T12:00:00Z");
  auto missing = all();
  missing.hand_eye.reset();
  EXPECT_FALSE(validityOf(missing, noon).allowsSession());
  auto unchecked = all();
  unchecked.drift.reset();
  EXPECT_FALSE(validityOf(unchecked, noon).allowsSession());
  auto failed = all();
  failed.drift->findings.verdict = DriftVerdict::kFailed;
  EXPECT_EQ(validityOf(failed, noon).of(CalibrationKind::kDrift).standing, Standing::kFailed);
  EXPECT_FALSE(validityOf(failed, noon).allowsSession());
  auto undated = all();
  undated.rig->calibration.date = "last Tuesday";
  EXPECT_EQ(validityOf(undated, noon).of(CalibrationKind::kRig).standing, Standing::kUndated);
  EXPECT_FALSE(validityOf(undated, noon).allowsSession());
  EXPECT_FALSE(validityOf(all(), at("2026-10-01T00:00:00Z")).allowsSession());  // dated in the future
  const auto next_day = validityOf(all(), at("2026-11-03T07:00:00Z"));
  EXPECT_EQ(next_day.of(CalibrationKind::kDrift).standing, Standing::kExpired);
  EXPECT_FALSE(next_day.allowsSession());
  EXPECT_EQ(validityOf(all(), at("2027-03-01T00:00:00Z")).of(CalibrationKind::kRig).standing,
            Standing::kExpired);
}

TEST_F(ValidityTest, ADoubtfulCheckWarnsOnly) {
  auto doubtful = all();
  doubtful.drift->findings.verdict = DriftVerdict::kDoubtful;
  const auto validity = validityOf(doubtful, at("2026-11-02T12:00:00Z"));
  EXPECT_EQ(validity.of(CalibrationKind::kDrift).standing, Standing::kDoubtful);
  EXPECT_TRUE(validity.allowsSession());
}

}  // namespace
}  // namespace mirrorarm::calibration
