#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/calibration/clock_offset.h"
#include "core/common/csv.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::array<std::string_view, 7> kPoseColumns = {"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"};
constexpr double kNormTolerance = 0.01;
constexpr double kNanosecond_s = 1e-9;

/// Where time and pose stand in a row.
struct Layout {
  int time = 0;
  double time_unit_s = 1.0;
  std::array<int, 7> pose{1, 2, 3, 4, 5, 6, 7};
};

bool isHeaderless(const CsvTable& table) {
  double number = 0.0;
  return parseNumber(table.header()[0], number);
}

FromFile<Layout> layoutOf(const CsvTable& table) {
  Layout layout;
  if (isHeaderless(table)) {
    if (table.header().size() == 8) return layout;
    return unexpected(FileError{
        table.file(), 1,
        "has no header and " + std::to_string(table.header().size()) + " cells: t,x,y,z,qx,qy,qz,qw are 8"});
  }
  layout.time = table.column("time_s");
  if (layout.time < 0) {
    layout.time = table.column("time_ns");
    layout.time_unit_s = kNanosecond_s;
  }
  if (layout.time < 0) return unexpected(FileError{table.file(), 1, "has no column time_s or time_ns"});
  const auto columns = table.columns(kPoseColumns);
  if (!columns) return unexpected(columns.error());
  std::copy(columns->begin(), columns->end(), layout.pose.begin());
  return layout;
}

FromFile<double> numberIn(const CsvTable& table, const CsvRow& row, int column, std::string_view name) {
  double value = 0.0;
  const auto& cell = row.cells[static_cast<std::size_t>(column)];
  if (parseNumber(cell, value)) return value;
  return unexpected(
      FileError{table.file(), row.line, std::string(name) + " is not a finite number: '" + cell + "'"});
}

bool hasNoPose(const CsvRow& row, const Layout& layout) {
  return std::any_of(layout.pose.begin(), layout.pose.end(),
                     [&row](int column) { return row.cells[static_cast<std::size_t>(column)].empty(); });
}

FromFile<TimedPose> timedPose(const CsvTable& table, const CsvRow& row, const Layout& layout) {
  const auto time = numberIn(table, row, layout.time, "the time");
  if (!time) return unexpected(time.error());
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto number = numberIn(table, row, layout.pose[i], kPoseColumns[i]);
    if (!number) return unexpected(number.error());
    v[i] = *number;
  }
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1.0) > kNormTolerance)
    return unexpected(FileError{table.file(), row.line, "the quaternion is not of unit norm"});
  return TimedPose{*time * layout.time_unit_s, makeTransform(q, Eigen::Vector3d(v[0], v[1], v[2]))};
}

/// The rows of numbers; without a header its line is the first of them.
std::vector<CsvRow> rowsOf(const CsvTable& table) {
  std::vector<CsvRow> rows;
  if (isHeaderless(table)) rows.push_back({1, {table.header().begin(), table.header().end()}});
  rows.insert(rows.end(), table.rows().begin(), table.rows().end());
  return rows;
}

}  // namespace

FromFile<std::vector<TimedPose>> readPoseStream(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file);
  if (!table) return unexpected(table.error());
  const auto layout = layoutOf(*table);
  if (!layout) return unexpected(layout.error());
  std::vector<TimedPose> poses;
  for (const auto& row : rowsOf(*table)) {
    if (hasNoPose(row, *layout)) continue;
    const auto pose = timedPose(*table, row, *layout);
    if (!pose) return unexpected(pose.error());
    if (poses.empty() || pose->time_s > poses.back().time_s)
      poses.push_back(*pose);
    else if (pose->time_s < poses.back().time_s)
      return unexpected(FileError{file, row.line, "the time is before the one above"});
  }
  return poses;
}

}  // namespace mirrorarm::calibration
