#include "core/control/force_watch.h"

#include <algorithm>
#include <cassert>

namespace mirrorarm::control {
namespace {

constexpr Seconds kNoise{0.010};    // the torque sensors' noise lies above this
constexpr Seconds kLasting{0.250};  // TS 15066 calls transient what is over within half a second

void smooth(Eigen::Vector3d& value, const Eigen::Vector3d& news, Seconds period, Seconds constant) {
  value += period / (period + constant) * (news - value);
}

}  // namespace

std::string_view id(ForceLevel level) {
  switch (level) {
    case ForceLevel::kCalm:
      return "calm";
    case ForceLevel::kWarning:
      return "warning";
    case ForceLevel::kSoften:
      return "soften";
    case ForceLevel::kTooMuch:
      return "too_much";
  }
  return "unknown";
}

ForceWatch::ForceWatch(const ForceSettings& settings)
    : settings_(settings), allowed_(limitsOf(settings.region)) {
  assert(settings.share > 0.0 && settings.share <= 1.0);
  allowed_.quasi_static_n *= settings.share;
  allowed_.transient_n *= settings.share;
}

const ForceReading& ForceWatch::update(const Eigen::Vector3d& force_B_n, Seconds period) noexcept {
  reading_.known = true;
  if (!force_B_n.allFinite()) {
    reading_.limit_share = 1.0;
    reading_.level = ForceLevel::kTooMuch;
    return reading_;
  }
  smooth(reading_.force_B_n, force_B_n, period, kNoise);
  smooth(lasting_B_n_, force_B_n, period, kLasting);
  reading_.limit_share = std::max(reading_.force_B_n.norm() / allowed_.transient_n,
                                  lasting_B_n_.norm() / allowed_.quasi_static_n);
  reading_.level = levelOf(reading_.limit_share);
  return reading_;
}

const ForceReading& ForceWatch::forget() noexcept {
  lasting_B_n_.setZero();
  return reading_ = {};
}

ForceLevel ForceWatch::levelOf(double share) const noexcept {
  if (!(share < 1.0)) return ForceLevel::kTooMuch;
  if (share >= settings_.soften_share) return ForceLevel::kSoften;
  return share >= settings_.warning_share ? ForceLevel::kWarning : ForceLevel::kCalm;
}

}  // namespace mirrorarm::control
