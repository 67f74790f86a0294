#include "ui/panels/help_bars.h"

#include <QPainter>

namespace mirrorarm::ui {
namespace {

constexpr int kRow_px = 18;
constexpr double kGap_px = 12, kName_px = 42, kValue_px = 48, kTrack_px = 8;

QString colourOf(control::ForceLevel level) {
  switch (level) {
    case control::ForceLevel::kCalm:
      return QStringLiteral("accent");
    case control::ForceLevel::kWarning:
    case control::ForceLevel::kSoften:
      return QStringLiteral("waiting");
    case control::ForceLevel::kTooMuch:
      break;
  }
  return QStringLiteral("bad");
}

}  // namespace

HelpBars::HelpBars(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("helpBars"));
  setAccessibleName(tr("Force at the sling and help"));
  setFixedHeight(kRow_px);
  setToolTip(tr("Force at the sling against what the plan allows, and how much the robot helps"));
}

void HelpBars::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void HelpBars::setFigures(const RobotFigures& figures) {
  figures_ = figures;
  setAccessibleDescription(tr("Force %1, help %2").arg(figures.force, figures.help));
  update();
}

void HelpBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool calm = figures_.force_level == control::ForceLevel::kCalm;
  draw(painter,
       {tr("Force"), calm ? figures_.force : QStringLiteral("▲ ") + figures_.force, figures_.force_share,
        colourOf(figures_.force_level), !calm},
       0);
  draw(painter, {tr("Help"), figures_.help, figures_.help_share, QStringLiteral("accent"), false}, 1);
}

void HelpBars::draw(QPainter& painter, const Bar& bar, int place) const {
  const double half = (width() - kGap_px) / 2;
  const QRectF row(place * (half + kGap_px), 0.0, half, kRow_px);
  const QRectF track(row.left() + kName_px, (kRow_px - kTrack_px) / 2, half - kName_px - kValue_px,
                     kTrack_px);
  QFont font = painter.font();
  font.setPixelSize(12);
  font.setBold(bar.bold);
  painter.setFont(font);
  painter.setPen(theme_.colour(QStringLiteral("text")));
  painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, bar.name);
  painter.drawText(row, Qt::AlignVCenter | Qt::AlignRight, bar.value);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.colour(QStringLiteral("disabled")));
  painter.drawRoundedRect(track, kTrack_px / 2, kTrack_px / 2);
  painter.setBrush(theme_.colour(bar.colour));
  const QRectF filled(track.topLeft(), QSizeF(bar.share * track.width(), track.height()));
  painter.drawRoundedRect(filled, kTrack_px / 2, kTrack_px / 2);
}

}  // namespace mirrorarm::ui
