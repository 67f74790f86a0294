#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/calibration/board.h"
#include "core/camera/camera_model.h"

namespace mirrorarm::station {

/// What is calibrated.
enum class CalibrationJob : std::uint8_t {
  kStereo,   ///< both lenses and the bar between them
  kHandEye,  ///< the camera on the flange
  kClock,    ///< the camera's clock against the robot's
  kDrift,    ///< whether what is in force still holds
};
inline constexpr std::size_t kCalibrationJobCount = 4;
/// "stereo", "hand_eye", "clock", "drift".
[[nodiscard]] std::string_view id(CalibrationJob job);

enum class CalibrationAction : std::uint8_t {
  kBegin,         ///< `job`, `board`, `model`; forgets what was captured before
  kCapture,       ///< takes the view before the cameras, if the board is seen and still
  kSetAutomatic,  ///< `on`: views are taken by themselves when still and new
  kSetDriving,    ///< `on`: the robot goes to the proposed views by itself; off brings it to rest
  kRemoveView,    ///< `view`
  kUndoRemove,    ///< brings the view removed last back
  kSolve,
  kAccept,   ///< writes the result and puts it in force
  kDiscard,  ///< back to capturing, the views kept
  kCancel,   ///< ends the job; nothing is written
};

/// One wish of the engineer. Stopping is not among them: CalibrationPort::stop() goes past every queue.
struct CalibrationCommand {
  CalibrationAction action = CalibrationAction::kBegin;
  CalibrationJob job = CalibrationJob::kStereo;
  calibration::Board board{};
  std::optional<camera::LensModel> model{};  ///< nothing: chosen by the error on views kept out
  std::size_t view = 0;                      ///< index into CalibrationSnapshot::views
  bool on = false;
};

/// What became of a wish.
enum class CalibrationAnswer : std::uint8_t {
  kAccepted,
  kNotNow,         ///< not allowed in this phase
  kNoBoard,        ///< capturing needs the board in view of both cameras
  kMoving,         ///< and still
  kNoRobot,        ///< driving needs a robot at rest that answers
  kNotEnabled,     ///< driving needs the enabling device to be held
  kStopLatched,    ///< reset the stop first
  kNoCalibration,  ///< hand-eye, clock and drift need the calibrations before them
  kNotWritten,     ///< the folder of the calibrations refuses the record
  kQueueFull,      ///< refused at once; ask again
};
/// "accepted", "not_now", ...
[[nodiscard]] std::string_view id(CalibrationAnswer answer);

}  // namespace mirrorarm::station
