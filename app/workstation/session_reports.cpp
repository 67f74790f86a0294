#include "app/workstation/session_reports.h"

#include "core/records/store.h"
#include "ui/report/session_report.h"

namespace mirrorarm::workstation {
namespace {

Expected<QString, QString> draw(const ui::ReportContents& contents, const std::filesystem::path& pdf) {
  const auto written = ui::writeReport(contents, pdf);
  if (!written) return unexpected(QString::fromStdString(written.error()));
  return QString::fromStdString(pdf.string());
}

Expected<ui::ReportJob::Draw, QString> read(const std::filesystem::path& file, std::int64_t session) {
  const auto store = records::Store::openExisting(file);
  if (!store) return unexpected(QString::fromStdString(store.error().reason));
  auto contents = ui::reportContents(**store, session);
  if (!contents) return unexpected(QString::fromStdString(contents.error().reason));
  const auto pdf = file.parent_path() / ("session-" + std::to_string(session) + ".pdf");
  return ui::ReportJob::Draw([contents = std::move(*contents), pdf] { return draw(contents, pdf); });
}

}  // namespace

ui::ReportJob::Read sessionReportsOf(const std::filesystem::path& store) {
  return [store](std::int64_t session) { return read(store, session); };
}

}  // namespace mirrorarm::workstation
