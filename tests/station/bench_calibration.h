#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/calibration/calibration_folder.h"
#include "core/common/file_error.h"
#include "core/station/bench_equipment.h"
#include "core/station/lockstep_calibration_station.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::station {

inline const calibration::Board kPlate = *calibration::boardOf("dots:9x7:0.03");

/// Fewer frames than the real cameras give, so that a test takes fractions of the time it plays.
inline simulation::BenchSettings benchWithPlate() {
  simulation::BenchSettings settings;
  settings.resources = RESOURCES;
  settings.plate = plateOf(kPlate);
  settings.rate_hz = 3.0;
  settings.own_pace = false;
  return settings;
}

/// As a data sheet says: `focal` times as long as they are, the bar longer by `bar_m`.
inline camera::StereoRig roughRig(const camera::StereoRig& truth, double focal, double bar_m) {
  const auto lens = [focal](const camera::CameraModel& camera) {
    auto intrinsics = camera.intrinsics();
    intrinsics.fx_px *= focal;
    intrinsics.fy_px *= focal;
    return camera::CameraModel(intrinsics);
  };
  auto rig = truth;
  rig.left = lens(truth.left);
  rig.right = lens(truth.right);
  rig.X_RC.translation() += bar_m * truth.X_RC.translation().normalized();
  return rig;
}

struct BenchSetup {
  simulation::BenchSettings bench = benchWithPlate();
  CalibrationSettings settings{};
  std::function<void(Equipment&)> change{};             ///< what the station is told of the equipment
  std::function<void(calibration::InForce&)> before{};  ///< what is in force; the truth is filled in
};

/// A bench with a plate and a lockstep station over it.
class BenchCalibration {
 public:
  explicit BenchCalibration(BenchSetup setup = {}) {
    time_.set(TimePoint(std::chrono::seconds(1)));
    auto made = simulation::Bench::make(setup.bench, time_);
    if (!made) throw std::runtime_error(describe(made.error()));
    bench_ = std::move(*made);
    putInForce(setup.before);
    auto equipment = equipmentOf(*bench_);
    if (setup.change) setup.change(equipment);
    setup.settings.folder = folder_ / "calibrations";
    setup.settings.black_box_folder = folder_.path();
    setup.settings.capture.still_frames = 2;
    setup.settings.supervisor.camera_silent_after = Seconds(0.6);  // the bench's frames are few
    station_ = std::make_unique<LockstepCalibrationStation>(equipment, setup.settings, time_);
  }

  const CalibrationSnapshot& wait(Seconds duration) {
    station_->advanceTo(time_.now() + toClock(duration));
    return seen_ = station_->snapshot();
  }
  /// Plays until `done`; false where it does not come to that within `most`.
  bool waitFor(const std::function<bool(const CalibrationSnapshot&)>& done, Seconds most = Seconds(240.0)) {
    const auto until = time_.now() + toClock(most);
    while (time_.now() < until)
      if (done(wait(Seconds(0.05)))) return true;
    return false;
  }
  /// Asks and gives the answer.
  CalibrationAnswer ask(const CalibrationCommand& command) {
    const auto answers = wait(Seconds(0.02)).answers;
    if (station_->request(command) != CalibrationAnswer::kAccepted) return CalibrationAnswer::kQueueFull;
    if (!waitFor([&](const auto& seen) { return seen.answers != answers; }, Seconds(2.0)))
      throw std::runtime_error("no answer");
    return seen_.last_answer;
  }
  CalibrationAnswer begin(CalibrationJob job, std::optional<camera::LensModel> model = {}) {
    const auto given =
        ask({.action = CalibrationAction::kBegin, .job = job, .board = kPlate, .model = model});
    wait(Seconds(1.0));
    return given;
  }
  CalibrationAnswer drive(bool on = true) {
    return ask({.action = CalibrationAction::kSetDriving, .on = on});
  }
  CalibrationAnswer setAutomatic(bool on) {
    return ask({.action = CalibrationAction::kSetAutomatic, .on = on});
  }
  /// Drives until the robot has been everywhere.
  bool driveToTheEnd() {
    return drive() == CalibrationAnswer::kAccepted && waitFor([](const auto& seen) { return !seen.driving; });
  }
  /// Solves; nullptr where it is refused.
  std::shared_ptr<const CalibrationOutcome> solve() {
    if (ask({.action = CalibrationAction::kSolve}) != CalibrationAnswer::kAccepted) return nullptr;
    waitFor([](const auto& seen) { return seen.phase != CalibrationPhase::kSolving; }, Seconds(1.0));
    return seen_.outcome;
  }

  simulation::Bench& bench() { return *bench_; }
  LockstepCalibrationStation& station() { return *station_; }
  const CalibrationSnapshot& seen() const { return seen_; }
  calibration::CalibrationFolder folder() const {
    return calibration::CalibrationFolder(folder_ / "calibrations");
  }
  calibration::InForce inForce() const { return *folder().read(); }
  const std::filesystem::path& scratch() const { return folder_.path(); }
  void end() { station_.reset(); }

 private:
  void putInForce(const std::function<void(calibration::InForce&)>& before) {
    if (!before) return;
    calibration::HandEye hand_eye;
    hand_eye.X_PC = bench_->X_FC();
    calibration::InForce in_force{bench_->rig(), hand_eye, std::nullopt, std::nullopt};
    before(in_force);
    if (in_force.rig && !folder().accept(*in_force.rig)) throw std::runtime_error("rig");
    if (in_force.hand_eye && !folder().accept(*in_force.hand_eye)) throw std::runtime_error("hand-eye");
    if (in_force.clock && !folder().accept(*in_force.clock)) throw std::runtime_error("clock");
  }

  test::ScratchFolder folder_;
  ManualTime time_;
  std::unique_ptr<simulation::Bench> bench_;
  std::unique_ptr<LockstepCalibrationStation> station_;
  CalibrationSnapshot seen_;
};

/// Nothing changed: the truth is in force.
inline void truthInForce(calibration::InForce&) {}

}  // namespace mirrorarm::station
