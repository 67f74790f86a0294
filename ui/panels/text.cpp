#include "ui/panels/text.h"

#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

namespace mirrorarm::ui {

QLabel* makeText(const char* role, const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", QLatin1String(role));
  return label;
}

QFrame* makeCard(const QString& objectName) {
  auto* card = new QFrame;
  card->setObjectName(objectName);
  card->setProperty("card", true);
  auto* column = new QVBoxLayout(card);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  return card;
}

void restyle(QWidget& widget) {
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

Figure::Figure(const QString& caption, QWidget* parent) : QWidget(parent), value_(makeText("figure")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeText("caption", caption));
  column->addWidget(value_);
  value_->setAccessibleName(caption);
}

}  // namespace mirrorarm::ui
