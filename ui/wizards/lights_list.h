#pragma once

#include <vector>

#include <QLabel>
#include <QVector>

#include "ui/model/capture_lights.h"
#include "ui/views/theme.h"

class QGridLayout;

namespace mirrorarm::ui {

class StatusLight;

/// Lights below each other, each with its words and its figure.
class LightsList : public QWidget {
  Q_OBJECT
 public:
  explicit LightsList(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void show(const QVector<QualityLight>& lights);
  using QWidget::show;

 private:
  struct Row {
    StatusLight* light;
    QLabel* text;
    QLabel* value;
  };
  [[nodiscard]] Row& row(std::size_t index);

  Theme theme_;
  QGridLayout* grid_;
  std::vector<Row> rows_;
};

}  // namespace mirrorarm::ui
