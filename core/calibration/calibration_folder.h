#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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
  std::optional<DriftRecord> drift;  ///< the newest check of them
};

/// Where a workstation keeps its calibrations: records/ holds every one that was accepted, a folder each,
/// which never changes; in_force.yaml names those that are used. A record is written whole before it is
/// named, so that a power cut leaves the old one in force.
class CalibrationFolder {
 public:
  explicit CalibrationFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Nothing in force where the folder is empty or not there. Refused: files that cannot be read.
  [[nodiscard]] FromFile<InForce> read() const;

  /// A new folder for the images of a calibration that is going on, under work/; it becomes part of the
  /// record.
  [[nodiscard]] Expected<std::filesystem::path, std::string> makeWorkFolder(const std::string& name) const;

  /// Writes a record, with what `work_folder` holds (may be empty), and puts it in force. A new rig takes
  /// hand-eye, and a new rig or hand-eye takes the drift check, out of force: they belonged to the old one.
  /// Gives the record's name; the error is the reason.
  [[nodiscard]] Expected<std::string, std::string> accept(const camera::StereoRig& rig,
                                                          const std::filesystem::path& work_folder) const;
  [[nodiscard]] Expected<std::string, std::string> accept(const HandEye& hand_eye,
                                                          const std::filesystem::path& work_folder) const;
  [[nodiscard]] Expected<std::string, std::string> accept(const ClockRecord& clock,
                                                          const std::filesystem::path& work_folder) const;
  [[nodiscard]] Expected<std::string, std::string> accept(const DriftRecord& drift,
                                                          const std::filesystem::path& work_folder) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace mirrorarm::calibration
