#pragma once

#include <QStyledItemDelegate>

#include "ui/views/theme.h"

namespace mirrorarm::ui {

/// Draws the figures of a ResultList: the light before the words, headings bold.
class LightDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void setTheme(const Theme& theme) { theme_ = theme; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  Theme theme_;
};

}  // namespace mirrorarm::ui
