#include "ui/model/log_model.h"

#include <QTime>

namespace mirrorarm::ui {

void LogModel::add(const QString& text) {
  if (lines_.size() == kMaxLines) {
    beginRemoveRows({}, 0, 0);
    lines_.removeFirst();
    endRemoveRows();
  }
  const int row = static_cast<int>(lines_.size());
  beginInsertRows({}, row, row);
  lines_.append(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")) + QStringLiteral("   ") + text);
  endInsertRows();
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  const bool inside = index.isValid() && index.row() < lines_.size();
  return inside && role == Qt::DisplayRole ? QVariant(lines_.at(index.row())) : QVariant();
}

}  // namespace mirrorarm::ui
