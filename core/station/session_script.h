#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/common/time.h"
#include "core/station/station_port.h"

namespace mirrorarm::station {

struct ScriptSettings {
  Seconds teaching{2.0};
  Seconds training{30.0};
  therapy::Mapping mapping = therapy::Mapping::kFollow;
  int max_restarts = 10;  ///< after stops that nobody pressed
};

/// An operator who works through a whole session by himself: teach, align, start, finish. A stop that nobody
/// pressed is reset and the training goes on, as a therapist would do; each is counted. One whose cause lasts
/// ends the session: its record is finished, and the script has failed.
class SessionScript {
 public:
  enum class Progress { kRunning, kDone, kFailed };

  /// `instruct` tells the patient to move (true) or to rest. Both outlive the script.
  SessionScript(StationPort& station, const ScriptSettings& settings, std::function<void(bool)> instruct);

  /// Looks once and acts; call it some ten times a second until it is done.
  Progress step(TimePoint now);

  /// Why it failed, an id of the kind "too_few_markers" or "stop.robot_silent"; empty otherwise.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// Stops on the way.
  [[nodiscard]] int stops() const { return stops_; }
  /// The last snapshot that was looked at.
  [[nodiscard]] const Snapshot& seen() const { return seen_; }

 private:
  enum class Stage { kWait, kTeach, kEndTeaching, kRest, kAlign, kStart, kTrain, kRestart, kFinish, kDone };
  Progress waitForMarkers();
  Progress teach();
  Progress settle(therapy::Action action, Stage next);
  Progress start();
  Progress train();
  Progress restart();
  Progress waitForRecord();
  Progress afterAnswer(Stage next);
  Progress ask(therapy::Action action, Stage next);
  Progress patience();
  Progress fail(std::string why);
  Progress giveUp();
  void noteStop();
  bool clearsStop();
  void go(Stage stage);
  [[nodiscard]] std::string lastingStop() const;
  [[nodiscard]] Seconds waited() const { return now_ - stage_since_; }
  [[nodiscard]] bool answered() const { return seen_.control.answers != answers_before_; }

  StationPort& station_;
  const ScriptSettings settings_;
  const std::function<void(bool)> instruct_;
  Snapshot seen_;
  Stage stage_ = Stage::kWait;
  TimePoint now_{};
  TimePoint stage_since_{};
  TimePoint train_until_{};
  std::uint32_t answers_before_ = 0;
  bool stopped_ = false;
  int stops_ = 0;
  std::string failure_;
};

}  // namespace mirrorarm::station
