#pragma once

#include <QKeySequence>
#include <QPushButton>

namespace mirrorarm::ui {

/// A button that shows its key, so that nobody has to look it up.
class ActionButton : public QPushButton {
  Q_OBJECT
 public:
  ActionButton(const QString& objectName, const QString& text, const QKeySequence& key,
               QWidget* parent = nullptr);

  /// Other words on it; name and key stay.
  void setWords(const QString& words);
  /// A choice that is on or off: a box before the words says which.
  void setOn(const QString& words, bool on);
  /// The one thing to press in a step: large and in the accent colour.
  void setPrimary(bool primary);

  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString key_text_;
};

}  // namespace mirrorarm::ui
