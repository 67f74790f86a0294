#include "ui/report/course_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <qcustomplot.h>

#include "ui/report/course_envelope.h"
#include "ui/report/report_style.h"

namespace mirrorarm::ui::report {
namespace {

class CourseCharts {
  Q_DECLARE_TR_FUNCTIONS(CourseCharts)
};

constexpr double kLongestLine_s = 300.0;
constexpr int kEnvelopeIntervals = 120;
constexpr double kTitleHeight = 22.0;
constexpr double kTimesHeight = 28.0;  ///< time's tick labels and name

/// The values of `panel` inside the chart's span.
QCPRange rangeOf(const CourseChart& chart, const Panel& panel) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& course : panel.courses)
    for (std::size_t i = 0; i < course.values->size(); ++i) {
      const double time = (*chart.time_s)[i], value = (*course.values)[i];
      if (std::isnan(value) || time < chart.span.from_s || time > chart.span.to_s) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  if (panel.from_zero) low = 0.0;
  if (!(low <= high)) return {0.0, std::max(chart.least_range, 1.0)};
  return {low, high};
}

/// Ranges for the axes: some air around the values, not below the least range, equal heights where asked for.
std::vector<QCPRange> axisRanges(const CourseChart& chart) {
  std::vector<QCPRange> ranges;
  double largest = chart.least_range;
  for (const auto& panel : chart.panels) {
    ranges.push_back(rangeOf(chart, panel));
    largest = std::max(largest, ranges.back().size());
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double size = chart.equal_scale ? largest : std::max(ranges[i].size(), chart.least_range);
    const double middle = ranges[i].center();
    ranges[i] = chart.panels[i].from_zero ? QCPRange(0.0, 1.1 * size)
                                          : QCPRange(middle - 0.56 * size, middle + 0.56 * size);
  }
  return ranges;
}

void style(QCPAxis& axis) {
  axis.setBasePen(QPen(kLine, 1.0));
  axis.setTickPen(QPen(kLine, 1.0));
  axis.setSubTicks(false);
  axis.setTickLength(0, 3);
  axis.setTickLabelFont(font(9));
  axis.setTickLabelColor(kQuietInk);
  axis.setLabelFont(font(9));
  axis.setLabelColor(kQuietInk);
  axis.setLabelPadding(3);
  axis.grid()->setVisible(true);
  axis.grid()->setPen(QPen(kLine, 0.5));
  axis.grid()->setZeroLinePen(QPen(kLine, 1.0));
}

/// A shape that spans the axis rect's height from one time to another.
template <class Item, class Begin, class End>
void spanHeight(QCPAxisRect* rect, Item* item, Begin* begin, double from_s, End* end, double to_s) {
  item->setClipAxisRect(rect);
  item->setClipToAxisRect(true);
  for (QCPItemPosition* position :
       {static_cast<QCPItemPosition*>(begin), static_cast<QCPItemPosition*>(end)}) {
    position->setAxisRect(rect);
    position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    position->setTypeX(QCPItemPosition::ptPlotCoords);
    position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  begin->setCoords(from_s, 0.0);
  end->setCoords(to_s, 1.0);
}

void addRests(const CourseChart& chart, QCustomPlot& plot, QCPAxisRect* rect) {
  for (const auto& rest : chart.rests) {
    auto* band = new QCPItemRect(&plot);  // owned by the plot
    band->setLayer(QStringLiteral("background"));
    band->setPen(Qt::NoPen);
    band->setBrush(kRest);
    spanHeight(rect, band, band->topLeft, rest.from_s, band->bottomRight, rest.to_s);
  }
}

void addStops(const CourseChart& chart, QCustomPlot& plot, QCPAxisRect* rect) {
  for (const double time_s : chart.stops_s) {
    auto* line = new QCPItemLine(&plot);  // owned by the plot
    line->setPen(QPen(kStop, 1.0, Qt::DashLine));
    spanHeight(rect, line, line->start, time_s, line->end, time_s);
  }
}

/// Longer courses show their envelope: single movements would run together into a block of colour.
bool showsEnvelopes(const CourseChart& chart) { return chart.span.to_s - chart.span.from_s > kLongestLine_s; }

QVector<double> vectorOf(const std::vector<double>& values) { return {values.begin(), values.end()}; }

void addEnvelope(const CourseChart& chart, const Course& course, QCustomPlot& plot, QCPAxisRect* rect) {
  const auto envelope = envelopeOf(*chart.time_s, *course.values, chart.span, kEnvelopeIntervals);
  QColor fill = course.colour;
  fill.setAlphaF(0.35);
  QCPGraph* low = nullptr;
  for (const auto* edge : {&envelope.low, &envelope.high}) {
    auto* graph = plot.addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    graph->setPen(QPen(course.colour, 0.8));
    graph->setData(vectorOf(envelope.time_s), vectorOf(*edge), true);
    if (low) {
      graph->setBrush(fill);
      graph->setChannelFillGraph(low);
    }
    low = graph;
  }
}

void addLine(const CourseChart& chart, const Course& course, QCustomPlot& plot, QCPAxisRect* rect) {
  auto* graph = plot.addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
  graph->setPen(QPen(course.colour, 1.2));
  graph->setData(vectorOf(*chart.time_s), vectorOf(*course.values), true);
}

QCPAxisRect* addPanel(const CourseChart& chart, const Panel& panel, const QCPRange& range,
                      QCustomPlot& plot) {
  auto* rect = new QCPAxisRect(&plot, false);  // owned by the plot's layout
  plot.plotLayout()->addElement(plot.plotLayout()->rowCount(), 0, rect);
  rect->setMinimumMargins(QMargins(0, 6, 6, 3));
  auto* times = rect->addAxis(QCPAxis::atBottom);
  auto* values = rect->addAxis(QCPAxis::atLeft);
  for (auto* axis : {times, values}) {
    style(*axis);
    axis->setLayer(QStringLiteral("axes"));
    axis->grid()->setLayer(QStringLiteral("grid"));
  }
  const auto ticker = QSharedPointer<QCPAxisTickerTime>::create();
  ticker->setTimeFormat(QStringLiteral("%m:%s"));
  times->setTicker(ticker);
  times->setRange(chart.span.from_s, chart.span.to_s);
  values->ticker()->setTickCount(3);
  values->setLabel(panel.label);
  values->setRange(range);
  addRests(chart, plot, rect);
  for (const auto& course : panel.courses)
    showsEnvelopes(chart) ? addEnvelope(chart, course, plot, rect) : addLine(chart, course, plot, rect);
  addStops(chart, plot, rect);
  return rect;
}

void drawPanels(const CourseChart& chart, QCPPainter& painter, const QRectF& place) {
  QCustomPlot plot;
  plot.setLocale(QLocale());
  plot.setBackground(QBrush(Qt::NoBrush));
  plot.plotLayout()->clear();
  plot.plotLayout()->setRowSpacing(0);
  QCPMarginGroup sides(&plot);
  const auto ranges = axisRanges(chart);
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    auto* rect = addPanel(chart, chart.panels[i], ranges[i], plot);
    rect->setMarginGroup(QCP::msLeft | QCP::msRight, &sides);
    rect->axis(QCPAxis::atBottom)->setTickLabels(i + 1 == chart.panels.size());
  }
  const auto last = plot.plotLayout()->rowCount() - 1;
  plot.axisRect(last)->axis(QCPAxis::atBottom)->setLabel(CourseCharts::tr("time [min:s]"));
  // The last panel carries the times; it is higher by them, so that all curves get the same height.
  const double each = (place.height() - kTimesHeight) / (last + 1);
  plot.plotLayout()->setRowStretchFactor(last, (each + kTimesHeight) / each);
  painter.save();
  painter.translate(place.topLeft());
  plot.toPainter(&painter, static_cast<int>(place.width()), static_cast<int>(place.height()));
  painter.restore();
}

/// What a colour of the chart stands for: a line, or a band where the pen is none.
struct LegendEntry {
  QString name;
  QPen pen;
};

std::vector<LegendEntry> legendOf(const CourseChart& chart) {
  std::vector<LegendEntry> entries;
  for (const auto& panel : chart.panels)
    for (const auto& course : panel.courses)
      if (!course.name.isEmpty() &&
          std::ranges::find(entries, course.name, &LegendEntry::name) == entries.end())
        entries.push_back({course.name, QPen(course.colour, 2.0)});
  const auto is_shown = [&](double from_s, double to_s) {
    return to_s > chart.span.from_s && from_s < chart.span.to_s;
  };
  if (std::ranges::any_of(chart.rests,
                          [&](const TimeSpan& rest) { return is_shown(rest.from_s, rest.to_s); }))
    entries.push_back({CourseCharts::tr("Robot at rest"), Qt::NoPen});
  if (std::ranges::any_of(chart.stops_s, [&](double time_s) { return is_shown(time_s, time_s); }))
    entries.push_back({CourseCharts::tr("Stop"), QPen(kStop, 1.0, Qt::DashLine)});
  return entries;
}

/// From the right, in reading order.
void drawLegend(const CourseChart& chart, QCPPainter& painter, const QRectF& line) {
  const auto entries = legendOf(chart);
  painter.setFont(font(10));
  double right = line.right() - 6.0;
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(entry->name);
    const double left = right - width, middle = line.center().y();
    painter.setPen(kQuietInk);
    painter.drawText(QRectF(left, line.top(), width + 2.0, line.height()), Qt::AlignVCenter, entry->name);
    painter.setPen(entry->pen);
    if (entry->pen.style() == Qt::NoPen)
      painter.fillRect(QRectF(left - 22.0, middle - 5.0, 16.0, 10.0), kRest);
    else
      painter.drawLine(QLineF(left - 22.0, middle, left - 6.0, middle));
    right = left - 38.0;
  }
}

/// Behind the title: what the bands are.
void drawEnvelopeRemark(const CourseChart& chart, QCPPainter& painter, const QRectF& line) {
  const double title_width = QFontMetricsF(painter.font()).horizontalAdvance(chart.title);
  const double interval_s = (chart.span.to_s - chart.span.from_s) / kEnvelopeIntervals;
  painter.setPen(kQuietInk);
  painter.setFont(font(10));
  painter.drawText(line.adjusted(title_width + 8.0, 0.0, 0.0, 0.0), Qt::AlignVCenter,
                   CourseCharts::tr("range in every %1 s").arg(QLocale().toString(interval_s, 'f', 0)));
}

}  // namespace

void draw(const CourseChart& chart, QCPPainter& painter, const QRectF& place) {
  const QRectF line(place.left(), place.top(), place.width(), kTitleHeight);
  painter.setPen(kInk);
  painter.setFont(font(12, QFont::Bold));
  painter.drawText(line, Qt::AlignVCenter, chart.title);
  if (showsEnvelopes(chart)) drawEnvelopeRemark(chart, painter, line);
  drawLegend(chart, painter, line);
  drawPanels(chart, painter, place.adjusted(0.0, kTitleHeight, 0.0, 0.0));
}

}  // namespace mirrorarm::ui::report
