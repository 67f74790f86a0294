#include "ui/model/result_list.h"

namespace mirrorarm::ui {
namespace {

QString textOf(const ResultRow& row, int column) {
  switch (column) {
    case ResultList::kFigure:
      return row.figure;
    case ResultList::kValue:
      return row.value;
    case ResultList::kInForce:
      return row.in_force;
    case ResultList::kLimit:
      return row.limit;
    default:
      return {};
  }
}

/// What the light says, for those who do not see it.
QString spoken(const ResultRow& row) {
  switch (row.light) {
    case Light::kOff:
      return row.figure;
    case Light::kGood:
      return ResultList::tr("%1, good").arg(row.figure);
    case Light::kWaiting:
      return ResultList::tr("%1, beyond its limit").arg(row.figure);
    case Light::kBad:
      return ResultList::tr("%1, not good enough").arg(row.figure);
  }
  return {};
}

}  // namespace

void ResultList::show(const CalibrationResult& result) {
  beginResetModel();
  result_ = result;
  endResetModel();
}

int ResultList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : result_.rows.size();
}

int ResultList::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant ResultList::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ResultRow& row = result_.rows[index.row()];
  if (role == Qt::DisplayRole) return textOf(row, index.column());
  if (index.column() != kFigure) return {};
  if (role == Qt::AccessibleTextRole) return spoken(row);
  if (role == kLightRole && !row.is_heading) return static_cast<int>(row.light);
  return {};
}

QVariant ResultList::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kFigure:
      return tr("Figure");
    case kValue:
      return tr("Value");
    case kInForce:
      return tr("In force");
    case kLimit:
      return tr("Good");
    default:
      return {};
  }
}

}  // namespace mirrorarm::ui
