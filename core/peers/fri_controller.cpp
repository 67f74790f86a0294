#include "core/peers/fri_controller.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/devices/fri_joints.h"

namespace mirrorarm::peers {
namespace {

using devices::FriControl;
using devices::FriQuality;
using devices::FriState;
using robot::Joints;

constexpr std::uint16_t kAllDrives = 0x7F;
constexpr std::int32_t kInitialised = 10;  // what the program tells before any request
constexpr double kJumpMargin = 1.2;        // single precision and the host's own rounding
constexpr std::size_t kMostFalls = 1000, kMostMissed = 100'000;
constexpr Clock::duration kDriveStep = std::chrono::milliseconds(1);
constexpr std::uint16_t kHalfTheNumbers = 0x8000;

double largest(const Joints& q) { return q.cwiseAbs().maxCoeff(); }

std::int32_t valueOf(const devices::FriVariables& variables, int number) {
  return variables.integers[static_cast<std::size_t>(number - 1)];
}

FriControl controlOf(std::int32_t request, FriControl present) {
  if (request == 10) return FriControl::kPosition;
  if (request == 20) return FriControl::kCartesianImpedance;
  return request == 30 ? FriControl::kJointImpedance : present;
}

/// 3x4, row by row.
std::array<float, 12> wirePose(const RigidTransform& X) {
  std::array<float, 12> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(X(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)));
  return values;
}

/// Rows X Y Z RZ RY RX.
std::array<float, 42> wireJacobian(const robot::Jacobian& J) {
  constexpr std::array<Eigen::Index, 6> kRows{0, 1, 2, 5, 4, 3};
  std::array<float, 42> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(
        J(kRows[i / devices::kFriJoints], static_cast<Eigen::Index>(i % devices::kFriJoints)));
  return values;
}

}  // namespace

std::string_view id(FriControllerFall fall) {
  constexpr std::array<std::string_view, 8> kIds{
      "stopped", "missed_answers", "poor_quality", "jump", "limit", "flags", "drives", "interpolation_error"};
  return kIds[static_cast<std::size_t>(fall)];
}

FriController::FriController(const robot::ArmDescription& arm, const Joints& start,
                             const FriControllerSettings& settings)
    : settings_(settings),
      lower_rad_(devices::kFriJoints),
      upper_rad_(devices::kFriJoints),
      max_speed_rad_s_(devices::kFriJoints),
      kinematics_(arm),
      drives_(arm, start),
      base_(start),
      commanded_(start),
      step_(Joints::Zero(start.size())) {
  assert(arm.joints.size() == devices::kFriJoints);
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    lower_rad_[i] = joint.lower_rad;
    upper_rad_[i] = joint.upper_rad;
    max_speed_rad_s_[i] = joint.max_speed_rad_s;
  }
  sent_.to_host.integers[static_cast<std::size_t>(settings_.handshake.echo - 1)] = kInitialised;
}

Joints FriController::held() const {
  return state_ == FriState::kCommand ? commanded_ : (base_.array() + misplaced_rad_).matrix();
}

void FriController::answer(std::span<const std::byte> bytes, TimePoint arrived_at) {
  const auto command = devices::friCommandOf(bytes);
  if (!command) {
    ++report_.refused;
    return;
  }
  const auto step = static_cast<std::uint16_t>(command->sequence - heard_sequence_);
  if (heard_ && step == 0) return void(++report_.doubled);
  if (heard_ && step >= kHalfTheNumbers) return void(++report_.out_of_order);
  heard_ = true;
  heard_sequence_ = command->sequence;
  if (command->reflected != sent_.sequence) return void(++report_.late);
  latency_s_[sent_.sequence % latency_s_.size()] =
      static_cast<float>(std::max(0.0, secondsBetween(cycle_at_, arrived_at)));
  answer_ = *command;
  answered_ = true;
}

const devices::FriMeasurement& FriController::cycle(TimePoint now) {
  cycle_at_ = now;
  if (report_.cycles > 0) judgeAnswer();
  judgeQuality();
  state_ == FriState::kCommand ? obey() : monitor();
  moveArm();
  if (state_ != FriState::kCommand) base_ = commanded_ = drives_.q();
  describe();
  answered_ = false;
  ++report_.cycles;
  return sent_;
}

/// The arm's time is made of whole cycles, however unevenly they are called.
void FriController::moveArm() {
  const auto steps = std::max<Clock::rep>(1, toClock(settings_.period) / kDriveStep);
  const auto step = toClock(settings_.period) / steps;
  for (Clock::rep i = 0; i < steps; ++i) {
    arm_time_ += step;
    drives_.advance(arm_time_, step);
  }
}

void FriController::judgeAnswer() {
  in_time_[sent_.sequence % in_time_.size()] = answered_;
  ++(answered_ ? report_.in_time : report_.missed);
  if (!answered_ && report_.missed_cycles.size() < kMostMissed)
    report_.missed_cycles.push_back(report_.cycles);
  missed_in_a_row_ = answered_ ? 0 : missed_in_a_row_ + 1;
  const bool mirrors =
      largest(devices::jointsOf(answer_.q_rad) - devices::heldBy(sent_)) < settings_.mirror_tolerance_rad;
  if (answered_ && state_ == FriState::kMonitor && !mirrors) ++report_.mirror_errors;
}

void FriController::judgeQuality() {
  const double share = static_cast<double>(std::count(in_time_.begin(), in_time_.end(), true)) /
                       static_cast<double>(in_time_.size());
  quality_ = share >= settings_.perfect_share ? FriQuality::kPerfect
             : share >= settings_.ok_share    ? FriQuality::kOk
             : share >= settings_.bad_share   ? FriQuality::kBad
                                              : FriQuality::kUnacceptable;
  quality_ = std::min(quality_, best_quality_);
}

void FriController::monitor() {
  if (answered_) heed(answer_.from_host);
}

/// The program on the controller.
void FriController::heed(const devices::FriVariables& wishes) {
  const devices::FriHandshake& handshake = settings_.handshake;
  control_ = controlOf(valueOf(wishes, handshake.control_request), control_);
  const bool asks = valueOf(wishes, handshake.start_request) == handshake.start;
  asked_s_ = asks ? asked_s_ + settings_.period.count() : 0.0;
  if (!asks) {
    refused_ = false;
    sent_.to_host.integers[static_cast<std::size_t>(handshake.echo - 1)] = handshake.stop;
  }
  if (asked_s_ > settings_.start_delay.count() && !refused_ && quality_ == FriQuality::kPerfect) start();
}

void FriController::start() {
  refused_ = true;
  if (drive_errors_ != 0) return fall(FriControllerFall::kDrives);
  const bool mirrors =
      largest(devices::jointsOf(answer_.q_rad) - devices::heldBy(sent_)) < settings_.mirror_tolerance_rad;
  if (!mirrors || (answer_.flags & devices::kFriJointPosition) == 0)
    return fall(FriControllerFall::kInterpolationError);
  state_ = FriState::kCommand;
  flags_ = answer_.flags;
  base_ = commanded_ = devices::heldBy(sent_);
  step_.setZero();
  sent_.to_host.integers[static_cast<std::size_t>(settings_.handshake.echo - 1)] = settings_.handshake.start;
  ++report_.starts;
}

void FriController::obey() {
  if (drive_errors_ != 0) return fall(FriControllerFall::kDrives);
  if (quality_ < FriQuality::kOk) return fall(FriControllerFall::kPoorQuality);
  if (missed_in_a_row_ > settings_.bridged_in_a_row) return fall(FriControllerFall::kMissedAnswers);
  if (answered_)
    follow(answer_);
  else
    commanded_ = (commanded_ + step_).cwiseMax(lower_rad_).cwiseMin(upper_rad_);
  if (state_ == FriState::kCommand) drives_.command(arm_time_, commanded_);
}

void FriController::follow(const devices::FriCommand& answer) {
  const devices::FriHandshake& handshake = settings_.handshake;
  if (valueOf(answer.from_host, handshake.start_request) != handshake.start)
    return fall(FriControllerFall::kStopped);
  if (answer.flags != flags_) return fall(FriControllerFall::kFlags);
  const Joints q = devices::jointsOf(answer.q_rad);
  const Joints most = kJumpMargin * settings_.safety_factor * settings_.period.count() * max_speed_rad_s_;
  if (((q - commanded_).array().abs() > most.array()).any()) return fall(FriControllerFall::kJump);
  if ((q.array() < lower_rad_.array()).any() || (q.array() > upper_rad_.array()).any())
    return fall(FriControllerFall::kLimit);
  step_ = q - commanded_;
  commanded_ = q;
}

void FriController::fall(FriControllerFall why) {
  state_ = FriState::kMonitor;
  drives_.halt();
  asked_s_ = 0.0;
  if (report_.falls.size() < kMostFalls)
    report_.falls.push_back({Seconds(arm_time_.time_since_epoch()).count(), why});
}

void FriController::describe() {
  ++sent_.sequence;
  sent_.reflected = heard_sequence_;
  sent_.timestamp_s = static_cast<float>(Seconds(arm_time_.time_since_epoch()).count());
  sent_.state = state_;
  sent_.quality = quality_;
  sent_.measurement_period_s = sent_.command_period_s = static_cast<float>(settings_.period.count());
  sent_.safety_factor = static_cast<float>(settings_.safety_factor);
  const auto answers = std::count(in_time_.begin(), in_time_.end(), true);
  sent_.answers.answer_rate = static_cast<float>(answers) / static_cast<float>(in_time_.size());
  sent_.answers.miss_rate = 1.0F - sent_.answers.answer_rate;
  sent_.answers.misses = static_cast<std::uint32_t>(report_.missed);
  const auto [least, most] = std::minmax_element(latency_s_.begin(), latency_s_.end());
  sent_.answers.latency_s =
      std::accumulate(latency_s_.begin(), latency_s_.end(), 0.0F) / static_cast<float>(latency_s_.size());
  sent_.answers.jitter_s = *most - *least;
  sent_.drives_on = drive_errors_ == 0 ? kAllDrives : 0;
  sent_.drive_errors = drive_errors_;
  sent_.control = control_;
  sent_.q_rad = devices::friJointsOf(drives_.q());
  sent_.commanded_q_rad = devices::friJointsOf(state_ == FriState::kCommand ? base_ : held());
  sent_.commanded_q_offset_rad = devices::friJointsOf(
      state_ == FriState::kCommand ? Joints(commanded_ - base_) : Joints(Joints::Zero(base_.size())));
  sent_.flange = sent_.commanded_flange = wirePose(kinematics_.flange(drives_.q()));
  sent_.jacobian = wireJacobian(kinematics_.jacobian(drives_.q()));
}

}  // namespace mirrorarm::peers
