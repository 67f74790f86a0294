#include "ui/model/alarm_list.h"

#include <algorithm>

namespace mirrorarm::ui {
namespace {

bool moreUrgent(const Alarm& left, const Alarm& right) {
  if (left.active != right.active) return left.active;
  return left.condition.priority > right.condition.priority;
}

}  // namespace

void AlarmList::update(const QVector<Condition>& conditions) {
  bool any = endThoseWithout(conditions);
  for (const auto& condition : conditions) any = raise(condition) || any;
  any = dropDone() || any;
  if (!any) return;
  std::stable_sort(alarms_.begin(), alarms_.end(), moreUrgent);
  emit changed();
}

bool AlarmList::endThoseWithout(const QVector<Condition>& conditions) {
  bool any = false;
  for (auto& alarm : alarms_) {
    const bool holds = std::any_of(conditions.begin(), conditions.end(),
                                   [&alarm](const Condition& c) { return c.key == alarm.condition.key; });
    if (!alarm.active || holds) continue;
    alarm.active = false;
    any = true;
    emit ended(alarm.condition);
  }
  return any;
}

bool AlarmList::raise(const Condition& condition) {
  const auto known = std::find_if(alarms_.begin(), alarms_.end(),
                                  [&condition](const Alarm& a) { return a.condition.key == condition.key; });
  if (known != alarms_.end() && known->active) return false;
  if (known != alarms_.end()) alarms_.erase(known);  // it came again: it must be acknowledged again
  alarms_.prepend({condition, true, false});
  emit raised(condition);
  return true;
}

bool AlarmList::dropDone() {
  const auto done = std::remove_if(alarms_.begin(), alarms_.end(),
                                   [](const Alarm& alarm) { return !alarm.active && alarm.acknowledged; });
  const bool any = done != alarms_.end();
  alarms_.erase(done, alarms_.end());
  return any;
}

void AlarmList::acknowledge() {
  if (!needsAcknowledging()) return;
  for (auto& alarm : alarms_) alarm.acknowledged = true;
  dropDone();
  emit changed();
}

bool AlarmList::needsAcknowledging() const {
  return std::any_of(alarms_.begin(), alarms_.end(), [](const Alarm& alarm) { return !alarm.acknowledged; });
}

}  // namespace mirrorarm::ui
