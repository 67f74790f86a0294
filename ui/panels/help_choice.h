#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/model/help_presenter.h"

class QHBoxLayout;
class QPushButton;

namespace mirrorarm::ui {

class ActionButton;

/// How much the robot is to help: adapting or fixed, and less or more; or why that cannot be chosen.
class HelpChoice : public QWidget {
  Q_OBJECT
 public:
  /// `presenter` outlives it.
  explicit HelpChoice(HelpPresenter& presenter, QWidget* parent = nullptr);

 private:
  [[nodiscard]] QPushButton* addStep(QHBoxLayout& row, const QString& name, const QString& sign,
                                     const QString& meaning, const QString& key);
  void draw(const HelpState& state);

  ActionButton* adapts_;
  QWidget* steps_;
  QPushButton* less_;
  QLabel* level_;
  QPushButton* more_;
  QLabel* reason_;
};

}  // namespace mirrorarm::ui
