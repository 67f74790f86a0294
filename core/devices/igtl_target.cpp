#include "core/devices/igtl_target.h"

#include <bit>
#include <cmath>

#include "core/devices/big_endian.h"
#include "core/devices/igtl_poses.h"

namespace mirrorarm::devices {
namespace {

constexpr std::string_view kSensor = "SENSOR";
constexpr std::size_t kNumbersAt = 10;  // behind their count, the sensor's status and its unit
constexpr Eigen::Index kSize = 6;
constexpr std::size_t kTriangle = kSize * (kSize + 1) / 2;

void appendNumber(std::vector<std::byte>& bytes, double value) {
  appendBigEndian(bytes, std::bit_cast<std::uint64_t>(value));
}

IgtlMessage sensorMessage(const TargetReport& report) {
  IgtlMessage message{std::string(kSensor), report.name, report.time_s, {}};
  const bool lost = report.sight == TargetSight::kLost;
  message.content.assign(kNumbersAt, std::byte{0});
  message.content[0] = static_cast<std::byte>(lost ? 1 : 1 + kTriangle);
  appendNumber(message.content, static_cast<double>(report.sight));
  for (Eigen::Index row = 0; !lost && row < kSize; ++row)
    for (Eigen::Index column = row; column < kSize; ++column)
      appendNumber(message.content, report.covariance(row, column));
  return message;
}

double numberAt(const IgtlMessage& message, std::size_t i) {
  return std::bit_cast<double>(
      bigEndian<std::uint64_t>(std::span(message.content).subspan(kNumbersAt + 8 * i)));
}

}  // namespace

std::vector<std::byte> igtlBytes(const TargetReport& report) {
  std::vector<std::byte> bytes;
  if (report.sight != TargetSight::kLost)
    bytes = igtlBytes(transformMessage({report.name, report.time_s, report.X}));
  const auto sensor = igtlBytes(sensorMessage(report));
  bytes.insert(bytes.end(), sensor.begin(), sensor.end());
  return bytes;
}

std::optional<TargetReport> targetReportOf(const IgtlMessage& message) {
  if (message.type != kSensor || message.content.size() < kNumbersAt + 8) return std::nullopt;
  const auto count = std::to_integer<std::size_t>(message.content[0]);
  if (message.content.size() != kNumbersAt + 8 * count) return std::nullopt;
  const double sight = numberAt(message, 0);
  if (sight != 0.0 && sight != 1.0 && sight != 2.0) return std::nullopt;
  TargetReport report{message.device, message.time_s, static_cast<TargetSight>(sight)};
  if (count != (report.sight == TargetSight::kLost ? 1 : 1 + kTriangle)) return std::nullopt;
  std::size_t next = 1;
  for (Eigen::Index row = 0; next < count && row < kSize; ++row)
    for (Eigen::Index column = row; column < kSize; ++column)
      report.covariance(row, column) = report.covariance(column, row) = numberAt(message, next++);
  if (!report.covariance.allFinite()) return std::nullopt;
  return report;
}

}  // namespace mirrorarm::devices
