#include "core/calibration/pose_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/common/atomic_file.h"
#include "core/common/csv.h"

namespace mirrorarm::calibration {
namespace {

constexpr std::array<std::string_view, 14> kColumns = {"bx_m", "by_m", "bz_m", "bqx", "bqy", "bqz", "bqw",
                                                       "cx_m", "cy_m", "cz_m", "cqx", "cqy", "cqz", "cqw"};
constexpr double kNormTolerance = 0.01;

/// Seven numbers: a position and a quaternion x, y, z, w.
FromFile<RigidTransform> pose(const CsvTable& table, const CsvRow& row, std::span<const int> columns) {
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto number = table.number(row, columns[i]);
    if (!number) return unexpected(number.error());
    v[i] = *number;
  }
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1.0) <= kNormTolerance) return makeTransform(q, Eigen::Vector3d(v[0], v[1], v[2]));
  const auto first = table.header()[static_cast<std::size_t>(columns[3])];
  return unexpected(
      FileError{table.file(), row.line, "the quaternion from " + first + " on is not of unit norm"});
}

FromFile<PosePair> pair(const CsvTable& table, const CsvRow& row, std::span<const int> columns) {
  const auto X_BF = pose(table, row, columns.first(7));
  if (!X_BF) return unexpected(X_BF.error());
  const auto X_CM = pose(table, row, columns.last(7));
  if (!X_CM) return unexpected(X_CM.error());
  return PosePair{*X_BF, *X_CM};
}

FromFile<void> refuseUnknownColumns(const CsvTable& table) {
  for (const auto& name : table.header())
    if (std::find(kColumns.begin(), kColumns.end(), name) == kColumns.end())
      return unexpected(FileError{table.file(), 1, "column '" + name + "' is unknown"});
  return {};
}

void writePose(std::ostream& out, const RigidTransform& X) {
  const auto q = rotationOf(X);
  for (const double v : {X.translation().x(), X.translation().y(), X.translation().z(), q.x(), q.y(), q.z()})
    out << v << ',';
  out << q.w();
}

}  // namespace

FromFile<std::vector<PosePair>> readPosePairs(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file);
  if (!table) return unexpected(table.error());
  if (const auto known = refuseUnknownColumns(*table); !known) return unexpected(known.error());
  const auto columns = table->columns(kColumns);
  if (!columns) return unexpected(columns.error());
  std::vector<PosePair> pairs;
  for (const auto& row : table->rows()) {
    const auto read = pair(*table, row, *columns);
    if (!read) return unexpected(read.error());
    pairs.push_back(*read);
  }
  return pairs;
}

Expected<void, std::string> writePosePairs(const std::filesystem::path& file,
                                           std::span<const PosePair> pairs) {
  return writeWhole(file, [pairs](std::ostream& out) {
    for (const auto name : kColumns) out << name << (name == kColumns.back() ? '\n' : ',');
    for (const auto& [X_BF, X_CM] : pairs) {
      writePose(out, X_BF);
      out << ',';
      writePose(out, X_CM);
      out << '\n';
    }
  });
}

}  // namespace mirrorarm::calibration
