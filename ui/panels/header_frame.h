#pragma once

#include <QFrame>
#include <QKeySequence>
#include <QString>

class QHBoxLayout;

namespace mirrorarm::ui {

class ActionButton;

/// The top line of a window: the product, what the window says of itself, its actions, and for good whether
/// this is a simulation.
class HeaderFrame : public QFrame {
  Q_OBJECT
 public:
  explicit HeaderFrame(bool simulated, QWidget* parent = nullptr);

  /// Beside the product's name.
  void addLeft(QWidget* widget);
  /// In the order in which they are added.
  [[nodiscard]] ActionButton* addAction(const char* name, const QString& text, const QKeySequence& key);

 private:
  QHBoxLayout* left_;
  QHBoxLayout* actions_;
};

}  // namespace mirrorarm::ui
