#pragma once

#include <QObject>

#include "ui/model/alarm_rules.h"

namespace mirrorarm::ui {

/// One alarm. It stays listed until its condition is over AND somebody has acknowledged it.
struct Alarm {
  Condition condition;
  bool active = true;  ///< the condition still holds
  bool acknowledged = false;
  bool operator==(const Alarm&) const = default;
};

/// The latching list of alarms, most urgent first, newest first among equals.
class AlarmList : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// The conditions that hold now; all others are over.
  void update(const QVector<Condition>& conditions);
  /// Acknowledges everything that is listed.
  void acknowledge();

  [[nodiscard]] const QVector<Alarm>& alarms() const { return alarms_; }
  /// True when something is listed that nobody has acknowledged.
  [[nodiscard]] bool needsAcknowledging() const;

 signals:
  void changed();
  void raised(const mirrorarm::ui::Condition& condition);
  void ended(const mirrorarm::ui::Condition& condition);

 private:
  bool endThoseWithout(const QVector<Condition>& conditions);
  bool raise(const Condition& condition);
  bool dropDone();

  QVector<Alarm> alarms_;
};

}  // namespace mirrorarm::ui
