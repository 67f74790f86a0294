#include "core/control/servo_loop.h"

#include <algorithm>
#include <cmath>

#include "core/common/bounded_queue.h"
#include "core/common/latest_value.h"
#include "core/control/beat.h"
#include "core/control/soft_start.h"
#include "core/control/stop_latch.h"

namespace mirrorarm::control {
namespace {

using robot::Joints;
using robot::LinkFault;
using robot::MotionState;

constexpr double kCommandedRest_rad_s = 1e-3;
constexpr double kMeasuredRest_rad_s = 1e-2;  // encoders are noisy
constexpr double kSoftRest_rad_s = 5e-2;      // springs give way to the arm that hangs in them
constexpr double kNear_rad = 0.01;            // a motion this near is taken up again after a hold
constexpr std::size_t kStates = 2048;

double largest(const Joints& q) { return q.size() > 0 ? q.cwiseAbs().maxCoeff() : 0.0; }

bool isUsable(const robot::RobotState& state, int joints) {
  const auto torques = state.external_torque_nm.size();
  return state.q_rad.size() == joints && state.v_rad_s.size() == joints && state.q_rad.allFinite() &&
         state.v_rad_s.allFinite() && (torques == 0 || torques == joints);
}

double ageOf(TimePoint time, TimePoint now) { return time == TimePoint{} ? -1.0 : secondsBetween(time, now); }

/// Springs that the patient's arm stretches are no following error.
robot::MotionLimits limitsFor(const robot::RobotLink& link, robot::MotionLimits limits,
                              const SupervisorSettings& settings) {
  if (link.givesWay() != robot::GivesWay::kNot) limits.max_following_error_rad = settings.max_deflection_rad;
  return limits;
}

/// A trajectory and the latch at the time it was handed over: it is good while the latch has not changed
/// since.
struct Order {
  robot::Trajectory trajectory;
  StopLatch::Value latch;
};

}  // namespace

struct ServoLoop::Body {
  Body(const robot::ArmDescription& arm, const robot::MotionLimits& profile, robot::RobotLink& robot_link,
       const SupervisorSettings& watched, const AssistSettings& helped, robot::Clearance kept)
      : limits(limitsFor(robot_link, profile, watched)),
        braking(brakingLimits(limits)),
        link(robot_link),
        settings(watched),
        period(robot_link.period()),
        enabling(watched.enabling_silent_after),
        kinematics(arm),
        clearance(std::move(kept)),
        beat(robot_link.period()),
        soft_start(watched.soft_start),
        assist(helped, robot_link.givesWay(), robot_link.period()) {
    vitals.gives_way = robot_link.givesWay() != robot::GivesWay::kNot;
    state.enabling_needed = settings.enabling_needed;
  }

  void begin(TimePoint now) noexcept {
    state.time = beat.next(now);
    if (!running) vitals.last_robot = vitals.last_cycle = now;
    running = true;
    vitals.now = now;
    state.guard = robot::GuardAction::kPassed;
  }

  /// A time from the future, told again and again, would never grow old.
  void hear(TimePoint& heard, TimePoint& told, TimePoint news) const noexcept {
    if (news != told) heard = std::min(news, vitals.now);
    told = news;
  }

  void readRobot() noexcept {
    const auto read = link.read();
    // A robot that has felt forces and does not any more would go on without a limit to them.
    const bool usable =
        read && isUsable(*read, kinematics.jointCount()) && (!feels || read->external_torque_nm.size() > 0);
    vitals.fault = usable ? LinkFault::kNone : read ? LinkFault::kDriveFault : read.error();
    if (!usable) return;
    state.measured = *read;
    feels = read->external_torque_nm.size() > 0;
    hear(vitals.last_robot, robot_told, read->measured_at);
    assist.feel(state.measured, kinematics);
  }

  void takeMail() noexcept {
    if (const Tracking* const news = tracking.take()) {
      hear(vitals.last_frame, tracking_told.last_frame, news->last_frame);
      hear(vitals.last_target, tracking_told.last_target, news->last_target);
      vitals.following = news->following;
      vitals.last_decision = vitals.now;
    }
    if (const Help* const news = help.take()) assist.choose(*news);
    state.enabling = vitals.enabling = enabling.update(vitals.now);
    if (const Order* const news = orders.take()) next = news;
    // The motion before goes on until the new one begins.
    if (next == nullptr || next->trajectory.start() > state.time) return;
    order = *next;
    next = nullptr;
    refuseIf(refusalOf(order));  // `vitals.moving` still tells of the motion before
  }

  void watch() noexcept {
    vitals.following_error_rad = driven ? largest(state.commanded.q_rad - state.measured.q_rad) : 0.0;
    vitals.moving = isMoving();
    vitals.force = assist.state().force.level;
    const Verdict verdict = supervise(vitals, settings);
    vitals.last_cycle = vitals.now;
    if (verdict.permit == Permit::kStop) latch.stop(verdict.reason);
    latched = latch.value();
    if (stop.reason == StopReason::kNone) stop.since = vitals.now;
    stop.reason = latched.reason;
    stop.category = categoryNow(stop, verdict.reason, state.at_rest, vitals, settings);
    state.lasting = lastingCause(stop, verdict.reason, vitals, settings);
    state.permit = latched.reason == StopReason::kNone ? verdict.permit : Permit::kStop;
    considerReset();
  }

  void considerReset() noexcept {
    state.reset = latched.reason == StopReason::kNone  ? ResetRefusal::kNotStopped
                  : state.lasting != StopReason::kNone ? ResetRefusal::kCausePersists
                  : !state.at_rest                     ? ResetRefusal::kMoving
                                                       : ResetRefusal::kNone;
    // Good only for the stop it was asked for: not for one that came since.
    const bool asked = reset_asked.exchange(0, std::memory_order_acq_rel) == latched.changes;
    if (!asked || state.reset != ResetRefusal::kNone || !latch.reset(latched)) return;
    latched = latch.value();
    stop = {};
    state.permit = Permit::kHold;  // what may be done is judged anew in the next cycle
    state.reset = ResetRefusal::kNotStopped;
  }

  void move() noexcept {
    if (stop.category == StopCategory::kOne) return halt();
    if (!driven && !takeOver()) return watchOnly();
    const MotionState* const goal = wished();
    const robot::Jacobian J = kinematics.jacobian(last.q_rad);
    const auto rows = clearance.rows(last.q_rad, restOf(last, period.count()));
    const robot::Surroundings around{J, rows, clearance.zoneSpeed(), clearance.hand(),
                                     vitals.following_error_rad};
    const robot::MotionLimits& stopping = state.permit == Permit::kStop ? braking : limits;
    const robot::Guarded guarded =
        goal ? guardMotion(*goal, last, around, period.count(), soft_start.scaled(limits))
             : brakeMotion(last, around, period.count(), stopping);
    const robot::Commanded& sent = guarded.command;
    state.commanded = goal && guarded.action == robot::GuardAction::kPassed
                          ? *goal
                          : MotionState{sent.q_rad, sent.v_rad_s, sent.a_rad_s2};
    state.guard = guarded.action;
    const bool near = guarded.action == robot::GuardAction::kCollision;
    state.guard_contact = near ? std::optional(clearance.kinds(guarded.index)) : std::nullopt;
    state.guard_joint = near ? -1 : guarded.index;
    state.sent = last = guarded.command;
    send();
  }

  /// What the motion in force wants now; nullptr to brake.
  const MotionState* wished() noexcept {
    if (state.permit != Permit::kMove) {
      interrupted = true;
      return nullptr;
    }
    if (!order.trajectory.valid()) {
      interrupted = true;
      return nullptr;
    }
    if (order.latch != latched) return refuseIf(MotionRefusal::kStopped);
    wish = order.trajectory.at(state.time);
    if (interrupted) {
      if (largest(wish.q_rad - last.q_rad) > kNear_rad) return refuseIf(MotionRefusal::kStartElsewhere);
      soft_start.begin(last, limits);
      interrupted = false;
    }
    soft_start.advance(period);
    return &wish;
  }

  /// Whether a motion that was just handed over may be followed.
  [[nodiscard]] MotionRefusal refusalOf(const Order& news) const noexcept {
    if (!news.trajectory.valid()) return MotionRefusal::kNone;
    if (news.latch != latch.value() || news.latch.reason != StopReason::kNone) return MotionRefusal::kStopped;
    if (!link.takesCommands()) return MotionRefusal::kRobotNotReady;
    if (settings.enabling_needed && state.enabling != EnablingPosition::kEnabled && !vitals.moving)
      return MotionRefusal::kNotEnabled;
    const Joints from = news.trajectory.at(state.time).q_rad;
    const Joints& here = driven ? last.q_rad : state.measured.q_rad;
    const bool begins_here =
        from.size() == here.size() && largest(from - here) <= settings.max_start_error_rad;
    return begins_here ? MotionRefusal::kNone : MotionRefusal::kStartElsewhere;
  }

  const MotionState* refuseIf(MotionRefusal refusal) noexcept {
    state.refused = refusal;
    if (refusal == MotionRefusal::kNone) return nullptr;
    order.trajectory = {};
    interrupted = true;
    return nullptr;
  }

  [[nodiscard]] bool isMoving() const noexcept {
    if (!driven) return false;
    const bool has_more = order.trajectory.valid() && order.trajectory.end() > state.time;
    return has_more || largest(last.v_rad_s) > kCommandedRest_rad_s;
  }

  void send() noexcept {
    const bool learning = vitals.following && state.permit == Permit::kMove;
    assist.adapt(last.q_rad, state.measured.q_rad, kinematics, learning);
    const auto sent = link.command({last.q_rad, assist.compliance(kinematics.jointCount())});
    if (sent) return;
    // How long it may be silent is the watchdog's business. But it brakes by itself, or is told to now, and
    // would hurry after commands that went on without it: it is taken over anew once it rests.
    if (sent.error() == LinkFault::kNoAnswer) return halt();
    vitals.fault = sent.error();
    latch.stop(supervise(vitals, settings).reason);
    stop.category = StopCategory::kOne;
    halt();
  }

  void halt() noexcept {
    link.halt();
    watchOnly();
  }

  /// Not driving: what is commanded is what is.
  void watchOnly() noexcept {
    driven = false;
    interrupted = true;
    state.sent = {};
    state.commanded = {state.measured.q_rad, state.measured.v_rad_s,
                       Joints::Zero(state.measured.q_rad.size())};
  }

  /// Starts driving from where the robot rests.
  bool takeOver() noexcept {
    const Joints& q = state.measured.q_rad;
    if (vitals.fault != LinkFault::kNone || largest(state.measured.v_rad_s) > restSpeed()) return false;
    last = robot::restAt(q);
    return driven = true;
  }

  [[nodiscard]] double restSpeed() const noexcept {
    return vitals.gives_way && driven ? kSoftRest_rad_s : kMeasuredRest_rad_s;
  }

  const ServoState& conclude() noexcept {
    state.stop = latch.value().reason;
    state.category =
        state.stop == StopReason::kNone ? StopCategory::kNone : graver(stop.category, categoryOf(state.stop));
    state.at_rest = state.measured.q_rad.size() > 0 && largest(state.measured.v_rad_s) < restSpeed() &&
                    (!driven || largest(last.v_rad_s) < kCommandedRest_rad_s);
    state.soft_start = soft_start.share();
    state.assist = assist.state();
    state.ages = {ageOf(vitals.last_frame, vitals.now), ageOf(vitals.last_target, vitals.now),
                  ageOf(vitals.last_decision, vitals.now), ageOf(vitals.last_robot, vitals.now)};
    static_cast<void>(states.push(state));  // who does not take them misses them, as the header says
    return state;
  }

  // Never changed after construction.
  const robot::MotionLimits limits;
  const robot::MotionLimits braking;  // for a stop; a hold keeps `limits`
  robot::RobotLink& link;
  const SupervisorSettings settings;
  const Seconds period;

  // Between threads.
  StopLatch latch;                            // any thread
  std::atomic<std::uint64_t> reset_asked{0};  // any thread -> servo: the latch's changes at that time
  EnablingSwitch enabling;                    // any thread -> servo
  LatestValue<Order> orders;                  // control -> servo
  LatestValue<Tracking> tracking;             // control -> servo
  LatestValue<Help> help;                     // control -> servo
  BoundedQueue<ServoState, kStates> states;   // servo -> control

  // Servo thread only.
  robot::Kinematics kinematics;
  robot::Clearance clearance;
  Beat beat;
  SoftStart soft_start;
  AssistLoop assist;
  Vitals vitals;
  TimePoint robot_told{};  // as the robot itself said, however wrong
  Tracking tracking_told;
  bool feels = false;  // the robot has told outside torques
  ServoState state;
  robot::Commanded last;  // what was sent; good while `driven`
  MotionState wish;
  Order order;                  // in force
  const Order* next = nullptr;  // not begun yet; inside `orders` until the next is taken
  StopLatch::Value latched;
  Stop stop;
  bool running = false;
  bool driven = false;
  bool interrupted = true;  // by a hold or a stop since the motion in force was followed last
};

ServoLoop::ServoLoop(const robot::ArmDescription& arm, const robot::MotionLimits& limits,
                     robot::RobotLink& link, const SupervisorSettings& supervisor,
                     const AssistSettings& assist, robot::Clearance clearance)
    : body_(std::make_unique<Body>(arm, limits, link, supervisor, assist, std::move(clearance))) {}
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
void ServoLoop::setHelp(const Help& help) noexcept { body_->help.put(help); }
void ServoLoop::stop(StopReason reason) noexcept { body_->latch.stop(reason); }
void ServoLoop::resetStop() noexcept {
  body_->reset_asked.store(body_->latch.value().changes, std::memory_order_release);
}
void ServoLoop::setEnabling(EnablingPosition position) noexcept { body_->enabling.set(position); }
std::optional<ServoState> ServoLoop::takeState() noexcept { return body_->states.pop(); }

}  // namespace mirrorarm::control
