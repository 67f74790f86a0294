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

Expected<void, std::string> CalibrationArchive::keep(const std::string& name,
                                                     const camera::StereoFrame& frame) {
  if (folder_.path().empty()) return {};
  if (work_folder_.empty()) {
    auto made = folder_.makeWorkFolder();
    if (!made) return unexpected(made.error());
    work_folder_ = std::move(*made);
  }
  if (auto left = camera::writeImage(imageFile(work_folder_, "left", name), frame.left); !left) return left;
  return camera::writeImage(imageFile(work_folder_, "right", name), frame.right);
}

Expected<std::string, std::string> CalibrationArchive::accept(const calibration::CalibrationRecord& record,
                                                              std::span<const std::string> removed) {
  if (folder_.path().empty()) return unexpected(std::string("no folder for calibrations is set"));
  for (const auto& name : removed)
    for (const char* side : {"left", "right"}) {
      std::error_code failed;
      std::filesystem::remove(imageFile(work_folder_, side, name), failed);
      if (failed) return unexpected(imageFile(work_folder_, side, name).string() + ": " + failed.message());
    }
  auto accepted = folder_.accept(record, work_folder_);
  if (accepted) work_folder_.clear();
  return accepted;
}

}  // namespace mirrorarm::station
