#include <iostream>

#include <CLI/CLI.hpp>

#include "app/workstation/exit_code.h"
#include "app/workstation/report_command.h"

namespace {

using namespace mirrorarm::workstation;

void addReportOptions(CLI::App& app, ReportOrder& order) {
  auto* report =
      app.add_option("--report", order.store, "Make the report of a session recorded in this store")
          ->type_name("STORE")
          ->required();
  auto* session =
      app.add_option("--session", order.session, "The session's id in the store")->type_name("ID");
  auto* out = app.add_option("--out", order.out, "The PDF to write")->type_name("FILE.pdf");
  report->needs(session)->needs(out);
  app.add_option("--language", order.language, "Language of the words: en or de")->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"mirrorarm: the workstation for cooperative robotic movement therapy", "mirrorarm"};
  app.set_version_flag("--version", MIRRORARM_VERSION);
  app.footer("Example:\n  mirrorarm --report store.sqlite --session 3 --out report.pdf --language de");
  ReportOrder report;
  addReportOptions(app, report);
  try {
    app.parse(argc, argv);
    return runReport(report, argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "mirrorarm: " << error.what() << " (--help shows how)\n";
    return kWrongUse;
  } catch (const std::exception& failure) {
    std::cerr << "mirrorarm: " << failure.what() << "\n";
    return kFailed;
  }
}
