#include "core/simulation/bench_layout.h"

#include <cmath>
#include <numbers>

#include "core/robot/surroundings.h"
#include "core/robot/urdf.h"
#include "core/simulation/exercise_motion.h"

namespace mirrorarm::simulation::bench_layout {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kCameraDown_rad = 15.0 * kDegree;
constexpr double kHalfBaseline_m = 0.06;
constexpr double kWorkingDistance_m = 0.40;

}  // namespace

RigidTransform startX_BF() {
  return makeTransform(Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal().toDenseMatrix(), {0.55, 0.0, 0.45});
}

std::optional<robot::Joints> startPosture(const robot::Kinematics& kinematics) {
  robot::Joints seed(7);
  seed << 0.0, -27.6, 0.0, 83.0, 0.0, -69.4, 0.0;
  if (kinematics.jointCount() != seed.size()) return std::nullopt;
  return kinematics.inverse(startX_BF(), kDegree * seed);
}

RigidTransform startX_BC() {
  const double c = std::cos(kCameraDown_rad), s = std::sin(kCameraDown_rad);
  Eigen::Matrix3d R;
  R << 1.0, 0.0, 0.0,  //
      0.0, -s, c,      //
      0.0, -c, -s;
  return makeTransform(R, startX_BF() * Eigen::Vector3d(kHalfBaseline_m, 0.08, 0.03));
}

FromFile<robot::ArmDescription> arm(const std::filesystem::path& resources) {
  return robot::readUrdf(resources / "robots/lbr4plus.urdf");
}

FromFile<robot::Hand> hand(const std::filesystem::path& resources) {
  return robot::readHand(resources / "robots/hand.yaml");
}

FromFile<std::vector<robot::Obstacle>> surroundings(const std::filesystem::path& resources) {
  return robot::readSurroundings(resources / "robots/surroundings.yaml");
}

RigidTransform startX_CA() {
  return makeTransform(Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal().toDenseMatrix(),
                       {kHalfBaseline_m, 0.0, kWorkingDistance_m});
}

RigidTransform plateX_BP() {
  const Eigen::Vector3d nearer_B(-0.05, 0.0, -0.04);  // more views on all sides are in reach from there
  return Eigen::Translation3d(nearer_B) * startX_BC() *
         Eigen::Translation3d(kHalfBaseline_m, 0.0, kWorkingDistance_m);
}

std::vector<Patch> clutter() {
  Patch tape;
  tape.centre = {0.95, 1.05, 0.42};
  tape.u = {0.09, 0.0, 0.012};
  tape.v = {-0.0008, 0.0, 0.006};
  tape.outline = Patch::Outline::kRectangle;
  tape.strength = 1.5;
  Patch window;
  window.centre = {0.15, 1.2, 0.75};
  window.u = {0.09, 0.0, 0.02};
  window.v = {-0.012, 0.0, 0.055};
  window.retroreflective = false;
  window.strength = 0.10;
  Patch table = window;
  table.centre = {0.45, 0.75, 0.0};
  table.u = {0.05, 0.0, 0.0};
  table.v = {0.0, 0.014, 0.004};
  table.strength = 0.16;
  return {tape, window, table};
}

ArmMotion::Forearm impairedForearm(const Eigen::Vector3d& sling_B) {
  const Eigen::Vector3d body_B(1.05, 0.0, 0.28);
  return {sling_B + kForearmLength_m * (body_B - sling_B).normalized(), sling_B};
}

std::filesystem::path rigFile(const std::filesystem::path& resources, camera::LensModel lens) {
  return resources / "rigs" / (lens == camera::LensModel::kKannalaBrandt ? "fisheye.yaml" : "pinhole.yaml");
}

}  // namespace mirrorarm::simulation::bench_layout
