#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>

namespace mirrorarm::ui {

/// A label that the style sheet knows by its role: "heading", "title", "muted", "caption", "figure",
/// "status", "warning".
[[nodiscard]] QLabel* makeText(const char* role, const QString& text = {}, QWidget* parent = nullptr);
/// A framed card with a column for its content.
[[nodiscard]] QFrame* makeCard(const QString& objectName);
/// Lets the style sheet look again after a property that it asks for has changed.
void restyle(QWidget& widget);

/// A caption above a value.
class Figure : public QWidget {
 public:
  explicit Figure(const QString& caption, QWidget* parent = nullptr);
  void setValue(const QString& value) { value_->setText(value); }

 private:
  QLabel* value_;
};

}  // namespace mirrorarm::ui
