#include "ui/report/session_report.h"

#include <QApplication>
#include <QBuffer>
#include <QPageLayout>
#include <QPdfWriter>
#include <QThread>
#include <qcustomplot.h>

#include "core/common/atomic_file.h"
#include "ui/report/report_blocks.h"
#include "ui/report/report_style.h"
#include "ui/report/report_words.h"

namespace mirrorarm::ui {
namespace {

using namespace report;

class SessionReport {
  Q_DECLARE_TR_FUNCTIONS(SessionReport)
};

constexpr int kDotsPerInch = 1200;
constexpr double kUnitsPerInch = 96.0;
constexpr double kTop = 62.0, kBottom = 62.0;

void drawSimulationMark(QCPPainter& painter) {
  const QString text = SessionReport::tr("SIMULATION");
  painter.setFont(font(10, QFont::Bold));
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(text) + 16.0;
  const QRectF place(kPageWidth - kMargin - width, 28.0, width, 18.0);
  painter.setPen(QPen(kStop, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(place, 3.0, 3.0);
  painter.drawText(place, Qt::AlignCenter, text);
}

void drawFrame(QCPPainter& painter, const ReportContents& contents, std::size_t page, std::size_t pages) {
  const QRectF head(kMargin, 28.0, kContentWidth, 18.0);
  const QRectF foot(kMargin, kPageHeight - 46.0, kContentWidth, 18.0);
  painter.setPen(QPen(kLine, 1.0));
  for (const double y : {head.bottom() + 4.0, foot.top() - 4.0})
    painter.drawLine(QLineF(kMargin, y, kPageWidth - kMargin, y));
  painter.setFont(font(10));
  painter.setPen(kQuietInk);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("mirrorarm"));
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter,
                   SessionReport::tr("Patient %1, session %2")
                       .arg(QString::fromStdString(contents.patient_code))
                       .arg(contents.session.id));
  painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                   SessionReport::tr("Page %1 of %2").arg(page).arg(pages));
  if (contents.session.simulated) drawSimulationMark(painter);
}

void setUp(QPdfWriter& writer, const ReportContents& contents) {
  writer.setResolution(kDotsPerInch);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
  writer.setTitle(SessionReport::tr("Session report") + ' ' + QString::fromStdString(contents.patient_code));
  writer.setCreator(QStringLiteral("mirrorarm " MIRRORARM_VERSION));
}

bool drawPages(const ReportContents& contents, QPdfWriter& writer) {
  const auto blocks = blocksOf(contents);
  const auto pages = paginate(blocks, kPageHeight - kTop - kBottom);
  QCPPainter painter;
  if (!painter.begin(&writer)) return false;
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNonCosmetic);
  painter.setAntialiasing(true);
  painter.scale(kDotsPerInch / kUnitsPerInch, kDotsPerInch / kUnitsPerInch);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (i > 0 && !writer.newPage()) return false;
    drawFrame(painter, contents, i + 1, pages.size());
    for (const auto& placed : pages[i])
      placed.block->draw(painter, {kMargin, kTop + placed.top, kContentWidth, placed.block->height});
  }
  return painter.end();
}

}  // namespace

Expected<void, std::string> writeReport(const ReportContents& contents, const std::filesystem::path& pdf) {
  Q_ASSERT(QThread::currentThread() == QApplication::instance()->thread());
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    setUp(writer, contents);
    if (!drawPages(contents, writer)) return unexpected(pdf.string() + ": the report could not be drawn");
  }
  return writeWhole(pdf, [&](std::ostream& out) { out.write(buffer.data().constData(), buffer.size()); });
}

Expected<void, std::string> writeSessionReport(records::Store& store, std::int64_t session,
                                               const std::filesystem::path& pdf) {
  const auto contents = reportContents(store, session);
  if (!contents) return unexpected(contents.error().reason);
  return writeReport(*contents, pdf);
}

}  // namespace mirrorarm::ui
