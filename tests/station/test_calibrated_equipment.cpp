#include <gtest/gtest.h>

#include "core/common/calendar.h"
#include "core/station/calibrated_equipment.h"
#include "tests/station/bench_session.h"

namespace mirrorarm::station {
namespace {

using namespace std::chrono_literals;

class CalibratedEquipment : public testing::Test {
 protected:
  CalibratedEquipment() {
    time_.set(TimePoint(1s));
    bench_ = std::move(*simulation::Bench::make(benchFor("reach"), time_));
    const auto today = isoUtcNow();
    in_force_.rig = bench_->rig();
    in_force_.rig->calibration.date = today;
    in_force_.rig->X_RC.translation().x() += 1e-3;
    in_force_.hand_eye = calibration::HandEye{};
    in_force_.hand_eye->calibration.date = today;
    in_force_.clock = calibration::ClockRecord{};
    in_force_.clock->offset_s = 0.004;
    in_force_.clock->date = today;
    in_force_.drift = calibration::DriftRecord{today, {}};
    in_force_.drift->findings.verdict = calibration::DriftVerdict::kHolds;
  }
  Equipment with(const calibration::InForce& in_force) const {
    return calibrated(equipmentOf(*bench_), in_force, validityOf(in_force, std::chrono::system_clock::now()));
  }
  ManualTime time_;
  std::unique_ptr<simulation::Bench> bench_;
  calibration::InForce in_force_;
};

TEST_F(CalibratedEquipment, TakesWhatIsInForce) {
  const auto equipment = with(in_force_);
  EXPECT_TRUE(equipment.calibration_holds);
  EXPECT_TRUE(equipment.rig.X_RC.isApprox(in_force_.rig->X_RC));
  EXPECT_TRUE(equipment.X_FC.isApprox(RigidTransform::Identity()));
  EXPECT_EQ(equipment.clock_offset, Seconds(0.004));
}

TEST_F(CalibratedEquipment, SimulatedDevicesBringTheirOwn) {
  const auto equipment = with({});
  EXPECT_TRUE(equipment.calibration_holds);
  EXPECT_TRUE(equipment.X_FC.isApprox(bench_->X_FC()));
  auto real = equipmentOf(*bench_);
  real.simulated = false;
  EXPECT_FALSE(
      calibrated(real, {}, calibration::validityOf({}, std::chrono::system_clock::now())).calibration_holds);
}

TEST_F(CalibratedEquipment, WhatDoesNotHoldForbidsASession) {
  auto failed = in_force_;
  failed.drift->findings.verdict = calibration::DriftVerdict::kFailed;
  EXPECT_FALSE(with(failed).calibration_holds);
  auto beside = in_force_;
  beside.hand_eye->mount = calibration::CameraMount::kToHand;
  EXPECT_FALSE(with(beside).calibration_holds);
  auto half = in_force_;
  half.hand_eye.reset();
  EXPECT_FALSE(with(half).calibration_holds);
}

TEST_F(CalibratedEquipment, TheStationRefusesToAlignWithoutOne) {
  auto equipment = equipmentOf(*bench_);
  equipment.calibration_holds = false;
  LockstepStation station(equipment, {}, time_);
  bench_->setPatientMoving(true);
  const auto run = [&](Seconds duration) {
    station.advanceTo(time_.now() + toClock(duration));
    return station.snapshot().control;
  };
  run(0.3s);
  ASSERT_EQ(station.request({therapy::Action::kTeach}), Answer::kAccepted);
  ASSERT_EQ(run(8s).phase, therapy::Phase::kTaught);
  ASSERT_EQ(station.request({therapy::Action::kAlign}), Answer::kAccepted);
  const auto control = run(0.3s);
  EXPECT_EQ(control.last_answer, Answer::kNotCalibrated);
  EXPECT_EQ(control.phase, therapy::Phase::kTaught);
}

}  // namespace
}  // namespace mirrorarm::station
