#include "ui/panels/log_panel.h"

#include <QHBoxLayout>
#include <QVariant>

namespace mirrorarm::ui {

LogPanel::LogPanel(LogModel& log, QWidget* parent) : QFrame(parent), lines_(new QListView) {
  setProperty("card", true);
  setObjectName(QStringLiteral("logPanel"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  row->addWidget(lines_);
  lines_->setObjectName(QStringLiteral("logLines"));
  lines_->setAccessibleName(tr("Log"));
  lines_->setModel(&log);
  lines_->setUniformItemSizes(true);
  lines_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  lines_->setMinimumHeight(20);
  connect(&log, &LogModel::rowsInserted, lines_, &QListView::scrollToBottom);
}

}  // namespace mirrorarm::ui
