#include "core/station/stop_log.h"

namespace mirrorarm::station {
namespace {

constexpr Seconds kLongestBraking{1.0};

}  // namespace

StopNews StopLog::update(const control::ServoState& cycle) noexcept {
  StopNews news;
  const bool was_stopped = reason_ != control::StopReason::kNone;
  const bool is_stopped = cycle.stop != control::StopReason::kNone;
  news.reason = was_stopped ? reason_ : cycle.stop;
  news.begun = is_stopped && !was_stopped;
  news.ended = was_stopped && !is_stopped;
  news.graver = was_stopped && cycle.category > category_;
  if (news.begun) begun_at_ = cycle.time;
  box_waits_ = box_waits_ || news.begun;
  const bool over = news.ended || secondsBetween(begun_at_, cycle.time) > kLongestBraking.count();
  // In the cycle in which it begins a stop has not braked yet.
  news.box_due = box_waits_ && !news.begun && (cycle.at_rest || over);
  if (news.box_due) box_waits_ = false;
  reason_ = cycle.stop;
  category_ = cycle.category;
  return news;
}

}  // namespace mirrorarm::station
