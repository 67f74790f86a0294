#pragma once

#include <QTableView>

namespace mirrorarm::ui {

/// A list of rows that are chosen whole, without grid, read-only. `name`: object name; `accessible`: what it
/// lists.
[[nodiscard]] QTableView* makeTable(const QString& name, const QString& accessible);

}  // namespace mirrorarm::ui
