#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/devices/igtl_message.h"
#include "core/geometry/rigid_transform.h"

namespace mirrorarm::devices {

/// How a target that is told over OpenIGTLink was seen at one instant.
enum class TargetSight : std::uint8_t { kTracked, kPredicted, kLost };

struct TargetReport {
  std::string name;     ///< at most kMostTargetName characters
  double time_s = 0.0;  ///< UTC by the sender's clock, of the exposure
  TargetSight sight = TargetSight::kLost;
  RigidTransform X = RigidTransform::Identity();  ///< of the target in the left camera; good unless lost
  /// Turn [rad] then shift [m], in the target's frame; good unless lost.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

inline constexpr std::size_t kMostTargetName = 20;

/// What a report is on the wire: a SENSOR message of the target's name with the sight and, unless lost, the
/// upper triangle of the covariance row by row; before it, unless lost, a TRANSFORM of that name, which any
/// client understands. Whoever only knows the TRANSFORM never gets a stale one.
[[nodiscard]] std::vector<std::byte> igtlBytes(const TargetReport& report);

/// What the SENSOR message says; the pose comes apart. Nothing for other messages and other numbers.
[[nodiscard]] std::optional<TargetReport> targetReportOf(const IgtlMessage& message);

}  // namespace mirrorarm::devices
