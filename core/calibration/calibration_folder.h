#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/calibration/clock_file.h"
#include "core/calibration/drift_file.h"
#include "core/calibration/hand_eye_file.h"
#include "core/camera/stereo_rig.h"
#include "core/common/file_error.h"

namespace mirrorarm::calibration {

/// The calibrations in force, as a session takes them.
struct InForce {
  std::optional<camera::StereoRig> rig;
  std::optional<HandEye> hand_eye;
  std::optional<ClockRecord> clock;
  std::optional<DriftRecord> drift;  ///< the newest check of rig and hand-eye

  [[nodiscard]] bool empty() const { return !rig && !hand_eye && !clock && !drift; }
};

/// The four things that a workstation calibrates or checks.
enum class CalibrationKind : std::uint8_t { kRig, kHandEye, kClock, kDrift };
inline constexpr std::size_t kCalibrationKindCount = 4;
inline constexpr std::array<CalibrationKind, kCalibrationKindCount> kCalibrationKinds = {
    CalibrationKind::kRig, CalibrationKind::kHandEye, CalibrationKind::kClock, CalibrationKind::kDrift};
/// "rig", "hand_eye", "clock", "drift".
[[nodiscard]] std::string_view id(CalibrationKind kind);

/// What can be put in force, in the order of CalibrationKind.
using CalibrationRecord = std::variant<camera::StereoRig, HandEye, ClockRecord, DriftRecord>;

/// Where a workstation keeps its calibrations. records/ holds every one that was accepted, a folder each that
/// never changes, named by date and kind; in_force.yaml (format mirrorarm/in-force/1) names those that are
/// used. A record is written whole before it is named, so that a power cut leaves the old one in force.
class CalibrationFolder {
 public:
  explicit CalibrationFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

  /// Nothing in force where the folder is empty or not there. Refused: what is named but cannot be read.
  [[nodiscard]] FromFile<InForce> read() const;

  /// An empty folder under work/ for the images of a calibration that is going on; accept() makes it part of
  /// the record, whoever gives up removes it. The error is the reason.
  [[nodiscard]] Expected<std::filesystem::path, std::string> makeWorkFolder() const;

  /// Writes `record`, with what `work_folder` holds (of this folder's; none where empty), and puts it in
  /// force. What belonged to the one before goes out of force: hand-eye and drift check with a new rig, the
  /// drift check with a new hand-eye. Gives the record's name; the error is the reason, nothing has changed
  /// then.
  [[nodiscard]] Expected<std::string, std::string> accept(
      const CalibrationRecord& record, const std::filesystem::path& work_folder = {}) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace mirrorarm::calibration
