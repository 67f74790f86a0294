#include "ui/panels/motion_plot.h"

#include <QVBoxLayout>
#include <qcustomplot.h>

namespace mirrorarm::ui {
namespace {

constexpr double kSmallestDisplacement_mm = 20.0;
constexpr double kSmallestDistance_mm = 10.0;
constexpr int kLeftMargin_px = 36;

QFont plotFont(const QWidget& widget) {
  QFont font = widget.font();
  font.setPixelSize(11);
  return font;
}

}  // namespace

MotionPlot::MotionPlot(double window_s, QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot),
      displacement_(new QCPAxisRect(plot_)),
      distance_(new QCPAxisRect(plot_)) {
  setObjectName(QStringLiteral("motionPlot"));
  setAccessibleName(tr("Movement of both arms over time"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->addElement(0, 0, displacement_);
  plot_->plotLayout()->addElement(1, 0, distance_);
  plot_->plotLayout()->setRowStretchFactors({3.0, 2.0});
  plot_->plotLayout()->setRowSpacing(4);
  for (auto* rect : {displacement_, distance_}) setUpAxes(*rect, window_s);
  displacement_->axis(QCPAxis::atBottom)->setTickLabels(false);
  const auto graph = [this](QCPAxisRect& rect) {
    return plot_->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  };
  healthy_ = graph(*displacement_);
  impaired_ = graph(*displacement_);
  to_goal_ = graph(*distance_);
  setMinimumHeight(78);
}

void MotionPlot::setUpAxes(QCPAxisRect& rect, double window_s) {
  rect.setupFullAxesBox(false);
  rect.setAutoMargins(QCP::msBottom | QCP::msTop | QCP::msRight);
  rect.setMinimumMargins(QMargins(0, 3, 6, 2));
  rect.setMargins(QMargins(kLeftMargin_px, 0, 0, 0));
  for (auto* axis : rect.axes()) axis->setTickLabelFont(plotFont(*this));
  for (auto* axis : rect.axes(QCPAxis::atTop | QCPAxis::atRight)) axis->setVisible(false);
  rect.axis(QCPAxis::atBottom)->setRange(-window_s, 0.0);
  rect.axis(QCPAxis::atLeft)->ticker()->setTickCount(2);
  rect.axis(QCPAxis::atLeft)->setRange(0.0, kSmallestDisplacement_mm);
  for (auto* axis : {rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)}) {
    axis->grid()->setLayer(QStringLiteral("grid"));
    axis->setTickLength(0, 3);
    axis->setSubTicks(false);
    axis->setTickLabelPadding(3);
  }
}

void MotionPlot::paintAxes(QCPAxisRect& rect, const Theme& theme) {
  const QColor muted = theme.colour(QStringLiteral("text_muted"));
  for (auto* axis : {rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft)}) {
    axis->setBasePen(QPen(theme.colour(QStringLiteral("border_strong")), 1));
    axis->setTickPen(QPen(theme.colour(QStringLiteral("border_strong")), 1));
    axis->setTickLabelColor(muted);
    axis->grid()->setPen(QPen(theme.colour(QStringLiteral("border")), 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
  }
}

void MotionPlot::setTheme(const Theme& theme) {
  plot_->setBackground(theme.colour(QStringLiteral("surface")));
  for (auto* rect : {displacement_, distance_}) paintAxes(*rect, theme);
  healthy_->setPen(QPen(theme.colour(QStringLiteral("healthy")), 2.0));
  impaired_->setPen(QPen(theme.colour(QStringLiteral("impaired")), 2.0, Qt::DashLine));
  to_goal_->setPen(QPen(theme.colour(QStringLiteral("goal")), 2.0));
  plot_->replot();
}

void MotionPlot::fitHeight(QCPAxisRect& rect, double smallest) {
  bool found = false;
  double top = smallest;
  for (auto* graph : rect.graphs()) {
    const QCPRange range = graph->getValueRange(found);
    if (found) top = std::max(top, range.upper * 1.08);
  }
  rect.axis(QCPAxis::atLeft)->setRange(0.0, top);
}

void MotionPlot::show(const MotionTrace& trace) {
  healthy_->setData(trace.times(), trace.healthy_mm(), true);
  impaired_->setData(trace.times(), trace.impaired_mm(), true);
  to_goal_->setData(trace.times(), trace.toGoal_mm(), true);
  fitHeight(*displacement_, kSmallestDisplacement_mm);
  fitHeight(*distance_, kSmallestDistance_mm);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace mirrorarm::ui
