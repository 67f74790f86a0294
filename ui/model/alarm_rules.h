#pragma once

#include <QString>
#include <QVector>

#include "core/common/time.h"
#include "core/station/snapshot.h"

namespace mirrorarm::ui {

/// How soon somebody must act, after IEC 60601-1-8.
enum class Priority { kLow, kMedium, kHigh };
[[nodiscard]] QString nameOf(Priority priority);

/// One condition that holds now.
struct Condition {
  QString key;  ///< stable, not shown: the same condition has the same key
  Priority priority = Priority::kLow;
  QString text;
  bool operator==(const Condition&) const = default;
};

/// Which conditions a snapshot shows: a pure function.
[[nodiscard]] QVector<Condition> conditionsOf(const station::Snapshot& snapshot, TimePoint now);

}  // namespace mirrorarm::ui
