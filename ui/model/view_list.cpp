#include "ui/model/view_list.h"

#include <algorithm>

namespace mirrorarm::ui {
namespace {

QString residualOf(const station::TakenView& view) {
  if (view.residual_m) return ViewList::tr("%1 mm").arg(1e3 * *view.residual_m, 0, 'f', 3);
  if (view.residual_px) return ViewList::tr("%1 px").arg(*view.residual_px, 0, 'f', 3);
  return QStringLiteral("–");
}

QString pointsOf(const calibration::BoardView& view) {
  return QStringLiteral("%1 | %2").arg(view.seen[0].size()).arg(view.seen[1].size());
}

QString remarkOf(const station::TakenView& view) {
  return view.is_outlier ? ViewList::tr("⚠ left out") : QString();
}

}  // namespace

void ViewList::show(const station::CalibrationSnapshot& snapshot) {
  if (snapshot.views == views_) return;
  const int before = rowCount();
  const int after = snapshot.views ? static_cast<int>(snapshot.views->size()) : 0;
  if (before == after) {
    views_ = snapshot.views;
    if (after > 0) emit dataChanged(index(0, 0), index(after - 1, kColumnCount - 1));
    return;
  }
  beginResetModel();
  views_ = snapshot.views;
  endResetModel();
}

int ViewList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !views_ ? 0 : static_cast<int>(views_->size());
}

int ViewList::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumnCount; }

QVariant ViewList::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || role != Qt::DisplayRole) return {};
  const auto& view = (*views_)[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case kNumber:
      return index.row() + 1;
    case kName:
      return QString::fromStdString(view.name);
    case kPoints:
      return pointsOf(view.view);
    case kResidual:
      return residualOf(view);
    case kRemark:
      return remarkOf(view);
    default:
      return {};
  }
}

QVariant ViewList::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kNumber:
      return QStringLiteral("#");
    case kName:
      return tr("View");
    case kPoints:
      return tr("Points");
    case kResidual:
      return tr("Residual");
    case kRemark:
      return tr("Remark");
    default:
      return {};
  }
}

}  // namespace mirrorarm::ui
