#include "core/control/force_limits.h"

namespace mirrorarm::control {

std::string_view id(BodyRegion region) {
  switch (region) {
    case BodyRegion::kHand:
      return "hand";
    case BodyRegion::kForearm:
      return "forearm";
    case BodyRegion::kUpperArm:
      return "upper_arm";
    case BodyRegion::kShoulder:
      return "shoulder";
    case BodyRegion::kHead:
      return "head";
    case BodyRegion::kFace:
      return "face";
  }
  return "unknown";
}

RegionLimits limitsOf(BodyRegion region) noexcept {
  switch (region) {
    case BodyRegion::kHand:
      return {140.0, 280.0};
    case BodyRegion::kForearm:
      return {160.0, 320.0};
    case BodyRegion::kUpperArm:
      return {150.0, 300.0};
    case BodyRegion::kShoulder:
      return {210.0, 420.0};
    case BodyRegion::kHead:
      return {130.0, 130.0};
    case BodyRegion::kFace:
      break;
  }
  return {65.0, 65.0};
}

}  // namespace mirrorarm::control
