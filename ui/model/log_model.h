#pragma once

#include <QAbstractListModel>
#include <QString>
#include <QVector>

namespace mirrorarm::ui {

/// What happened, newest last, as a list for a view. Each line carries its time of day.
class LogModel : public QAbstractListModel {
  Q_OBJECT
 public:
  static constexpr int kMaxLines = 500;  ///< older ones are dropped; the record keeps the session's events

  using QAbstractListModel::QAbstractListModel;
  void add(const QString& text);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  QVector<QString> lines_;
};

}  // namespace mirrorarm::ui
