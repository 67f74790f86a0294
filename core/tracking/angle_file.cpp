#include "core/tracking/angle_file.h"

#include <algorithm>
#include <ostream>

#include "core/common/atomic_file.h"

namespace mirrorarm::tracking {
namespace {

constexpr int kNumbers = 2 * static_cast<int>(kArmAngles) + 2;

/// What one frame's answers say of the targets that an arm needs.
class ArmInFrame {
 public:
  ArmInFrame(const ArmModel& model, std::span<const PoseRow> frame) : model_(model), frame_(frame) {}

  [[nodiscard]] AngleRow row() {
    AngleRow row{frame_.front().index, frame_.front().answer.exposed_at, TrackStatus::kTracked, {}};
    const Orientation upper_arm = orientationOf(model_.upper_arm, row.status);
    const Orientation forearm = orientationOf(model_.forearm, row.status);
    const Orientation reference =
        model_.thorax.empty() ? Orientation{} : orientationOf(model_.thorax, row.status);
    if (row.status != TrackStatus::kLost) row.angles = armAngles(model_, upper_arm, forearm, reference);
    return row;
  }

 private:
  /// Makes `status` the worse of itself and the target's.
  [[nodiscard]] Orientation orientationOf(const std::string& target, TrackStatus& status) const {
    const auto found = std::ranges::find(frame_, target, &PoseRow::target);
    if (found == frame_.end()) {
      status = TrackStatus::kLost;
      return {};
    }
    status = std::max(status, found->answer.status);
    return {found->answer.X_CT.linear(), found->answer.covariance.topLeftCorner<3, 3>()};
  }

  const ArmModel& model_;
  std::span<const PoseRow> frame_;
};

void writeNumbers(std::ostream& out, const ArmAngles& angles) {
  for (const double value : angles.value_rad) out << ',' << value;
  for (const double sigma : angles.sigma_rad) out << ',' << sigma;
  out << ',' << angles.shoulder_singular << ',' << angles.elbow_singular;
}

}  // namespace

std::vector<AngleRow> angleRows(const ArmModel& model, std::span<const PoseRow> poses) {
  std::vector<AngleRow> rows;
  for (auto begin = poses.begin(); begin != poses.end();) {
    const auto end =
        std::find_if(begin, poses.end(), [begin](const PoseRow& row) { return row.index != begin->index; });
    rows.push_back(ArmInFrame(model, {begin, end}).row());
    begin = end;
  }
  return rows;
}

Expected<void, std::string> writeAngles(const std::filesystem::path& file, std::span<const AngleRow> rows) {
  return writeWhole(file, [rows](std::ostream& out) {
    out << "index,time_ns,status";
    for (std::size_t k = 0; k < kArmAngles; ++k) out << ',' << id(static_cast<ArmAngle>(k)) << "_rad";
    for (std::size_t k = 0; k < kArmAngles; ++k) out << ",sigma_" << id(static_cast<ArmAngle>(k)) << "_rad";
    out << ",shoulder_singular,elbow_singular\n";
    for (const AngleRow& row : rows) {
      out << row.index << ',' << toNanoseconds(row.exposed_at) << ',' << id(row.status);
      if (row.status == TrackStatus::kLost)
        out << std::string(kNumbers, ',');
      else
        writeNumbers(out, row.angles);
      out << '\n';
    }
  });
}

}  // namespace mirrorarm::tracking
