#include "app/cli/calibrate_commands.h"
#include "app/cli/commands.h"

namespace mirrorarm::cli {

void addCalibrate(CLI::App& app, Context& context) {
  CLI::App* calibrate =
      app.add_subcommand("calibrate", "Solve lenses, the stereo rig or the camera on the robot");
  calibrate->require_subcommand(1);
  addCalibrateHandEye(*calibrate, context);
}

}  // namespace mirrorarm::cli
