#include "ui/report/report_blocks.h"

#include <algorithm>
#include <iterator>

#include <qcustomplot.h>

#include "ui/report/course_chart.h"
#include "ui/report/report_style.h"
#include "ui/report/report_words.h"

namespace mirrorarm::ui::report {
namespace {

class ReportBlocks {
  Q_DECLARE_TR_FUNCTIONS(ReportBlocks)
};

void write(QCPPainter& painter, const QRectF& place, const QFont& typeface, const QColor& colour,
           const QString& text, int flags = Qt::AlignLeft | Qt::AlignVCenter) {
  painter.setFont(typeface);
  painter.setPen(colour);
  painter.drawText(place, flags, text);
}

Block titleBlock(const ReportContents& contents) {
  const auto facts = sessionFacts(contents);
  return {150.0, 12.0, [facts](QCPPainter& painter, const QRectF& place) {
            write(painter, {place.left(), place.top(), place.width(), 34.0}, font(25, QFont::Bold), kInk,
                  ReportBlocks::tr("Session report"));
            constexpr double kRowHeight = 25.0, kLabelWidth = 96.0;
            for (std::size_t i = 0; i < facts.size(); ++i) {
              const double left = place.left() + (i % 2 == 0 ? 0.0 : 0.5 * place.width());
              const double top = place.top() + 46.0 + kRowHeight * static_cast<double>(i / 2);
              write(painter, {left, top, kLabelWidth, kRowHeight}, font(10), kQuietInk, facts[i].label);
              write(painter, {left + kLabelWidth, top, 0.5 * place.width() - kLabelWidth - 6.0, kRowHeight},
                    font(11, i == 0 ? QFont::Bold : QFont::Normal), kInk, facts[i].value,
                    Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap);
            }
          }};
}

/// A sentence in a frame, for what must not be overlooked.
Block noticeBlock(const QString& text) {
  return {30.0, 12.0, [text](QCPPainter& painter, const QRectF& place) {
            painter.setPen(QPen(kStop, 1.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(place, 4.0, 4.0);
            write(painter, place.adjusted(12.0, 0.0, -12.0, 0.0), font(11, QFont::Bold), kStop, text);
          }};
}

/// A quiet sentence, as many lines high as it needs.
Block noteBlock(const QString& text) {
  constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  const QRectF needed =
      QFontMetricsF(font(10)).boundingRect(QRectF(0.0, 0.0, kContentWidth, 1000.0), kFlags, text);
  return {needed.height() + 2.0, 2.0, [text](QCPPainter& painter, const QRectF& place) {
            write(painter, place, font(10), kQuietInk, text, kFlags);
          }};
}

void drawFigure(QCPPainter& painter, const QRectF& card, const KeyFigure& figure) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(kCard);
  painter.drawRoundedRect(card, 5.0, 5.0);
  const QRectF text = card.adjusted(10.0, 7.0, -6.0, -7.0);
  write(painter, {text.left(), text.top(), text.width(), 14.0}, font(10), kQuietInk, figure.label);
  const QFont large = font(21, QFont::Bold);
  const QRectF line(text.left(), text.top() + 16.0, text.width(), 27.0);
  write(painter, line, large, kInk, figure.value);
  const double width = QFontMetricsF(large).horizontalAdvance(figure.value);
  write(painter, line.adjusted(width + 5.0, 6.0, 0.0, 0.0), font(10), kInk, figure.unit);
  write(painter, {text.left(), text.bottom() - 12.0, text.width(), 12.0}, font(9), kQuietInk, figure.remark);
}

Block figuresBlock(const ReportContents& contents) {
  constexpr double kHeight = 72.0, kGap = 8.0;
  constexpr std::size_t kColumns = 4;
  const auto figures = keyFigures(contents);
  const auto rows = static_cast<double>((figures.size() + kColumns - 1) / kColumns);
  return {rows * (kHeight + kGap) - kGap, 18.0, [figures](QCPPainter& painter, const QRectF& place) {
            const double width = (place.width() - (kColumns - 1) * kGap) / kColumns;
            for (std::size_t i = 0; i < figures.size(); ++i)
              drawFigure(painter,
                         {place.left() + static_cast<double>(i % kColumns) * (width + kGap),
                          place.top() + static_cast<double>(i / kColumns) * (kHeight + kGap), width, kHeight},
                         figures[i]);
          }};
}

CourseChart chartOf(const ReportContents& contents, const QString& title, const TimeSpan& span) {
  CourseChart chart;
  chart.title = title;
  chart.time_s = &contents.courses.time_s;
  chart.span = span;
  chart.rests = contents.rests;
  for (const auto& event : contents.events)
    if (event.event.starts_with("stop.")) chart.stops_s.push_back(event.time_s);
  return chart;
}

Block chartBlock(CourseChart chart, double height) {
  return {height, 14.0, [chart = std::move(chart)](QCPPainter& painter, const QRectF& place) {
            draw(chart, painter, place);
          }};
}

CourseChart movementChart(const ReportContents& contents, const QString& title, const TimeSpan& span) {
  auto chart = chartOf(contents, title, span);
  chart.least_range = 20.0;
  chart.equal_scale = true;
  constexpr std::array kAxes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    chart.panels.push_back(
        {ReportBlocks::tr("%1 [mm]").arg(QLatin1String(kAxes[axis])),
         {{ReportBlocks::tr("Healthy arm"), kHealthy, &contents.courses.healthy_mm[axis]},
          {ReportBlocks::tr("Impaired arm (robot)"), kImpaired, &contents.courses.impaired_mm[axis]}}});
  return chart;
}

CourseChart distanceChart(const ReportContents& contents, const TimeSpan& span) {
  auto chart = chartOf(contents, ReportBlocks::tr("Distance to the goal"), span);
  chart.least_range = 5.0;
  chart.panels.push_back(
      {ReportBlocks::tr("distance [mm]"), {{QString(), kHealthy, &contents.courses.goal_distance_mm}}, true});
  return chart;
}

CourseChart trackingChart(const ReportContents& contents, const TimeSpan& span) {
  auto chart = chartOf(contents, ReportBlocks::tr("Tracking quality"), span);
  chart.least_range = 0.5;
  chart.panels.push_back(
      {ReportBlocks::tr("markers"), {{QString(), kHealthy, &contents.courses.matched}}, true});
  chart.panels.push_back(
      {ReportBlocks::tr("misfit [mm]"), {{QString(), kHealthy, &contents.courses.rms_mm}}, true});
  return chart;
}

void addCharts(const ReportContents& contents, std::vector<Block>& blocks) {
  if (contents.courses.time_s.size() < 2) {
    blocks.push_back(noticeBlock(ReportBlocks::tr("No movement was recorded.")));
    return;
  }
  const TimeSpan whole{contents.courses.time_s.front(), contents.courses.time_s.back()};
  blocks.push_back(chartBlock(movementChart(contents, ReportBlocks::tr("Movement"), whole), 350.0));
  blocks.push_back(chartBlock(distanceChart(contents, whole), 160.0));
  if (contents.close_up)
    blocks.push_back(chartBlock(
        movementChart(contents, ReportBlocks::tr("Movement, a closer look"), *contents.close_up), 350.0));
  blocks.push_back(chartBlock(trackingChart(contents, whole), 230.0));
}

Block headingBlock(const QString& text) {
  return {20.0, 2.0, [text](QCPPainter& painter, const QRectF& place) {
            write(painter, place, font(12, QFont::Bold), kInk, text);
          }};
}

Block eventBlock(const records::Store::Event& event) {
  const bool is_stop = event.event.starts_with("stop.");
  return {16.0, 0.0,
          [time = clockTime(event.time_s), words = eventWords(event.event), is_stop](QCPPainter& painter,
                                                                                     const QRectF& place) {
            write(painter, place, font(10), kQuietInk, time);
            write(painter, place.adjusted(56.0, 0.0, 0.0, 0.0),
                  font(10, is_stop ? QFont::Bold : QFont::Normal), is_stop ? kStop : kInk, words);
          }};
}

void addEvents(const ReportContents& contents, std::vector<Block>& blocks) {
  blocks.push_back(headingBlock(ReportBlocks::tr("Events")));
  if (contents.events.empty()) blocks.push_back(noteBlock(ReportBlocks::tr("None.")));
  for (const auto& event : contents.events) blocks.push_back(eventBlock(event));
  blocks.back().space_after = 14.0;
}

}  // namespace

std::vector<Block> blocksOf(const ReportContents& contents) {
  std::vector<Block> blocks{titleBlock(contents)};
  if (contents.session.simulated)
    blocks.push_back(
        noticeBlock(ReportBlocks::tr("Simulation: cameras and patient of this session were simulated, and "
                                     "the robot unless another one was chosen.")));
  blocks.push_back(figuresBlock(contents));
  addCharts(contents, blocks);
  addEvents(contents, blocks);
  blocks.push_back(headingBlock(ReportBlocks::tr("How the figures are made")));
  std::ranges::transform(explanations(), std::back_inserter(blocks), noteBlock);
  return blocks;
}

}  // namespace mirrorarm::ui::report
