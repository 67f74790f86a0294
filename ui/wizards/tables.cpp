#include "ui/wizards/tables.h"

#include <QHeaderView>

namespace mirrorarm::ui {
namespace {

constexpr int kRow_px = 21;

}  // namespace

QTableView* makeTable(const QString& name, const QString& accessible) {
  auto* table = new QTableView;
  table->setObjectName(name);
  table->setAccessibleName(accessible);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->setTabKeyNavigation(false);  // the tab key leaves the table
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table->verticalHeader()->hide();
  table->verticalHeader()->setMinimumSectionSize(kRow_px);
  table->verticalHeader()->setDefaultSectionSize(kRow_px);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

}  // namespace mirrorarm::ui
