#include "core/control/soft_start.h"

#include <algorithm>

namespace mirrorarm::control {
namespace {

constexpr double kLeastShare = 0.01;  // a limit of nothing would be no limit but a brake

}  // namespace

void SoftStart::begin(const robot::Commanded& last, const robot::MotionLimits& limits) noexcept {
  share_ = kLeastShare;
  for (Eigen::Index j = 0; j < last.v_rad_s.size(); ++j)
    share_ = std::max(share_, std::abs(last.v_rad_s[j]) / limits.max_speed_rad_s[j]);
  share_ = std::min(share_, 1.0);
}

void SoftStart::advance(Seconds period) noexcept {
  share_ = duration_ > period ? std::min(1.0, share_ + period / duration_) : 1.0;
}

robot::MotionLimits SoftStart::scaled(const robot::MotionLimits& limits) const noexcept {
  robot::MotionLimits scaled = limits;
  scaled.max_speed_rad_s *= share_;
  scaled.max_tool_speed_m_s *= share_;
  return scaled;
}

}  // namespace mirrorarm::control
