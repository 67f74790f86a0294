#include "ui/panels/quality_panel.h"

#include <QGridLayout>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/panels/motion_plot.h"
#include "ui/panels/status_light.h"
#include "ui/panels/text.h"

namespace mirrorarm::ui {
namespace {

constexpr double kPlotWindow_s = 15.0;
constexpr int kSpacing_px = 4;

QString stroke(const Theme& theme, const char* colour, const QString& line) {
  return QStringLiteral("<span style=\"color:%1; font-weight:bold\">%2</span>&nbsp;")
      .arg(theme.colour(QLatin1String(colour)).name(), line);
}

/// A sign besides the words; a warning stands out.
void write(const ExposureLine& exposure, QLabel& label) {
  label.setText((exposure.warns ? QStringLiteral("⚠ ") : QStringLiteral("✓ ")) + exposure.text);
  const QString role = exposure.warns ? QStringLiteral("warning") : QStringLiteral("caption");
  if (label.property("role").toString() == role) return;
  label.setProperty("role", role);
  restyle(label);
}

}  // namespace

QualityPanel::QualityPanel(QWidget* parent)
    : QWidget(parent),
      light_(new StatusLight),
      status_(makeText("status")),
      detail_(makeText("muted")),
      markers_(new Figure(tr("Markers"))),
      misfit_(new Figure(tr("Misfit"))),
      age_(new Figure(tr("Age"))),
      computing_(new Figure(tr("Computing"))),
      lost_frames_(new Figure(tr("Lost frames"))),
      refused_(new Figure(tr("Refused lights"))),
      exposure_{makeText("caption"), makeText("caption")},
      legend_(makeText("caption")),
      plot_(new MotionPlot(kPlotWindow_s)) {
  setObjectName(QStringLiteral("qualityPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* card = makeCard(QStringLiteral("qualityCard"));
  column->addWidget(card);
  auto* inside = static_cast<QVBoxLayout*>(card->layout());
  inside->setSpacing(kSpacing_px);
  inside->addWidget(makeText("heading", tr("Tracking of the healthy arm")));
  inside->addWidget(makeStatusRow());
  inside->addWidget(makeFigures());
  inside->addWidget(makeExposure());
  inside->addWidget(legend_);
  inside->addWidget(plot_, 1);
}

QWidget* QualityPanel::makeStatusRow() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(10);
  auto* text = new QVBoxLayout;
  text->setSpacing(0);
  text->addWidget(status_);
  text->addWidget(detail_);
  line->addWidget(light_);
  line->addLayout(text, 1);
  return row;
}

QWidget* QualityPanel::makeFigures() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 2, 0, 2);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->addWidget(markers_, 0, 0);
  grid->addWidget(misfit_, 0, 1);
  grid->addWidget(age_, 0, 2);
  grid->addWidget(computing_, 1, 0);
  grid->addWidget(lost_frames_, 1, 1);
  grid->addWidget(refused_, 1, 2);
  for (int i = 0; i < 3; ++i) grid->setColumnStretch(i, 1);
  return box;
}

QWidget* QualityPanel::makeExposure() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  for (auto* line : exposure_) column->addWidget(line);
  return box;
}

void QualityPanel::setTheme(const Theme& theme) {
  light_->setTheme(theme);
  plot_->setTheme(theme);
  const QString gap = QStringLiteral("&nbsp;&nbsp;");
  legend_->setText(tr("mm from start:") + gap + stroke(theme, "healthy", QStringLiteral("━━")) +
                   tr("healthy") + gap + stroke(theme, "impaired", QStringLiteral("╍╍")) + tr("impaired") +
                   gap + stroke(theme, "goal", QStringLiteral("━━")) + tr("to goal"));
}

void QualityPanel::show(const TrackingState& state) {
  light_->setLight(state.light);
  status_->setText(state.status);
  detail_->setText(state.detail);
  detail_->setVisible(!state.detail.isEmpty());
  markers_->setValue(state.markers);
  misfit_->setValue(state.misfit);
  age_->setValue(state.age);
  computing_->setValue(state.vision);
  lost_frames_->setValue(state.lost_frames);
  refused_->setValue(state.refused);
  refused_->setToolTip(state.refused_reasons);
  for (int i = 0; i < static_cast<int>(exposure_.size()); ++i) {
    QLabel& label = *exposure_[static_cast<std::size_t>(i)];
    label.setVisible(i < state.exposure.size());
    if (i < state.exposure.size()) write(state.exposure[i], label);
  }
  setAccessibleName(state.accessible);
}

void QualityPanel::show(const MotionTrace& trace) { plot_->show(trace); }

}  // namespace mirrorarm::ui
