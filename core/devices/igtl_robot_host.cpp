#include "core/devices/igtl_robot_host.h"

#include <algorithm>
#include <thread>

namespace mirrorarm::devices {
namespace {

using robot::Joints;
using robot::LinkFault;

constexpr double kRest_rad_s = 1e-2;
constexpr double kSpeedMargin = 1.2;  // commands arrive unevenly
constexpr double kSilentCycles = 3.0;
constexpr Seconds kRobotSilentAfter{0.050};
constexpr std::uint16_t kAllIsWell = 1, kDenied = 5, kDisabled = 15;
constexpr std::size_t kPiece = 4096;
constexpr int kMostPieces = 8;  // a cycle: a flood must not hold up the robot

/// Whichever way the loop is left, an exception's too.
class HaltsAtTheEnd {
 public:
  explicit HaltsAtTheEnd(robot::RobotLink& robot) : robot_(robot) {}
  ~HaltsAtTheEnd() { haltToRest(robot_); }
  HaltsAtTheEnd(const HaltsAtTheEnd&) = delete;
  HaltsAtTheEnd& operator=(const HaltsAtTheEnd&) = delete;

 private:
  robot::RobotLink& robot_;
};

void sendStatus(const TcpSocket& socket, std::uint16_t code, const std::string& text) {
  static_cast<void>(socket.send(igtlBytes(statusMessage(code, text))));
}

}  // namespace

std::string_view id(RobotRefusal refusal) {
  constexpr std::array<std::string_view, kRobotRefusals> kIds{
      "not_allowed", "out_of_order", "too_old", "stopped", "not_from_rest", "beyond_limits"};
  return kIds[static_cast<std::size_t>(refusal)];
}

Expected<std::unique_ptr<IgtlRobotHost>, std::string> IgtlRobotHost::open(
    const IgtlRobotHostSettings& settings, const robot::ArmDescription& arm, robot::RobotLink& robot) {
  auto door = IgtlDoor::open(settings.address, settings.port, settings.allowed);
  if (!door) return unexpected(door.error());
  return std::unique_ptr<IgtlRobotHost>(new IgtlRobotHost(settings, arm, robot, std::move(*door)));
}

IgtlRobotHost::IgtlRobotHost(const IgtlRobotHostSettings& settings, const robot::ArmDescription& arm,
                             robot::RobotLink& robot, IgtlDoor door)
    : settings_(settings),
      robot_(robot),
      door_(std::move(door)),
      lower_rad_(arm.jointCount()),
      upper_rad_(arm.jointCount()),
      max_speed_rad_s_(arm.jointCount()) {
  for (int i = 0; i < arm.jointCount(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    lower_rad_[i] = joint.lower_rad;
    upper_rad_[i] = joint.upper_rad;
    max_speed_rad_s_[i] = joint.max_speed_rad_s;
  }
  state_.period_s = settings_.period.count();
  state_.takes_commands = settings_.allow_motion;
}

void IgtlRobotHost::run(const std::stop_token& stop, Seconds longest) {
  const HaltsAtTheEnd halts(robot_);
  const TimePoint end = Clock::now() + toClock(longest);
  TimePoint due = Clock::now();
  while (!stop.stop_requested() && Clock::now() < end) {
    if (robot_.setsThePace()) {
      robot_.awaitCycle(kSilentCycles * robot_.period());
    } else {
      due = std::max(due + toClock(robot_.period()), Clock::now());
      std::this_thread::sleep_until(due);
    }
    cycle();
  }
}

void IgtlRobotHost::cycle() {
  now_ = Clock::now();
  readRobot();
  listen();
  greet();
  if (driving_ && now_ - commanded_at_ > settings_.silent_after) stop(LinkFault::kPoorLine);
  if (driving_) drive();
  if (now_ < next_state_at_) return;
  next_state_at_ = std::max(next_state_at_ + toClock(settings_.period), now_);
  tell();
}

IgtlRobotHostReport IgtlRobotHost::report() const {
  IgtlRobotHostReport report = report_;
  report.turned_away += door_.strangers();
  return report;
}

void IgtlRobotHost::readRobot() {
  const auto read = robot_.read();
  if (read) {
    robot_fault_ = LinkFault::kNone;
    state_at_ = now_;
    state_.q_rad = read->q_rad;
    state_.v_rad_s = read->v_rad_s;
    state_.external_torque_nm = read->external_torque_nm;
    return;
  }
  // A single message may be missing.
  if (read.error() == LinkFault::kNoAnswer && now_ - state_at_ < kRobotSilentAfter) return;
  robot_fault_ = read.error();
  if (driving_) stop(robot_fault_);
}

void IgtlRobotHost::greet() {
  auto caller = door_.accept();
  if (!caller) return;
  if (client_.isOpen()) {
    ++report_.turned_away;
    return sendStatus(*caller, kDenied, "another client has the robot");
  }
  ++report_.callers;
  client_ = std::move(*caller);
  received_.clear();
  state_.heeded = 0;
  sendStatus(client_, settings_.allow_motion ? kAllIsWell : kDisabled,
             settings_.allow_motion ? "commands are taken" : "started without --allow-motion");
}

void IgtlRobotHost::listen() {
  std::array<std::byte, kPiece> piece{};
  for (int i = 0; i < kMostPieces && client_.isOpen(); ++i) {
    const auto size = client_.receive(piece);
    if (!size) return hangUp();
    if (*size == 0) return;
    received_.insert(received_.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(*size));
    takeMessages();
  }
}

void IgtlRobotHost::takeMessages() {
  std::span<const std::byte> rest = received_;
  while (true) {
    const auto view = igtlView(rest);
    if (!view) return hangUp();  // out of step: nothing after it can be believed
    if (!*view) break;
    if (const auto command = robotCommandOf(**view)) take(*command);
    rest = rest.subspan((*view)->size);
  }
  received_.erase(received_.begin(), received_.end() - static_cast<std::ptrdiff_t>(rest.size()));
}

void IgtlRobotHost::hangUp() {
  client_.close();
  if (driving_) stop(LinkFault::kPoorLine);
}

void IgtlRobotHost::take(const RobotCommandMessage& command) {
  if (!command.drive) {
    state_.heeded = std::max(state_.heeded, command.sequence);
    stop_fault_ = LinkFault::kNone;
    driving_ = false;
    return robot_.halt();
  }
  if (const auto refusal = refusalOf(command)) {
    ++report_.refused[static_cast<std::size_t>(*refusal)];
    if (*refusal == RobotRefusal::kBeyondLimits || *refusal == RobotRefusal::kNotFromRest)
      stop(LinkFault::kDriveFault);
    return;
  }
  ++report_.commands;
  state_.heeded = command.sequence;
  from_ = setpoint_ = driving_ ? setpoint_ : state_.q_rad;
  to_ = command.q_rad;
  commanded_at_ = now_;
  driving_ = true;
}

std::optional<RobotRefusal> IgtlRobotHost::refusalOf(const RobotCommandMessage& command) const {
  if (!settings_.allow_motion) return RobotRefusal::kNotAllowed;
  if (command.sequence <= state_.heeded) return RobotRefusal::kOutOfOrder;
  const bool is_known =
      command.reflected <= state_.sequence && state_.sequence - command.reflected < told_at_.size();
  if (!is_known || now_ - told_at_[command.reflected % told_at_.size()] > settings_.oldest)
    return RobotRefusal::kTooOld;
  if (stop_fault_ != LinkFault::kNone || robot_fault_ != LinkFault::kNone) return RobotRefusal::kStopped;
  if (!isWithinLimits(command.q_rad)) return RobotRefusal::kBeyondLimits;
  if (driving_) return std::nullopt;
  const bool begins_here =
      (command.q_rad - state_.q_rad).cwiseAbs().maxCoeff() <= settings_.start_tolerance_rad;
  if (!begins_here || state_.v_rad_s.cwiseAbs().maxCoeff() > kRest_rad_s) return RobotRefusal::kNotFromRest;
  return std::nullopt;
}

bool IgtlRobotHost::isWithinLimits(const Joints& q_rad) const {
  if (q_rad.size() != lower_rad_.size() || state_.q_rad.size() != lower_rad_.size()) return false;
  if ((q_rad.array() < lower_rad_.array()).any() || (q_rad.array() > upper_rad_.array()).any()) return false;
  if (!driving_) return true;
  const double elapsed_s = std::max(secondsBetween(commanded_at_, now_), settings_.period.count());
  return ((q_rad - to_).array().abs() <= kSpeedMargin * elapsed_s * max_speed_rad_s_.array()).all();
}

/// On the straight line from command to command, reaching the newest a period after it came.
void IgtlRobotHost::drive() {
  const double share = std::min(1.0, secondsBetween(commanded_at_, now_) / settings_.period.count());
  setpoint_ = from_ + share * (to_ - from_);
  const auto sent = robot_.command({setpoint_, {}});
  if (!sent && sent.error() != LinkFault::kNoAnswer) stop(sent.error());
}

void IgtlRobotHost::stop(LinkFault fault) {
  driving_ = false;
  stop_fault_ = fault;
  ++report_.stops;
  robot_.halt();
}

void IgtlRobotHost::tell() {
  if (!client_.isOpen() || state_.q_rad.size() == 0) return;
  state_.fault = stop_fault_ != LinkFault::kNone ? stop_fault_ : robot_fault_;
  ++state_.sequence;
  told_at_[state_.sequence % told_at_.size()] = now_;
  RobotMessageBytes bytes;
  if (!client_.send(encode(state_, bytes))) return hangUp();
  ++report_.states;
}

}  // namespace mirrorarm::devices
