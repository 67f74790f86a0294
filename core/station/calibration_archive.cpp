#include "core/station/calibration_archive.h"

#include <system_error>

#include "core/camera/image_file.h"

namespace mirrorarm::station {
namespace {

std::filesystem::path imageFile(const std::filesystem::path& folder, const char* side,
                                const std::string& name) {
  return folder / (std::string(side) + "_" + name + ".png");
}

}  // namespace

CalibrationArchive::~CalibrationArchive() {
  std::error_code left_behind;  // an empty corner of the disc harms nobody
  if (!work_folder_.empty()) std::filesystem::remove_all(work_folder_, left_behind);
}

Expected<void, std::string> CalibrationArchive::needWorkFolder() {
  if (!work_folder_.empty()) return {};
  auto made = folder_.makeWorkFolder();
  if (!made) return unexpected(made.error());
  work_folder_ = std::move(*made);
  return {};
}

Expected<void, std::string> CalibrationArchive::keep(const std::string& name,
                                                     const camera::StereoFrame& frame) {
  if (folder_.path().empty()) return {};
  if (auto there = needWorkFolder(); !there) return there;
  if (auto left = camera::writeImage(imageFile(work_folder_, "left", name), frame.left); !left) return left;
  return camera::writeImage(imageFile(work_folder_, "right", name), frame.right);
}

Expected<void, std::string> CalibrationArchive::dropImages(std::span<const std::string> removed) const {
  for (const auto& name : removed)
    for (const char* side : {"left", "right"}) {
      std::error_code failed;
      const auto file = imageFile(work_folder_, side, name);
      std::filesystem::remove(file, failed);
      if (failed) return unexpected(file.string() + ": " + failed.message());
    }
  return {};
}

Expected<std::string, std::string> CalibrationArchive::accept(const calibration::CalibrationRecord& record,
                                                              std::span<const std::string> removed,
                                                              std::span<const calibration::PosePair> pairs) {
  if (folder_.path().empty()) return unexpected(std::string("no folder for calibrations is set"));
  if (const auto there = needWorkFolder(); !there) return unexpected(there.error());
  if (const auto dropped = dropImages(removed); !dropped) return unexpected(dropped.error());
  if (!pairs.empty())
    if (const auto written = calibration::writePosePairs(work_folder_ / "pose_pairs.csv", pairs); !written)
      return unexpected(written.error());
  auto accepted = folder_.accept(record, work_folder_);
  if (accepted) work_folder_.clear();
  return accepted;
}

}  // namespace mirrorarm::station
