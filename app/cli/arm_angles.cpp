#include "app/cli/arm_angles.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/tracking/angle_file.h"
#include "core/tracking/arm_file.h"

namespace mirrorarm::cli {
namespace {

constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

/// Lowest and highest of an angle over the frames that have one; null without any.
nlohmann::ordered_json rangeDeg(const std::vector<tracking::AngleRow>& rows, std::size_t angle) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& row : rows) {
    if (row.status == tracking::TrackStatus::kLost) continue;
    low = std::min(low, kRadianInDegrees * row.angles.value_rad[angle]);
    high = std::max(high, kRadianInDegrees * row.angles.value_rad[angle]);
  }
  if (low > high) return nullptr;
  return {low, high};
}

}  // namespace

void addAngleOptions(CLI::App& command, AngleOptions& options) {
  auto* arm = command.add_option("--arm", options.arm, "Bones of the arm, from the command arm");
  auto* angles = command.add_option("--angles", options.angles, "Table of the arm's joint angles to write");
  arm->needs(angles);
  angles->needs(arm);
}

std::optional<tracking::ArmModel> armAskedFor(const AngleOptions& options,
                                              const std::vector<tracking::Target>& targets) {
  if (options.arm.empty()) return std::nullopt;
  const auto arm = orRefuse(tracking::readArm(options.arm)).model;
  for (const std::string& name : {arm.upper_arm, arm.forearm, arm.thorax})
    if (!name.empty() && std::ranges::find(targets, name, &tracking::Target::name) == targets.end())
      throw InputRefused(options.arm.string() + ": target '" + name + "' of the arm is not among --target");
  return arm;
}

nlohmann::ordered_json writeArmAngles(const std::filesystem::path& file, const tracking::ArmModel& arm,
                                      std::span<const tracking::PoseRow> poses) {
  const auto rows = tracking::angleRows(arm, poses);
  orFail(tracking::writeAngles(file, rows));
  const auto known = std::ranges::count_if(
      rows, [](const tracking::AngleRow& row) { return row.status != tracking::TrackStatus::kLost; });
  nlohmann::ordered_json result{{"frames", rows.size()}, {"known", known}};
  for (std::size_t k = 0; k < tracking::kArmAngles; ++k)
    result[std::string(id(static_cast<tracking::ArmAngle>(k))) + "_deg"] = rangeDeg(rows, k);
  return result;
}

}  // namespace mirrorarm::cli
