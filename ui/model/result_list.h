#pragma once

#include <QAbstractTableModel>

#include "ui/model/calibration_result.h"

namespace mirrorarm::ui {

/// The figures of a result, a row each.
class ResultList : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kFigure, kValue, kInForce, kLimit, kColumnCount };
  enum Role { kLightRole = Qt::UserRole };  ///< of the first column: a Light as int; none for a heading

  using QAbstractTableModel::QAbstractTableModel;

  void show(const CalibrationResult& result);
  [[nodiscard]] bool isHeading(int row) const { return result_.rows[row].is_heading; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  CalibrationResult result_;
};

}  // namespace mirrorarm::ui
