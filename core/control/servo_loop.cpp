#include "core/control/servo_loop.h"

#include <algorithm>
#include <cmath>

#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/control/beat.h"
#include "core/control/stop_latch.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::LinkFault;
using robot::MotionState;

constexpr double kCommandedRest_rad_s = 1e-3;
constexpr double kMeasuredRest_rad_s = 1e-2;  // encoders are noisy
constexpr double kNear_rad = 0.01;            // a motion this near is taken up again after a hold
constexpr std::size_t kStates = 256;

double largest(const Joints& q) { return q.size() > 0 ? q.cwiseAbs().maxCoeff() : 0.0; }

/// Stops after which the robot may not be where it was commanded, so that braking by commands could be a
/// jump.
bool leavesRobotInDoubt(StopReason reason) {
  return reason == StopReason::kRobotSilent || reason == StopReason::kRobotFault ||
         reason == StopReason::kServoLate || reason == StopReason::kFollowingError;
}

bool isUsable(const robot::RobotState& state, int joints) {
  return state.q_rad.size() == joints && state.v_rad_s.size() == joints && state.q_rad.allFinite() &&
         state.v_rad_s.allFinite();
}

bool cannotMove(LinkFault fault) { return fault == LinkFault::kNotReady || fault == LinkFault::kDriveFault; }

/// A trajectory and the latch at the time it was handed over: it is good while the latch has not changed
/// since.
struct Order {
  robot::Trajectory trajectory;
  StopLatch::Value latch;
};

}  // namespace

struct ServoLoop::Body {
  Body(const robot::ArmDescription& arm, const robot::MotionLimits& profile, robot::RobotLink& robot_link,
       const SupervisorSettings& settings)
      : limits(profile),
        link(robot_link),
        supervisor(settings),
        period_s(robot_link.period().count()),
        kinematics(arm),
        beat(robot_link.period()) {}

  void begin(TimePoint now) noexcept {
    state.time = beat.next(now);
    if (!running) vitals.last_robot = vitals.last_cycle = now;
    running = true;
    vitals.now = now;
    state.guard = robot::GuardAction::kPassed;
  }

  void readRobot() noexcept {
    const auto read = link.read();
    const bool usable = read && isUsable(*read, kinematics.jointCount());
    fault = usable ? LinkFault::kNone : read ? LinkFault::kDriveFault : read.error();
    if (cannotMove(fault)) latch.stop(StopReason::kRobotFault);
    if (!usable) return;
    state.measured = *read;
    // A time from the future would never grow old.
    vitals.last_robot = std::min(read->measured_at, vitals.now);
  }

  void takeMail() noexcept {
    if (const Tracking* const news = tracking.take()) {
      vitals.last_frame = news->last_frame;
      vitals.last_target = news->last_target;
      vitals.following = news->following;
    }
    if (const Order* const news = orders.take()) order = news;
  }

  void watch() noexcept {
    vitals.following_error_rad = driven ? largest(state.commanded.q_rad - state.measured.q_rad) : 0.0;
    const Verdict verdict = supervise(vitals, supervisor);
    vitals.last_cycle = vitals.now;
    if (verdict.permit == Permit::kStop) latch.stop(verdict.reason);
    latched = latch.value();
    in_doubt = leavesRobotInDoubt(latched.reason) || leavesRobotInDoubt(verdict.reason) || cannotMove(fault);
    state.permit = latched.reason == StopReason::kNone ? verdict.permit : Permit::kStop;
  }

  void move() noexcept {
    if (in_doubt) return halt();
    if (!driven && !takeOver()) return watchOnly();
    const MotionState* const goal = wished();
    const robot::Jacobian J = kinematics.jacobian(last.q_rad);
    const robot::Guarded guarded = goal ? guardMotion({goal->q_rad, goal->v_rad_s}, last, J, period_s, limits)
                                        : brakeMotion(last, J, period_s, limits);
    if (goal && guarded.action == robot::GuardAction::kPassed)
      state.commanded = *goal;
    else
      state.commanded = {guarded.command.q_rad, guarded.command.v_rad_s,
                         (guarded.command.v_rad_s - last.v_rad_s) / period_s};
    state.guard = guarded.action;
    state.sent = last = guarded.command;
    send();
  }

  /// What the motion in force wants now; nullptr to brake.
  const MotionState* wished() noexcept {
    if (state.permit != Permit::kMove) {
      interrupted = true;
      return nullptr;
    }
    if (order == nullptr || order->latch != latched || !order->trajectory.valid()) return nullptr;
    wish = order->trajectory.at(state.time);
    if (interrupted && largest(wish.q_rad - last.q_rad) > kNear_rad) {
      order = nullptr;
      return nullptr;
    }
    interrupted = false;
    return &wish;
  }

  void send() noexcept {
    const auto sent = link.command({last.q_rad, {}});
    if (sent || !cannotMove(sent.error())) return;  // a silent robot is the watchdog's business
    fault = sent.error();
    latch.stop(StopReason::kRobotFault);
    halt();
  }

  void halt() noexcept {
    link.halt();
    watchOnly();
  }

  /// Not driving: what is commanded is what is.
  void watchOnly() noexcept {
    driven = false;
    state.sent = {};
    state.commanded = {state.measured.q_rad, state.measured.v_rad_s,
                       Joints::Zero(state.measured.q_rad.size())};
  }

  /// Starts driving from where the robot rests.
  bool takeOver() noexcept {
    const Joints& q = state.measured.q_rad;
    if (fault != LinkFault::kNone || largest(state.measured.v_rad_s) > kMeasuredRest_rad_s) return false;
    last = {q, Joints::Zero(q.size())};
    return driven = true;
  }

  const ServoState& conclude() noexcept {
    state.stop = latch.value().reason;
    state.at_rest = state.measured.q_rad.size() > 0 &&
                    largest(state.measured.v_rad_s) < kMeasuredRest_rad_s &&
                    (!driven || largest(last.v_rad_s) < kCommandedRest_rad_s);
    static_cast<void>(states.push(state));  // who does not take them misses them, as the header says
    return state;
  }

  // Never changed after construction.
  const robot::MotionLimits limits;
  robot::RobotLink& link;
  const SupervisorSettings supervisor;
  const double period_s;

  // Between threads.
  StopLatch latch;                           // any thread
  LatestValue<Order> orders;                 // control -> servo
  LatestValue<Tracking> tracking;            // control -> servo
  BoundedQueue<ServoState, kStates> states;  // servo -> control

  // Servo thread only.
  robot::Kinematics kinematics;
  Beat beat;
  Vitals vitals;
  ServoState state;
  robot::Commanded last;  // what was sent; good while `driven`
  MotionState wish;
  const Order* order = nullptr;  // in force; inside `orders` until the next is taken
  StopLatch::Value latched;
  LinkFault fault = LinkFault::kNone;
  bool in_doubt = false;  // the latch keeps the first reason only; a robot may fail while it is being stopped
  bool running = false;
  bool driven = false;
  bool interrupted = false;  // by a hold or a stop since the motion in force was followed last
};

ServoLoop::ServoLoop(const robot::ArmDescription& arm, const robot::MotionLimits& limits,
                     robot::RobotLink& link, const SupervisorSettings& supervisor)
    : body_(std::make_unique<Body>(arm, limits, link, supervisor)) {}
ServoLoop::~ServoLoop() = default;

const ServoState& ServoLoop::step(TimePoint now) noexcept {
  body_->begin(now);
  body_->readRobot();
  body_->takeMail();
  body_->watch();
  body_->move();
  return body_->conclude();
}

void ServoLoop::setTrajectory(const robot::Trajectory& trajectory) noexcept {
  body_->orders.put({trajectory, body_->latch.value()});
}
void ServoLoop::setTracking(const Tracking& tracking) noexcept { body_->tracking.put(tracking); }
void ServoLoop::stop(StopReason reason) noexcept { body_->latch.stop(reason); }
void ServoLoop::resetStop() noexcept { body_->latch.reset(); }
std::optional<ServoState> ServoLoop::takeState() noexcept { return body_->states.pop(); }

}  // namespace mirrorarm::control
