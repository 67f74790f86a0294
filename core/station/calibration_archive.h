#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/calibration/calibration_folder.h"
#include "core/calibration/pose_pairs.h"
#include "core/camera/stereo_frame.h"

namespace mirrorarm::station {

/// The images of one job, written as they come, and the record they become part of. What was not accepted is
/// removed with the archive. One thread at a time; it works on the disc.
class CalibrationArchive {
 public:
  /// An empty `folder`: nothing is kept and nothing can be accepted.
  explicit CalibrationArchive(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~CalibrationArchive();
  CalibrationArchive(const CalibrationArchive&) = delete;
  CalibrationArchive& operator=(const CalibrationArchive&) = delete;

  /// Keeps both images of a view as left_<name>.png and right_<name>.png. The error is the reason.
  [[nodiscard]] Expected<void, std::string> keep(const std::string& name, const camera::StereoFrame& frame);

  /// Writes the record with the images but for those of the views called `removed`, and with pose_pairs.csv
  /// where there are any, and puts it in force. Gives the record's name; the error is the reason.
  [[nodiscard]] Expected<std::string, std::string> accept(const calibration::CalibrationRecord& record,
                                                          std::span<const std::string> removed,
                                                          std::span<const calibration::PosePair> pairs);

 private:
  [[nodiscard]] Expected<void, std::string> needWorkFolder();
  [[nodiscard]] Expected<void, std::string> dropImages(std::span<const std::string> removed) const;
  calibration::CalibrationFolder folder_;
  std::filesystem::path work_folder_;  ///< empty before the first image and once it belongs to a record
};

}  // namespace mirrorarm::station
