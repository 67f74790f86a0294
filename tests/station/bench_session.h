#pragma once

#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "core/station/bench_equipment.h"
#include "core/station/lockstep_station.h"
#include "core/station/session_script.h"
#include "tests/common/scratch_folder.h"

namespace mirrorarm::station {

inline simulation::BenchSettings benchFor(const std::string& exercise, bool own_pace = false) {
  simulation::BenchSettings settings;
  settings.resources = RESOURCES;
  settings.legs = legsOf(*therapy::exerciseOf(exercise));
  settings.own_pace = own_pace;
  return settings;
}

/// A bench and a lockstep station over it, worked by a script: seconds of session in fractions of them.
class BenchSession {
 public:
  /// `besides` stands on the bench too.
  explicit BenchSession(const ScriptSettings& script,
                        const simulation::BenchSettings& bench = benchFor("reach"),
                        StationSettings settings = {}, const std::vector<robot::Obstacle>& besides = {}) {
    time_.set(TimePoint(std::chrono::seconds(1)));
    auto made = simulation::Bench::make(bench, time_);
    if (!made) throw std::runtime_error(describe(made.error()));
    bench_ = std::move(*made);
    settings.store_file = folder_ / "store.sqlite";
    settings.black_box_folder = folder_.path();
    Equipment equipment = equipmentOf(*bench_);
    equipment.obstacles.insert(equipment.obstacles.end(), besides.begin(), besides.end());
    station_ = std::make_unique<LockstepStation>(equipment, settings, time_);
    script_ = std::make_unique<SessionScript>(*station_, script,
                                              [this](bool moving) { bench_->setPatientMoving(moving); });
  }

  /// Runs until `until` says so or the script ends; gives the script's last word.
  template <class Until>
  SessionScript::Progress runUntil(Until until) {
    auto progress = SessionScript::Progress::kRunning;
    while (progress == SessionScript::Progress::kRunning && !until(script_->seen())) {
      station_->advanceTo(time_.now() + std::chrono::milliseconds(20));
      progress = script_->step(time_.now());
    }
    return progress;
  }
  SessionScript::Progress run() {
    return runUntil([](const Snapshot&) { return false; });
  }
  /// Runs without the script.
  const Snapshot& wait(Seconds duration) {
    station_->advanceTo(time_.now() + toClock(duration));
    last_ = station_->snapshot();
    return last_;
  }

  [[nodiscard]] TimePoint now() const { return time_.now(); }
  simulation::Bench& bench() { return *bench_; }
  LockstepStation& station() { return *station_; }
  SessionScript& script() { return *script_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  test::ScratchFolder folder_;
  ManualTime time_;
  std::unique_ptr<simulation::Bench> bench_;
  std::unique_ptr<LockstepStation> station_;
  std::unique_ptr<SessionScript> script_;
  Snapshot last_;
};

inline bool isTraining(const Snapshot& snapshot) {
  return snapshot.control.phase == therapy::Phase::kTraining;
}

}  // namespace mirrorarm::station
