#include "core/devices/fri_session.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/devices/fri_joints.h"

namespace mirrorarm::devices {
namespace {

using robot::Joints;
using robot::LinkFault;

constexpr int kBelieveAfter = 10;  // datagrams in a row that seem old or wrong: the controller has begun anew
constexpr double kMeasuredMargin = 2.0;  // on the joints' speeds, for what is measured
constexpr double kPeriodTolerance = 0.05;
constexpr double kRest_rad = 1e-3;   // commands within this hold still
constexpr double kJumpMargin = 1.1;  // on the joints' speeds, for uneven cycles
constexpr std::uint16_t kHalfTheNumbers = 0x8000;
// The ranges that the controller takes.
constexpr double kLeastStiffness = 0.01, kMostJointStiffness = 2000.0, kMostToolStiffness = 5000.0,
                 kMostToolTurningStiffness = 300.0, kLeastDamping = 0.1, kMostDamping = 1.0;

double largest(const Joints& q) { return q.cwiseAbs().maxCoeff(); }

FriControl controlOf(robot::GivesWay gives_way) {
  switch (gives_way) {
    case robot::GivesWay::kInJoints:
      return FriControl::kJointImpedance;
    case robot::GivesWay::kAtTool:
      return FriControl::kCartesianImpedance;
    case robot::GivesWay::kNot:
      break;
  }
  return FriControl::kPosition;
}

void set(FriVariables& variables, int number, std::int32_t value) {
  if (number >= 1 && number <= static_cast<int>(variables.integers.size()))
    variables.integers[static_cast<std::size_t>(number - 1)] = value;
}

bool isFinite(const robot::Compliance& compliance) {
  return compliance.joint_stiffness_nm_rad.allFinite() && compliance.tool_stiffness.allFinite() &&
         std::isfinite(compliance.joint_damping) && std::isfinite(compliance.tool_damping);
}

float bounded(double value, double least, double most) {
  return static_cast<float>(std::clamp(value, least, most));
}

}  // namespace

std::string_view id(FriPhase phase) {
  constexpr std::array<std::string_view, 6> kIds{"absent",     "monitoring", "starting",
                                                 "commanding", "stopping",   "fallen"};
  return kIds[static_cast<std::size_t>(phase)];
}

std::string_view id(FriFall fall) {
  constexpr std::array<std::string_view, 13> kIds{
      "none",       "silence",      "lost_datagrams", "poor_quality",  "drive_error",
      "drives_off", "left_command", "not_started",    "wrong_control", "wrong_period",
      "start_pose", "moved_early",  "wrong_command"};
  return kIds[static_cast<std::size_t>(fall)];
}

LinkFault linkFaultOf(FriFall fall) {
  switch (fall) {
    case FriFall::kNone:
      return LinkFault::kNone;
    case FriFall::kSilence:
      return LinkFault::kNoAnswer;
    case FriFall::kLostDatagrams:
    case FriFall::kPoorQuality:
      return LinkFault::kPoorLine;
    case FriFall::kDriveError:
    case FriFall::kStartPose:
    case FriFall::kWrongCommand:
      return LinkFault::kDriveFault;
    case FriFall::kDrivesOff:
    case FriFall::kLeftCommand:
    case FriFall::kNotStarted:
    case FriFall::kWrongControl:
    case FriFall::kWrongPeriod:
    case FriFall::kMovedEarly:
      break;
  }
  return LinkFault::kNotReady;
}

FriSession::FriSession(const FriSettings& settings) : settings_(settings) {
  assert(settings.gives_way != robot::GivesWay::kAtTool || settings.arm);
  if (settings.gives_way == robot::GivesWay::kAtTool) tool_pose_.emplace(*settings.arm);
}

LinkFault FriSession::fault() const noexcept {
  if (phase_ == FriPhase::kAbsent) return LinkFault::kNoAnswer;
  if (phase_ == FriPhase::kFallen) return linkFaultOf(fall_);
  return newest_.drive_errors != 0 ? LinkFault::kDriveFault : LinkFault::kNone;
}

bool FriSession::isNews(const FriMeasurement& measurement) noexcept {
  elapsed_s_ = 0.0;
  if (!in_step_) return in_step_ = true;
  const auto step = static_cast<std::uint16_t>(measurement.sequence - newest_.sequence);
  if (step == 0) return ++counts_.duplicated, false;
  const bool backwards = step >= kHalfTheNumbers;
  if (backwards || !isPossible(measurement, step)) {
    ++(backwards ? counts_.reordered : counts_.implausible);
    if (++disbelieved_in_a_row_ < kBelieveAfter) return false;
    fallBy(FriFall::kLostDatagrams);
    disbelieved_in_a_row_ = 0;
    return true;
  }
  disbelieved_in_a_row_ = 0;
  counts_.lost += step - 1u;
  elapsed_s_ = step * double{measurement.measurement_period_s};
  if (step - 1 > settings_.lost_in_a_row) fallBy(FriFall::kLostDatagrams);
  return true;
}

/// Whether the arm can have moved so far since the newest datagram.
bool FriSession::isPossible(const FriMeasurement& measurement, int cycles) const noexcept {
  const double elapsed_s = cycles * double{measurement.measurement_period_s};
  const Joints moved = (jointsOf(measurement.q_rad) - jointsOf(newest_.q_rad)).cwiseAbs();
  return (moved.array() <= kMeasuredMargin * elapsed_s * settings_.max_speed_rad_s.array() + kRest_rad).all();
}

bool FriSession::take(const FriMeasurement& measurement) noexcept {
  const bool could_move = in_step_ && controllerMoves();
  if (!isNews(measurement)) return false;
  ++counts_.taken;
  newest_ = measurement;
  commanded_ = false;
  unsent_s_ += elapsed_s_;
  if (!could_move || elapsed_s_ == 0.0 || !controllerMoves()) mirror();
  if (phase_ == FriPhase::kAbsent) phase_ = FriPhase::kMonitoring;
  watch();
  return true;
}

void FriSession::silence() noexcept {
  in_step_ = false;
  if (phase_ == FriPhase::kStarting || phase_ == FriPhase::kCommanding)
    fallBy(FriFall::kSilence);
  else if (phase_ != FriPhase::kFallen)
    phase_ = FriPhase::kAbsent;
}

/// Whether what the host sends moves the arm.
bool FriSession::controllerMoves() const noexcept {
  return newest_.state == FriState::kCommand && newest_.drives_on != 0;
}

void FriSession::fallBy(FriFall reason) noexcept {
  if (phase_ == FriPhase::kFallen || phase_ == FriPhase::kAbsent || phase_ == FriPhase::kStopping) return;
  // A controller that monitors can be late without harm.
  if (phase_ == FriPhase::kMonitoring && linkFaultOf(reason) == LinkFault::kPoorLine) return;
  phase_ = FriPhase::kFallen;
  fall_ = reason;
  ++counts_.falls;
}

void FriSession::watch() noexcept {
  const bool commands = newest_.state == FriState::kCommand;
  if (phase_ == FriPhase::kMonitoring && commands) phase_ = FriPhase::kStopping;
  if (phase_ == FriPhase::kStopping && !commands) phase_ = FriPhase::kMonitoring;
  if (phase_ != FriPhase::kStarting && phase_ != FriPhase::kCommanding) return;
  if (newest_.drive_errors != 0) return fallBy(FriFall::kDriveError);
  if (newest_.drives_on == 0) return fallBy(FriFall::kDrivesOff);
  if (commands || entered_) {
    if (newest_.quality < settings_.quality_to_move) return fallBy(FriFall::kPoorQuality);
    if (!commands) return fallBy(FriFall::kLeftCommand);
  }
  if (phase_ == FriPhase::kStarting) commands ? enterCommand() : waitForStart();
}

void FriSession::waitForStart() noexcept {
  waited_s_ += elapsed_s_;
  if (waited_s_ > settings_.start_patience.count()) return fallBy(FriFall::kNotStarted);
  asked_ = asked_ || programIsReady();
}

bool FriSession::programIsReady() const noexcept {
  const FriHandshake& handshake = settings_.handshake;
  const bool heeds =
      handshake.echo == 0 ||
      newest_.to_host.integers[static_cast<std::size_t>(handshake.echo - 1)] != handshake.start;
  return heeds && newest_.quality >= settings_.quality_to_start &&
         newest_.control == controlOf(settings_.gives_way);
}

void FriSession::enterCommand() noexcept {
  if (newest_.control != controlOf(settings_.gives_way)) return fallBy(FriFall::kWrongControl);
  waited_s_ = entered_ ? waited_s_ + elapsed_s_ : 0.0;
  entered_ = true;
  if (waited_s_ < settings_.settle.count()) return;
  shift_ = held_ - wished_;
  if (largest(shift_) > settings_.start_tolerance_rad) return fallBy(FriFall::kStartPose);
  phase_ = FriPhase::kCommanding;
}

Expected<void, LinkFault> FriSession::command(const robot::RobotCommand& command) noexcept {
  if (const LinkFault present = fault(); present != LinkFault::kNone) return unexpected(present);
  if (phase_ == FriPhase::kStopping) return unexpected(LinkFault::kNotReady);
  const FriFall reason = isFinite(command.compliance) ? takeWish(command.q_rad) : FriFall::kWrongCommand;
  if (reason != FriFall::kNone) {
    fallBy(reason);
    return unexpected(linkFaultOf(reason));
  }
  takeCompliance(command.compliance);
  return {};
}

void FriSession::takeCompliance(const robot::Compliance& wish) noexcept {
  if (wish.joint_stiffness_nm_rad.size() == kFriJoints) {
    compliance_.joint_stiffness_nm_rad = wish.joint_stiffness_nm_rad;
    compliance_.joint_damping = wish.joint_damping;
  }
  if ((wish.tool_stiffness.array() > 0.0).all()) {
    compliance_.tool_stiffness = wish.tool_stiffness;
    compliance_.tool_damping = wish.tool_damping;
  }
}

FriFall FriSession::takeWish(const Joints& q_rad) noexcept {
  if (q_rad.size() != kFriJoints || !q_rad.allFinite()) return FriFall::kWrongCommand;
  wished_ = q_rad;
  if (phase_ == FriPhase::kMonitoring) return beginAt(q_rad);
  if (phase_ == FriPhase::kStarting)
    return largest(q_rad - beginning_) > kRest_rad ? FriFall::kMovedEarly : FriFall::kNone;
  const Joints step = (q_rad + shift_ - held_).cwiseAbs();
  if ((step.array() > kJumpMargin * unsent_s_ * settings_.max_speed_rad_s.array() + 1e-6).any())
    return FriFall::kWrongCommand;
  commanded_ = true;
  return FriFall::kNone;
}

FriFall FriSession::beginAt(const Joints& q_rad) noexcept {
  if (newest_.drives_on == 0) return FriFall::kDrivesOff;
  if (std::abs(newest_.measurement_period_s / settings_.period.count() - 1.0) > kPeriodTolerance)
    return FriFall::kWrongPeriod;
  if (largest(held_ - q_rad) > settings_.start_tolerance_rad) return FriFall::kStartPose;
  beginning_ = q_rad;
  asked_ = entered_ = false;
  waited_s_ = 0.0;
  phase_ = FriPhase::kStarting;
  return FriFall::kNone;
}

void FriSession::halt() noexcept {
  if (phase_ == FriPhase::kAbsent) return;
  if (!in_step_)
    phase_ = FriPhase::kAbsent;
  else
    phase_ = newest_.state == FriState::kCommand ? FriPhase::kStopping : FriPhase::kMonitoring;
}

void FriSession::mirror() noexcept {
  held_ = heldBy(newest_);
  speed_ = Joints::Zero(kFriJoints);
  if (tool_pose_) tool_pose_->mirror(held_, newest_.flange);
  compliance_ = settings_.compliance;
}

void FriSession::brake() noexcept {
  const double fastest = largest(speed_);
  if (fastest == 0.0) return;
  speed_ *= std::max(0.0, 1.0 - settings_.braking_rad_s2 * unsent_s_ / fastest);
  held_ += unsent_s_ * speed_;
}

FriCommand FriSession::answer() noexcept {
  if (phase_ == FriPhase::kCommanding && commanded_) {
    speed_ = (wished_ + shift_ - held_) / unsent_s_;
    held_ = wished_ + shift_;
  } else if (controllerMoves()) {
    brake();
  }
  unsent_s_ = 0.0;
  FriCommand answer;
  answer.sequence = ++sent_sequence_;
  answer.reflected = newest_.sequence;
  const bool wants = phase_ == FriPhase::kCommanding || (phase_ == FriPhase::kStarting && asked_);
  const FriHandshake& handshake = settings_.handshake;
  set(answer.from_host, handshake.start_request, wants ? handshake.start : handshake.stop);
  answer.flags = kFriJointPosition;
  answer.q_rad = friJointsOf(held_);
  fillImpedance(answer);
  return answer;
}

/// The kind of control that is asked for, and its springs.
void FriSession::fillImpedance(FriCommand& answer) const noexcept {
  const robot::GivesWay gives_way = settings_.gives_way;
  constexpr std::array<std::int32_t, 3> kRequest{10, 30, 20};  // by GivesWay
  set(answer.from_host, settings_.handshake.control_request, kRequest[static_cast<std::size_t>(gives_way)]);
  if (gives_way == robot::GivesWay::kInJoints) {
    answer.flags |= kFriJointStiffness | kFriJointDamping;
    for (std::size_t i = 0; i < kFriJoints; ++i)
      answer.joint_stiffness_nm_rad[i] =
          bounded(compliance_.joint_stiffness_nm_rad[static_cast<Eigen::Index>(i)], kLeastStiffness,
                  kMostJointStiffness);
    answer.joint_damping.fill(bounded(compliance_.joint_damping, kLeastDamping, kMostDamping));
  }
  if (gives_way == robot::GivesWay::kAtTool) {
    answer.flags |= kFriToolPosition | kFriToolStiffness | kFriToolDamping;
    answer.flange = tool_pose_->at(held_);
    constexpr std::array<Eigen::Index, 6> kOrder{0, 1, 2, 5, 4, 3};  // the wire's X Y Z RZ RY RX
    for (std::size_t i = 0; i < kOrder.size(); ++i)
      answer.tool_stiffness[i] = bounded(compliance_.tool_stiffness[kOrder[i]], kLeastStiffness,
                                         i < 3 ? kMostToolStiffness : kMostToolTurningStiffness);
    answer.tool_damping.fill(bounded(compliance_.tool_damping, kLeastDamping, kMostDamping));
  }
}

}  // namespace mirrorarm::devices
