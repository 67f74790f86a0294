#include "app/workstation/report_command.h"

#include <iostream>

#include <QApplication>
#include <QLoggingCategory>

#include "app/workstation/exit_code.h"
#include "ui/language/language.h"
#include "ui/report/session_report.h"

namespace mirrorarm::workstation {
namespace {

int tell(ExitCode code, const std::string& reason) {
  std::cerr << "mirrorarm: " << reason << "\n";
  return code;
}

}  // namespace

int runReport(const ReportOrder& order, int argc, char** argv) {
  const auto language = QString::fromStdString(order.language);
  if (!ui::languages().contains(language))
    return tell(kWrongUse, "--language: there is no translation to " + order.language + ", but to " +
                               ui::languages().join(QStringLiteral(", ")).toStdString());
  const auto store = records::Store::openExisting(order.store);
  if (!store) return tell(kWrongUse, store.error().reason);
  const auto contents = ui::reportContents(**store, order.session);
  if (!contents) return tell(kWrongUse, order.store.string() + ": " + contents.error().reason);

  qputenv("QT_QPA_PLATFORM", "offscreen");
  // Qt's remarks on the missing desktop would stand among our one-line errors.
  QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false"));
  const QApplication application(argc, argv);
  if (!ui::useLanguage(language))
    return tell(kFailed, "the translation to " + order.language + " is damaged");
  const auto written = ui::writeReport(*contents, order.out);
  if (!written) return tell(kFailed, written.error());
  return kDone;
}

}  // namespace mirrorarm::workstation
