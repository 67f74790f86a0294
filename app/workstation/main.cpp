#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "app/workstation/exit_code.h"
#include "app/workstation/report_command.h"
#include "app/workstation/run_workstation.h"

namespace {

using namespace mirrorarm;
using namespace mirrorarm::workstation;

using station::CalibrationJob;
const std::map<std::string, CalibrationJob> kJobs{{"stereo", CalibrationJob::kStereo},
                                                  {"hand-eye", CalibrationJob::kHandEye},
                                                  {"clock", CalibrationJob::kClock},
                                                  {"drift", CalibrationJob::kDrift}};

void addReportOptions(CLI::App& app, ReportOrder& order) {
  auto* report =
      app.add_option("--report", order.store, "Make the report of a session recorded in this store")
          ->type_name("STORE");
  auto* session =
      app.add_option("--session", order.session, "The session's id in the store")->type_name("ID");
  auto* out = app.add_option("--out", order.out, "The PDF to write")->type_name("FILE.pdf");
  report->needs(session)->needs(out);
}

void addWindowOptions(CLI::App& app, WorkstationOrder& order) {
  app.add_option("--store", order.store, "Keep the records in this store instead of the user's own")
      ->type_name("FILE");
  app.add_option("--calibrations", order.calibrations,
                 "Keep the calibrations in this folder instead of the user's own")
      ->type_name("DIR");
  app.add_option("--calibrate", order.calibrate, "Open the calibration: stereo, hand-eye, clock or drift")
      ->type_name("WHAT")
      ->transform(CLI::CheckedTransformer(kJobs));
  app.add_option("--exercise", order.exercise,
                 "What the simulated patient does: reach, lift, side, circle, turn")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--motion", order.motion, "A recorded motion that moves the healthy arm instead")
      ->type_name("FILE.trc")
      ->check(CLI::ExistingFile);
  app.add_option("--seed", order.seed, "Of the simulated sensors' noise")
      ->type_name("N")
      ->capture_default_str();
  app::addRobotOption(app, order.robot);
  app.add_flag("--enabling-key", order.enabling_key,
               "Motion only while the enabling key, F11 or a pedal, is held");
  app.add_flag("--help-as-needed", order.help_as_needed,
               "The robot gives way and helps as much as is needed");
  app.add_flag("--dark", order.dark, "Begin with the dark theme");
  app.add_option("--size", order.size_px, "Width and height of the window [px]")->capture_default_str();
  app.add_option(
         "--tour", order.tour,
         "Walk through the session, or the calibration, and leave a picture of each step in this folder")
      ->type_name("DIR");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"mirrorarm: the workstation for cooperative robotic movement therapy", "mirrorarm"};
  app.set_version_flag("--version", MIRRORARM_VERSION);
  app.footer(
      "Examples:\n  mirrorarm\n  mirrorarm --tour pictures\n  mirrorarm --calibrate stereo\n  mirrorarm "
      "--report store.sqlite --session 3 "
      "--out report.pdf --language de");
  ReportOrder report;
  WorkstationOrder window;
  std::string language = "en";
  addReportOptions(app, report);
  addWindowOptions(app, window);
  app.add_option("--language", language, "Language of the words: en or de")->capture_default_str();
  try {
    app.parse(argc, argv);
    report.language = window.language = language;
    return report.store.empty() ? runWorkstation(window, argc, argv) : runReport(report, argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "mirrorarm: " << error.what() << " (--help shows how)\n";
    return kWrongUse;
  } catch (const std::exception& failure) {
    std::cerr << "mirrorarm: " << failure.what() << "\n";
    return kFailed;
  }
}
