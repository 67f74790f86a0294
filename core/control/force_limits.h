#pragma once

#include <cstdint>
#include <string_view>

namespace mirrorarm::control {

/// Where the sling holds the patient, or what the arm may touch.
enum class BodyRegion : std::uint8_t { kHand, kForearm, kUpperArm, kShoulder, kHead, kFace };
inline constexpr int kBodyRegionCount = static_cast<int>(BodyRegion::kFace) + 1;
/// "hand", "forearm", "upper_arm", "shoulder", "head", "face".
[[nodiscard]] std::string_view id(BodyRegion region);

/// The force that a contact with this region may have.
struct RegionLimits {
  double quasi_static_n = 0.0;  ///< that lasts
  double transient_n = 0.0;     ///< within half a second
};

/// ISO/TS 15066:2016, table A.2 (in ISO 10218-2:2025), N. Skull and face have no transient allowance:
///
/// |           | region of the table          | lasting | transient |
/// |-----------|------------------------------|---------|-----------|
/// | hand      | hands and fingers            |     140 |       280 |
/// | forearm   | lower arms and wrist joints  |     160 |       320 |
/// | upper arm | upper arms and elbow joints  |     150 |       300 |
/// | shoulder  | back and shoulders           |     210 |       420 |
/// | head      | skull and forehead           |     130 |       130 |
/// | face      | face                         |      65 |        65 |
///
/// These are thresholds of pain in healthy adults, not of comfort, and a limb after a stroke may feel
/// nothing: a plan allows a share of them (ForceSettings).
[[nodiscard]] RegionLimits limitsOf(BodyRegion region) noexcept;

}  // namespace mirrorarm::control
