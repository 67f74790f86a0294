#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/common/expected.h"
#include "core/vision/detected_marker.h"

namespace mirrorarm::vision {

/// One disc of one image.
struct CentreRow {
  long long index = 0;  ///< of the frame, or of the image among those given
  std::string camera;   ///< "left", "right", or the image's file name
  DetectedMarker marker;
};

/// Writes `centres.csv`, whole or not at all. `major_px` and `minor_px` are whole axes, from outline to
/// outline.
[[nodiscard]] Expected<void, std::string> writeCentres(const std::filesystem::path& file,
                                                       std::span<const CentreRow> rows);

}  // namespace mirrorarm::vision
