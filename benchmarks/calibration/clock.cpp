#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "benchmarks/calibration/suite.h"
#include "benchmarks/statistics.h"
#include "core/calibration/clock_offset.h"

namespace mirrorarm::benchmarks::calibration {
namespace {

using namespace mirrorarm::calibration;

constexpr double kRadianInDegrees = 180.0 / std::numbers::pi;
constexpr double kPublishedOffset_s = 0.04;
constexpr double kGoalOffset_s = 0.010;
constexpr double kGoalResidual_mm = 9.0;
constexpr double kGoalResidual_deg = 1.2;
const Eigen::Vector3d kPublishedPlace(0.079, 0.044, 0.028);

}  // namespace

void measureClock(Run& run) {
  const std::filesystem::path folder = SHARED_DATA "/ethz-handeye";
  if (!std::filesystem::exists(folder)) return;
  const auto robot = readPoseStream(folder / "2017-04-09-18-13-10_vicon_prime_sense.csv");
  const auto camera = readPoseStream(folder / "2017-04-09-18-13-10_W_camera_rgb_image_raw.csv");
  if (!robot || !camera) throw std::runtime_error(describe(robot ? camera.error() : robot.error()));
  const auto solved = solveClockOffset(*robot, *camera, CameraMount::kInHand);
  if (!solved) throw std::runtime_error(std::string(reason(solved.error())));
  const double residual_mm = 1e3 * solved->median_m, residual_deg = kRadianInDegrees * solved->median_rad;
  run.report.rows.push_back(
      {"",
       "offset of a real camera's clock",
       "within 10 ms of 40 ms",
       {{"offset", 1e3 * solved->offset_s, "ms"}, {"sigma", 1e3 * solved->sigma_s, "ms"}},
       {{"published", 1e3 * kPublishedOffset_s, "ms"}},
       std::abs(std::abs(solved->offset_s) - kPublishedOffset_s) <= kGoalOffset_s});
  run.report.rows.push_back({"",
                             "the camera on the body that was tracked",
                             "residual <= 9 mm / 1.2 deg",
                             {{"median residual", residual_mm, "mm"},
                              {"and", residual_deg, "deg"},
                              {"place against the published one",
                               1e3 * (solved->hand_eye.X_PC.translation() - kPublishedPlace).norm(), "mm"}},
                             {},
                             residual_mm <= kGoalResidual_mm && residual_deg <= kGoalResidual_deg});
}

}  // namespace mirrorarm::benchmarks::calibration
