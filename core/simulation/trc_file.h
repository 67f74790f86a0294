#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/common/file_error.h"

namespace mirrorarm::simulation {

/// Marker positions over time, as a motion-capture system recorded them.
struct MarkerMotion {
  double rate_hz = 0.0;
  std::vector<std::string> markers;
  /// [sample][marker], in the recording's own frame [m]; samples follow each other at rate_hz.
  std::vector<std::vector<Eigen::Vector3d>> positions_m;
};

/// Reads the markers `wanted` of a TRC file (cells by tabs, as the format asks, or by commas, as found in the
/// wild).
///
/// Refused with the line: another PathFileType, one of the eight header keys missing, a rate that is not
/// positive, units other than mm and m, a wanted marker that is missing or named twice, coordinate names that
/// are not X1 Y1 Z1 X2 .., a row with another number of cells, a cell that is neither empty nor a finite
/// number, an empty cell of a wanted marker, frame numbers with a gap, times that do not fit the rate, more
/// rows than NumFrames, fewer than two, a last row without its end. Fewer rows than NumFrames are read:
/// programs cut recordings without mending the header, and gapless frame numbers and complete rows show that
/// what is there is sound.
[[nodiscard]] FromFile<MarkerMotion> readTrc(const std::filesystem::path& file,
                                             std::span<const std::string_view> wanted);

}  // namespace mirrorarm::simulation
