#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/station/board_stage.h"
#include "core/station/calibration_jobs.h"
#include "core/station/guidance.h"
#include "core/station/motion_streams.h"
#include "core/station/servo_digest.h"
#include "core/station/stop_log.h"

namespace mirrorarm::station {

/// The mind of a calibration: takes commands and the frames' reports, keeps the phase and the views, takes
/// views by itself, has the robot guided and the result solved and written. step() belongs to the control
/// thread.
class CalibrationControl {
 public:
  /// `servo` and `arm` are nullptr without a robot.
  CalibrationControl(const Equipment& equipment, const CalibrationSettings& settings,
                     control::ServoLoop* servo, std::shared_ptr<const PlannedArm> arm, BoardStage& boards,
                     JobRunner& runner);

  /// Any thread.
  [[nodiscard]] CalibrationAnswer request(const CalibrationCommand& command) noexcept {
    return commands_.push(command) ? CalibrationAnswer::kAccepted : CalibrationAnswer::kQueueFull;
  }
  /// A frame came from the cameras: their watchdog's food. Acquisition thread.
  void frameCame(TimePoint exposed_at) noexcept {
    newest_frame_.store(exposed_at, std::memory_order_relaxed);
  }
  /// Vision thread. A report that finds the queue full is lost: newer ones follow.
  void report(const BoardReport& report) noexcept { static_cast<void>(reports_.push(report)); }

  void step(TimePoint now);
  /// After the last step: the black box that is not kept yet is.
  void end();

  LatestValue<std::shared_ptr<const CalibrationSnapshot>> for_screen;  ///< taken by the screen's thread only

 private:
  void drainServo();
  void noteStop(const StopNews& news);
  void takeReports();
  void takeReport(const BoardReport& report);
  void takeByItself(const BoardReport& report);
  void takeView();
  void takeAnswers();
  void take(const ViewProposal& proposal, std::uint64_t version);
  void take(const SolveAnswer& answer);
  void take(const WriteAnswer& answer);
  void obeyCommands();
  [[nodiscard]] CalibrationAnswer obey(const CalibrationCommand& command);
  [[nodiscard]] CalibrationAnswer begin(const CalibrationCommand& command);
  [[nodiscard]] CalibrationAnswer capture();
  [[nodiscard]] CalibrationAnswer setDriving(bool on);
  [[nodiscard]] CalibrationAnswer changeViews(const CalibrationCommand& command);
  [[nodiscard]] CalibrationAnswer solve();
  [[nodiscard]] CalibrationAnswer accept();
  void cancel();
  void answer(CalibrationAnswer given);
  void guide();
  void tellServo();
  void publish();
  void updateWatch();
  void updateCoverage();
  [[nodiscard]] Guidance::Situation situation() const;
  [[nodiscard]] calibration::ImageSize imageSize() const;
  [[nodiscard]] std::size_t viewsWanted() const;
  [[nodiscard]] double progress() const;
  [[nodiscard]] bool isEnabled() const;
  [[nodiscard]] bool robotRests() const;
  [[nodiscard]] bool hasAllFor(CalibrationJob job) const;

  const CalibrationSettings settings_;
  const Equipment equipment_;
  control::ServoLoop* const servo_;
  BoardStage& boards_;
  CalibrationJobs jobs_;
  Guidance guidance_;
  std::optional<ServoDigest> digest_;  ///< nothing without a robot
  BoundedQueue<CalibrationCommand, 16> commands_;
  BoundedQueue<BoardReport, 64> reports_;
  std::atomic<TimePoint> newest_frame_{TimePoint{}};

  // Control thread only.
  TimePoint now_{};
  CalibrationSnapshot state_;
  std::optional<camera::LensModel> model_;
  KnownCalibrations known_;
  std::optional<camera::StereoRig> rig_;  ///< known, or in a stereo job from the views so far
  TakenViews views_;
  MotionStreams streams_;
  std::vector<calibration::PosePair> pairs_;  ///< behind a hand-eye outcome
  std::uint64_t watch_ = 0;                   ///< version of what the vision thread looks for
  std::optional<RigidTransform> X_BF_;        ///< at the exposure of the newest report
  std::optional<RigidTransform> X_BM_;        ///< where the board stood when it was last seen at rest
  bool writing_ = false;
  StopLog stops_;
};

}  // namespace mirrorarm::station
