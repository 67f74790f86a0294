#pragma once

#include <cstdint>
#include <string_view>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/control/force_limits.h"

namespace mirrorarm::control {

/// How near the force is to what the region may bear.
enum class ForceLevel : std::uint8_t {
  kCalm,
  kWarning,  ///< shown
  kSoften,   ///< the robot gives way as far as its link lets it
  kTooMuch,  ///< stop
};
/// "calm", "warning", "soften", "too_much".
[[nodiscard]] std::string_view id(ForceLevel level);

struct ForceSettings {
  BodyRegion region = BodyRegion::kForearm;  ///< where the sling holds the patient
  double share = 0.5;                        ///< of the region's limits that the plan allows, above 0 to 1
  double warning_share = 0.6;                ///< of what is allowed
  double soften_share = 0.8;
};

/// The force at the sling.
struct ForceReading {
  bool known = false;  ///< the robot measures torques
  Eigen::Vector3d force_B_n = Eigen::Vector3d::Zero();
  double limit_share = 0.0;  ///< of what is allowed, the larger of lasting and transient; 1: stop
  ForceLevel level = ForceLevel::kCalm;
};

/// Smooths the force and holds it against the limits of a body region: at once against the transient one,
/// and what lasts (time constant 0.25 s: twice the lasting limit is reached after 0.17 s, a tenth more than
/// it after 0.6 s) against the lasting one. One thread; does not allocate.
class ForceWatch {
 public:
  explicit ForceWatch(const ForceSettings& settings);

  /// A force that is not finite is too much.
  const ForceReading& update(const Eigen::Vector3d& force_B_n, Seconds period) noexcept;
  /// The robot tells no torques.
  const ForceReading& forget() noexcept;
  [[nodiscard]] const ForceReading& reading() const noexcept { return reading_; }

 private:
  [[nodiscard]] ForceLevel levelOf(double share) const noexcept;
  ForceSettings settings_;
  RegionLimits allowed_;
  ForceReading reading_;
  Eigen::Vector3d lasting_B_n_ = Eigen::Vector3d::Zero();
};

}  // namespace mirrorarm::control
