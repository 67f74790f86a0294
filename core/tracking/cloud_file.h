#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "core/common/file_error.h"
#include "core/common/time.h"

namespace mirrorarm::tracking {

/// The measured points of one frame, in no order.
struct Cloud {
  long long index = 0;
  TimePoint exposed_at{};
  std::vector<Eigen::Vector3d> points_C;  ///< [m]
};

/// Reads a table of clouds: columns index, time_ns, x_m, y_m, z_m, a row per point, the rows of one frame
/// together. A row with all three coordinates empty or nan holds no point: so a frame in which nothing was
/// seen is written. Refused: other columns missing, numbers that are not finite, an index or time that does
/// not rise from frame to frame or differs within one, no row at all.
[[nodiscard]] FromFile<std::vector<Cloud>> readClouds(const std::filesystem::path& file);

}  // namespace mirrorarm::tracking
