#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <numbers>

#include <CLI/CLI.hpp>

#include "app/cli/calibrate_commands.h"
#include "core/calibration/clock_file.h"
#include "core/common/calendar.h"

namespace mirrorarm::cli {
namespace {

using namespace calibration;

constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;

struct Wish {
  std::string robot;
  std::string camera;
  std::string eye = std::string(name(CameraMount::kInHand));
  double search_s = 1.0;
  std::string out;
};

double outlierShare(const ClockOffset& found) {
  const auto& hand_eye = found.hand_eye;
  return static_cast<double>(hand_eye.outliers.size()) / static_cast<double>(hand_eye.stations.size());
}

void fill(nlohmann::ordered_json& result, const ClockOffset& found) {
  const Eigen::Vector3d p = found.hand_eye.X_PC.translation();
  const auto q = rotationOf(found.hand_eye.X_PC);
  result["offset_ms"] = found.offset_s * 1e3;
  result["sigma_ms"] = found.sigma_s * 1e3;
  result["correlation"] = found.correlation;
  result["translation_m"] = {p.x(), p.y(), p.z()};
  result["rotation_xyzw"] = {q.x(), q.y(), q.z(), q.w()};
  result["residual_mm"] = found.median_m * 1e3;
  result["residual_deg"] = found.median_rad * kRadianInDegrees;
  result["poses"] = found.hand_eye.stations.size();
  result["outliers"] = outlierShare(found);
  result["camera_inverted"] = found.was_camera_inverted;
}

void tell(const ClockOffset& found, const std::string& out) {
  const Eigen::Vector3d p = found.hand_eye.X_PC.translation() * 1e3;
  std::cout << std::fixed << std::setprecision(2) << "Camera clock + " << found.offset_s * 1e3
            << " ms = robot clock (sigma " << found.sigma_s * 1e3 << " ms, correlation " << found.correlation
            << "); camera at " << p.x() << ", " << p.y() << ", " << p.z() << " mm; median residual "
            << found.median_m * 1e3 << " mm, " << found.median_rad * kRadianInDegrees << " deg over "
            << found.hand_eye.stations.size() << " poses, outliers " << 100.0 * outlierShare(found)
            << " %; written to " << out << "\n";
  if (found.was_camera_inverted)
    std::cout << "The camera's poses were the camera in the board; they were turned round\n";
}

void run(const Wish& wish, Context& context) {
  const auto robot = orRefuse(readPoseStream(wish.robot));
  const auto camera = orRefuse(readPoseStream(wish.camera));
  const auto found = solveClockOffset(robot, camera, *cameraMountOf(wish.eye), wish.search_s);
  if (!found) throw InputRefused(wish.robot + ", " + wish.camera + ": " + std::string(reason(found.error())));
  const auto note = std::filesystem::path(wish.robot).filename().string() + ", " +
                    std::filesystem::path(wish.camera).filename().string();
  orFail(writeClockRecord(wish.out, recordOf(*found, isoUtcNow(), note)));
  fill(context.result, *found);
  if (!context.json) tell(*found, wish.out);
}

}  // namespace

void addCalibrateClock(CLI::App& calibrate, Context& context) {
  CLI::App* command =
      addCommand(calibrate, context, "clock", "The camera's clock against the robot's, from one movement",
                 "mirrorarm-cli calibrate clock robot.csv poses.csv --out clock.yaml --json");
  const auto wish = std::make_shared<Wish>();
  command
      ->add_option(
          "robot", wish->robot,
          "Flange in base over time, CSV: time_s or time_ns,tx_m,ty_m,tz_m,qx,qy,qz,qw, or without a "
          "header t,x,y,z,qx,qy,qz,qw")
      ->required();
  command->add_option("camera", wish->camera, "Board in camera over time, the same columns")->required();
  command->add_option("--eye", wish->eye, "What carries the camera")
      ->check(CLI::IsMember(std::vector<std::string>{"in-hand", "to-hand"}))
      ->capture_default_str();
  command->add_option("--search", wish->search_s, "Largest offset tried [s]")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
  command->add_option("--out", wish->out, "The clock.yaml to write")->required();
  command->callback([wish, &context] { run(*wish, context); });
}

}  // namespace mirrorarm::cli
