#pragma once

#include <memory>
#include <vector>

#include <QAbstractTableModel>

#include "core/station/calibration_snapshot.h"

namespace mirrorarm::ui {

/// The views that were taken, a row each, with what solving said of them.
class ViewList : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kNumber, kName, kPoints, kResidual, kRemark, kColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void show(const station::CalibrationSnapshot& snapshot);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  std::shared_ptr<const std::vector<station::TakenView>> views_;
};

}  // namespace mirrorarm::ui
