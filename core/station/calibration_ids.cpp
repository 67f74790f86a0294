#include "core/station/calibration_command.h"
#include "core/station/calibration_snapshot.h"

namespace mirrorarm::station {

std::string_view id(CalibrationJob job) {
  switch (job) {
    case CalibrationJob::kStereo:
      return "stereo";
    case CalibrationJob::kHandEye:
      return "hand_eye";
    case CalibrationJob::kClock:
      return "clock";
    case CalibrationJob::kDrift:
      return "drift";
  }
  return "unknown";
}

std::string_view id(CalibrationAnswer answer) {
  switch (answer) {
    case CalibrationAnswer::kAccepted:
      return "accepted";
    case CalibrationAnswer::kNotNow:
      return "not_now";
    case CalibrationAnswer::kNoBoard:
      return "no_board";
    case CalibrationAnswer::kMoving:
      return "moving";
    case CalibrationAnswer::kNoRobot:
      return "no_robot";
    case CalibrationAnswer::kNotEnabled:
      return "not_enabled";
    case CalibrationAnswer::kStopLatched:
      return "stop_latched";
    case CalibrationAnswer::kNoCalibration:
      return "no_calibration";
    case CalibrationAnswer::kNotWritten:
      return "not_written";
    case CalibrationAnswer::kQueueFull:
      return "queue_full";
  }
  return "unknown";
}

std::string_view id(CalibrationPhase phase) {
  switch (phase) {
    case CalibrationPhase::kIdle:
      return "idle";
    case CalibrationPhase::kCapturing:
      return "capturing";
    case CalibrationPhase::kSolving:
      return "solving";
    case CalibrationPhase::kSolved:
      return "solved";
    case CalibrationPhase::kRefused:
      return "refused";
    case CalibrationPhase::kAccepted:
      return "accepted";
  }
  return "unknown";
}

}  // namespace mirrorarm::station
