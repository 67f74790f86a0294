#pragma once

#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "core/common/expected.h"
#include "core/robot/robot_link.h"
#include "core/simulation/ridden_robot.h"

namespace mirrorarm::app {

/// Which robot a program works with, as its command line says.
struct RobotOption {
  std::string robot = "simulated";  ///< see devices::robotAddressOf
  std::string controller;           ///< the only one that is answered (fri); empty: the first that speaks
  double fri_period_ms = 1.0;       ///< as the program on the controller gives it to friOpen

  [[nodiscard]] bool isSimulated() const { return robot == "simulated"; }
};

/// --robot, --controller and --fri-period-ms. A word that names no robot is wrong use.
void addRobotOption(CLI::App& app, RobotOption& option);

/// Not for the simulated one. The error is why there is no link.
[[nodiscard]] Expected<std::unique_ptr<robot::RobotLink>, std::string> openRobot(
    const RobotOption& option, robot::GivesWay gives_way = robot::GivesWay::kNot);

/// The robot that is to carry the bench's hand, standing where the bench is laid out for; nullptr for the
/// simulated one, which the bench brings along. The error is why there is none.
[[nodiscard]] Expected<std::unique_ptr<simulation::RiddenRobot>, std::string> openBenchRobot(
    const RobotOption& option, robot::GivesWay gives_way = robot::GivesWay::kNot);

}  // namespace mirrorarm::app
