#include "core/simulation/simulated_robot.h"

#include <algorithm>

#include "core/simulation/counter_random.h"

namespace mirrorarm::simulation {
namespace {

constexpr Clock::duration kStep = std::chrono::milliseconds(1);
constexpr Clock::duration kLongestGap = std::chrono::milliseconds(500);
constexpr std::uint64_t kTorqueStream = 0x546F72717565u, kLineStream = 0x4C696E65u;
constexpr double kSpring_nm_rad = 1000.0, kSpringDamping = 0.7;  // until a command says otherwise

}  // namespace

SimulatedRobot::SimulatedRobot(const robot::ArmDescription& arm, const robot::Joints& start,
                               const TimeSource& time, const SimulatedRobotSettings& settings)
    : time_(time),
      drives_(arm, start),
      advanced_to_(time.now()),
      seed_(settings.seed),
      gives_way_(settings.gives_way),
      p_FE_F_(settings.p_FE_F),
      kinematics_(arm),
      line_(settings.seed ^ kLineStream),
      trail_(advanced_to_, start) {
  if (settings.load) load_.emplace(*settings.load);
  if (gives_way_) drives_.soften(robot::Joints::Constant(start.size(), kSpring_nm_rad), kSpringDamping);
  feelLoad();
  told_ = {.q_rad = start,
           .v_rad_s = drives_.v(),
           .external_torque_nm = external_torque_nm_,
           .measured_at = advanced_to_};
}

void SimulatedRobot::advance(TimePoint now) noexcept {
  // A host that slept long finds the robot where its last commands led it: nothing happens in between.
  advanced_to_ = std::max(advanced_to_, now - kLongestGap);
  while (advanced_to_ + kStep <= now) {
    advanced_to_ += kStep;
    drives_.advance(advanced_to_, kStep, external_torque_nm_);
    feelLoad();
    trail_.add(advanced_to_, drives_.q());
  }
}

void SimulatedRobot::feelLoad() noexcept {
  if (!load_) return;
  const RigidTransform X_BF = kinematics_.flange(drives_.q());
  const robot::Jacobian J = kinematics_.jacobian(drives_.q());
  const Eigen::Vector3d p_FE_B = X_BF.linear() * p_FE_F_;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, robot::kMaxJoints> J_E = J.topRows<3>();
  for (Eigen::Index j = 0; j < J.cols(); ++j) J_E.col(j) += J.block<3, 1>(3, j).cross(p_FE_B);
  const Eigen::Vector3d force = load_->force(X_BF * p_FE_F_, J_E.lazyProduct(drives_.v()));
  external_torque_nm_ = J_E.transpose().lazyProduct(force);
}

robot::RobotState SimulatedRobot::sensed() noexcept {
  robot::RobotState state{.q_rad = drives_.q(),
                          .v_rad_s = drives_.v(),
                          .external_torque_nm = external_torque_nm_,
                          .measured_at = advanced_to_};
  for (double& angle : state.q_rad) angle += kAngleNoise_rad * counterNormal(seed_, reading_++);
  for (double& torque : state.external_torque_nm)
    torque += kTorqueNoise_nm * counterNormal(seed_ ^ kTorqueStream, torque_reading_++);
  return state;
}

Expected<robot::RobotState, robot::LinkFault> SimulatedRobot::read() noexcept {
  advance(time_.now());
  if (silent_.load(std::memory_order_relaxed)) return unexpected(robot::LinkFault::kNoAnswer);
  const auto fate = line_.next();
  if (fate == FaultyLine::Fate::kLost) return unexpected(robot::LinkFault::kNoAnswer);
  if (fate == FaultyLine::Fate::kArrives) told_ = sensed();
  return told_;
}

Expected<void, robot::LinkFault> SimulatedRobot::command(const robot::RobotCommand& command) noexcept {
  advance(time_.now());
  if (silent_.load(std::memory_order_relaxed)) {
    drives_.halt();
    return unexpected(robot::LinkFault::kNoAnswer);
  }
  if (command.q_rad.size() != drives_.q().size() || !command.q_rad.allFinite())
    return unexpected(robot::LinkFault::kDriveFault);
  if (line_.next() == FaultyLine::Fate::kLost) return {};  // who sends does not learn of it
  const robot::Joints& springs = command.compliance.joint_stiffness_nm_rad;
  if (gives_way_ && springs.size() == command.q_rad.size() && (springs.array() >= 0.0).all())
    drives_.soften(springs, command.compliance.joint_damping);
  drives_.command(advanced_to_, command.q_rad);
  return {};
}

void SimulatedRobot::halt() noexcept {
  advance(time_.now());
  drives_.halt();
}

}  // namespace mirrorarm::simulation
