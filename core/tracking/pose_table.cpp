#include "core/tracking/pose_table.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/common/csv.h"
#include "core/tracking/tracked_target.h"

namespace mirrorarm::tracking {
namespace {

constexpr std::array<std::string_view, 10> kColumns{"index", "target", "status", "tx_m", "ty_m",
                                                    "tz_m",  "qx",     "qy",     "qz",   "qw"};
constexpr std::size_t kFirstNumber = 3;

bool isStatus(std::string_view text) {
  return text == id(TrackStatus::kTracked) || text == id(TrackStatus::kPredicted) ||
         text == id(TrackStatus::kLost);
}

FromFile<RigidTransform> readPose(const CsvTable& table, const CsvRow& row, const std::vector<int>& columns) {
  std::array<double, 7> n{};
  for (std::size_t k = 0; k < n.size(); ++k) {
    const auto number = table.number(row, columns[kFirstNumber + k]);
    if (!number) return unexpected(number.error());
    n[k] = *number;
  }
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  if (!(std::abs(q.norm() - 1.0) < 0.01))
    return unexpected(FileError{table.file(), row.line, "qx..qw are not a unit quaternion"});
  return makeTransform(q, Eigen::Vector3d(n[0], n[1], n[2]));
}

/// Takes rows in their order.
class Reader {
 public:
  Reader(const CsvTable& table, std::vector<int> columns) : table_(table), columns_(std::move(columns)) {}

  [[nodiscard]] std::optional<FileError> take(const CsvRow& row) {
    const auto index = table_.integer(row, columns_[0]);
    if (!index) return index.error();
    if (!frames.empty() && *index < index_) return FileError{table_.file(), row.line, "index falls"};
    if (frames.empty() || *index > index_) frames.emplace_back();
    index_ = *index;
    const auto& status = row.cells[static_cast<std::size_t>(columns_[2])];
    if (!isStatus(status)) return FileError{table_.file(), row.line, "status '" + status + "' is none"};
    if (status != id(TrackStatus::kTracked)) return std::nullopt;
    const auto X_CT = readPose(table_, row, columns_);
    if (!X_CT) return X_CT.error();
    const auto& target = row.cells[static_cast<std::size_t>(columns_[1])];
    if (!frames.back().emplace(target, *X_CT).second)
      return FileError{table_.file(), row.line, "target '" + target + "' stands twice in one frame"};
    return std::nullopt;
  }

  std::vector<TrackedPoses> frames;

 private:
  const CsvTable& table_;
  std::vector<int> columns_;
  long long index_ = 0;  // of the last frame
};

}  // namespace

FromFile<std::vector<TrackedPoses>> readTrackedPoses(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file);
  if (!table) return unexpected(table.error());
  const auto columns = table->columns(kColumns);
  if (!columns) return unexpected(columns.error());
  Reader reader(*table, *columns);
  for (const CsvRow& row : table->rows())
    if (const auto refused = reader.take(row)) return unexpected(*refused);
  return std::move(reader.frames);
}

}  // namespace mirrorarm::tracking
