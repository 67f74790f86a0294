#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/calibration/capture_rule.h"
#include "core/calibration/clock_offset.h"
#include "core/calibration/coverage.h"
#include "core/calibration/drift_check.h"
#include "core/calibration/hand_eye.h"
#include "core/calibration/next_view.h"
#include "core/calibration/rig_comparison.h"
#include "core/calibration/stereo_calibration.h"
#include "core/camera/stereo_frame.h"
#include "core/control/servo_loop.h"
#include "core/station/calibration_command.h"

namespace mirrorarm::station {

/// One frame and the board in it. Made once, shared, never changed.
struct BoardFrame {
  camera::StereoFrame frame;
  calibration::BoardView view;  ///< empty sightings where the board was not found
  bool larger_board = false;    ///< the pattern goes on beyond the board asked for
  calibration::CaptureVerdict verdict = calibration::CaptureVerdict::kNoBoard;
  std::optional<RigidTransform> X_CM;  ///< by the rig in force
  double finding_ms = 0.0;
};

enum class CalibrationPhase : std::uint8_t {
  kIdle,
  kCapturing,
  kSolving,
  kSolved,   ///< `outcome` waits to be accepted or discarded
  kRefused,  ///< `refusal` says why; capturing goes on after kDiscard
  kAccepted,
};
/// "idle", "capturing", ...
[[nodiscard]] std::string_view id(CalibrationPhase phase);

/// A view that was taken.
struct TakenView {
  std::string name;
  calibration::BoardView view;
  std::optional<RigidTransform> X_CM;  ///< by the rig in force when it was taken
  std::optional<RigidTransform> X_BF;  ///< flange at the exposure
  std::optional<double> residual_px;   ///< after solving; hand-eye: of the station
  std::optional<double> residual_m;    ///< hand-eye only
  bool is_outlier = false;             ///< after solving
};

/// What solving gave.
struct StereoOutcome {
  calibration::StereoCalibration result;
  std::optional<calibration::RigComparison> against_in_force;
};
struct HandEyeOutcome {
  calibration::HandEyeSolution result;
  std::optional<double> shift_mm;  ///< against the one in force
  std::optional<double> turn_deg;
};
struct ClockOutcome {
  calibration::ClockOffset result;
};
struct DriftOutcome {
  calibration::DriftFindings findings;
};
using CalibrationOutcome = std::variant<StereoOutcome, HandEyeOutcome, ClockOutcome, DriftOutcome>;

/// All that the wizards' screen needs, taken at its own beat.
struct CalibrationSnapshot {
  CalibrationPhase phase = CalibrationPhase::kIdle;
  CalibrationJob job = CalibrationJob::kStereo;
  calibration::Board board;
  std::shared_ptr<const BoardFrame> frame;  ///< nullptr before the first one
  std::shared_ptr<const std::vector<TakenView>> views;
  std::size_t views_wanted = 0;  ///< with that many, well spread, solving is worth while
  calibration::Coverage coverage;
  std::optional<calibration::ViewWish> proposal;  ///< where to go next
  bool automatic = true;
  bool driving = false;
  bool can_undo = false;
  double progress = 0.0;  ///< of the capturing, or while solving of that, 0..1
  control::ServoState servo;
  std::shared_ptr<const CalibrationOutcome> outcome;  ///< in kSolved and kAccepted
  std::string refusal;  ///< in kRefused: one line for an engineer, with the remedy
  std::string record;   ///< in kAccepted: the record's name in the folder
  CalibrationAnswer last_answer = CalibrationAnswer::kAccepted;
  std::uint32_t answers = 0;  ///< commands answered since the start
};

}  // namespace mirrorarm::station
