#include "core/control/beat.h"

#include <algorithm>
#include <cmath>

namespace mirrorarm::control {
namespace {

constexpr double kFarOff_s = 0.050;
constexpr double kCatchUp_1_s = 1.0;  // hurry for each second that the beat is behind
constexpr double kMostHurry = 0.02;
constexpr double kMostChange_1_s = 0.1;  // of the hurry: 0.024 rad/s^2 at 0.24 rad/s

}  // namespace

TimePoint Beat::next(TimePoint now) noexcept {
  const double behind = running_ ? secondsBetween(last_ + toClock(period_), now) : 0.0;
  if (!running_ || std::abs(behind) > kFarOff_s) {
    running_ = true;
    hurry_ = 0.0;
    return last_ = now;
  }
  const double wanted = std::clamp(kCatchUp_1_s * behind, -kMostHurry, kMostHurry);
  const double change = kMostChange_1_s * period_.count();
  hurry_ += std::clamp(wanted - hurry_, -change, change);
  return last_ += toClock((1.0 + hurry_) * period_);
}

}  // namespace mirrorarm::control
