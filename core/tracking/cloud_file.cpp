#include "core/tracking/cloud_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/common/csv.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"index", "time_ns", "x_m", "y_m", "z_m"};

bool holdsNoPoint(const CsvRow& row, const std::vector<int>& columns) {
  return std::all_of(columns.begin() + 2, columns.end(), [&row](int column) {
    const auto& cell = row.cells[static_cast<std::size_t>(column)];
    return cell.empty() || cell == "nan" || cell == "NaN";
  });
}

FromFile<Eigen::Vector3d> readPoint(const CsvTable& table, const CsvRow& row,
                                    const std::vector<int>& columns) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = table.number(row, columns[axis + 2]);
    if (!value) return unexpected(value.error());
    p[static_cast<Eigen::Index>(axis)] = *value;
  }
  return p;
}

/// The frame that a row belongs to: the last one, or a new one after it.
FromFile<Cloud*> frameOf(const CsvTable& table, const CsvRow& row, const std::vector<int>& columns,
                         std::vector<Cloud>& clouds) {
  const auto index = table.integer(row, columns[0]);
  if (!index) return unexpected(index.error());
  const auto time_ns = table.integer(row, columns[1]);
  if (!time_ns) return unexpected(time_ns.error());
  const TimePoint time = fromNanoseconds(*time_ns);
  const bool same = !clouds.empty() && clouds.back().index == *index;
  if (same && clouds.back().exposed_at != time)
    return unexpected(FileError{table.file(), row.line, "time_ns differs from that of the same index above"});
  if (!same && !clouds.empty() && (*index < clouds.back().index || time <= clouds.back().exposed_at))
    return unexpected(FileError{table.file(), row.line, "index or time_ns does not rise"});
  if (!same) clouds.push_back({*index, time, {}});
  return &clouds.back();
}

}  // namespace

FromFile<std::vector<Cloud>> readClouds(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file);
  if (!table) return unexpected(table.error());
  const auto columns = table->columns(kColumns);
  if (!columns) return unexpected(columns.error());
  std::vector<Cloud> clouds;
  for (const auto& row : table->rows()) {
    const auto cloud = frameOf(*table, row, *columns, clouds);
    if (!cloud) return unexpected(cloud.error());
    if (holdsNoPoint(row, *columns)) continue;
    const auto point = readPoint(*table, row, *columns);
    if (!point) return unexpected(point.error());
    (*cloud)->points_C.push_back(*point);
  }
  if (clouds.empty()) return unexpected(FileError{file, 0, "holds no frame"});
  return clouds;
}

}  // namespace mirrorarm::tracking
