#include "ui/wizards/lights_list.h"

#include <QGridLayout>
#include <QStringList>

#include "ui/panels/status_light.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {

LightsList::LightsList(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  setObjectName(QStringLiteral("captureLights"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(1, 1);
}

void LightsList::setTheme(const Theme& theme) {
  theme_ = theme;
  for (const auto& row : rows_) row.light->setTheme(theme);
}

LightsList::Row& LightsList::row(std::size_t index) {
  while (rows_.size() <= index) {
    const Row next{new StatusLight(StatusLight::kSmall_px), makeText("plain"), makeText("muted")};
    next.light->setTheme(theme_);
    const int line = static_cast<int>(rows_.size());
    grid_->addWidget(next.light, line, 0);
    grid_->addWidget(next.text, line, 1);
    grid_->addWidget(next.value, line, 2, Qt::AlignRight);
    rows_.push_back(next);
  }
  return rows_[index];
}

void LightsList::show(const QVector<QualityLight>& lights) {
  QStringList wanting;
  for (int i = 0; i < lights.size(); ++i) {
    const Row& shown = row(static_cast<std::size_t>(i));
    shown.light->setLight(lights[i].light);
    shown.text->setText(lights[i].text);
    shown.value->setText(lights[i].value);
    if (lights[i].light != Light::kGood) wanting << lights[i].text;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool used = static_cast<int>(i) < lights.size();
    for (QWidget* part : std::initializer_list<QWidget*>{rows_[i].light, rows_[i].text, rows_[i].value})
      part->setVisible(used);
  }
  setAccessibleName(wanting.isEmpty() ? tr("Nothing is wanting")
                                      : tr("Wanting: %1").arg(wanting.join(QStringLiteral(", "))));
}

}  // namespace mirrorarm::ui
