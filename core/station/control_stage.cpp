#include "core/station/control_stage.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/common/log.h"

namespace mirrorarm::station {

using therapy::Action;
using therapy::Phase;
using tracking::TrackStatus;

namespace {

/// Two plans of the longest kind: the one that is under way, then the newest question.
constexpr Seconds kPlanningPatience{1.5};

std::string eventOf(const control::Help& help) {
  if (help.adapts) return "help.adapts";
  return "help.fixed." + std::to_string(std::lround(100.0 * help.level));
}

}  // namespace

ControlStage::ControlStage(const Equipment& equipment, const StationSettings& settings,
                           const robot::MotionLimits& limits, control::ServoLoop& servo,
                           control::PlanningDesk& desk, TrackingStage& tracking, RecorderStage& recorder)
    : X_FC_(equipment.X_FC),
      X_FE_(equipment.X_FE),
      clock_offset_(toClock(equipment.clock_offset)),
      calibration_holds_(equipment.calibration_holds),
      midplane_normal_B_(settings.midplane_normal_B),
      fresh_for_(settings.supervisor.hold_after),
      handover_(settings.follower.handover),
      servo_(servo),
      desk_(desk),
      tracking_(tracking),
      recorder_(recorder),
      follower_(equipment.arm, equipment.X_FE, limits,
                robot::CollisionWorld(equipment.arm, equipment.attached, equipment.obstacles),
                settings.follower),
      gaze_(equipment.rig, equipment.X_FE.inverse() * equipment.X_FC),
      digest_(equipment.arm, equipment.robot->period()) {
  state_.help = settings.assist.help;
}

void ControlStage::report(const FrameReport& report) noexcept {
  if (!reports_.push(report)) lost_reports_.fetch_add(1, std::memory_order_relaxed);
}

void ControlStage::step(TimePoint now) {
  now_ = now;
  drainServo();
  takeReports();
  obeyWishes();
  follow();
  tellServo();
  publish();
}

void ControlStage::drainServo() {
  while (const auto cycle = servo_.takeState()) {
    digest_.add(*cycle);
    noteStop(stops_.update(*cycle));
    if (cycle->sent.q_rad.size() > 0)
      arm_delay_.add(cycle->sent.q_rad, cycle->sent.v_rad_s, cycle->measured.q_rad);
  }
  state_.arm_delay_s = arm_delay_.value().count();
  if (const auto* newest = digest_.newest()) state_.servo = *newest;
}

void ControlStage::noteStop(const StopNews& news) {
  if (news.box_due) recorder_.add(RecorderStage::BlackBox{digest_.blackBox(), news.reason});
  if (news.ended) recordEvent("stop_reset");
  if (news.graver) recordEvent("drives_off");
  if (!news.begun) return;
  const std::string event = "stop." + std::string(id(news.reason));
  log(LogLevel::kWarning, event);
  recordEvent(event);
  if (state_.phase == Phase::kTraining) pause();
}

void ControlStage::end() {
  drainServo();
  if (const auto reason = stops_.unkept())
    recorder_.add(RecorderStage::BlackBox{digest_.blackBox(), *reason});
}

void ControlStage::takeReports() {
  while (const auto report = reports_.pop()) takeReport(*report);
  state_.target_fresh = isFresh(target_, now_, fresh_for_);
}

void ControlStage::takeReport(const FrameReport& report) {
  const TimePoint exposed_at = report.exposed_at + clock_offset_;
  seen_.last_frame = exposed_at;
  target_ = report.target;
  state_.taught_markers = report.taught_markers;
  state_.taught_sigma_m = report.taught_sigma_m;
  if (report.teachings != teachings_) endTeaching(report);
  const auto X_BF = digest_.flangeAt(exposed_at);
  if (!X_BF) {
    // Without the flange's pose at the exposure the target's place in the base is unknown.
    target_.status = TrackStatus::kLost;
    return;
  }
  state_.X_BF = *X_BF;
  if (report.target.status != TrackStatus::kLost) noteTarget(report, exposed_at, *X_BF);
  const bool belongs = session_start_ && exposed_at >= *session_start_ && report.has_target;
  if (belongs && state_.phase != Phase::kFinished) sample(report, exposed_at, *X_BF);
}

void ControlStage::noteTarget(const FrameReport& report, TimePoint exposed_at, const RigidTransform& X_BF) {
  state_.X_BT = X_BF * X_FC_ * report.target.X_CT;
  X_BE_at_target_ = X_BF * X_FE_;
  target_radius_m_ = report.target_radius_m;
  if (state_.has_goal) state_.X_BE_goal = goalOf(alignment_, mapping_, state_.X_BT);
  if (report.target.status != TrackStatus::kTracked) return;
  seen_.last_target = exposed_at;
  target_motion_.add(exposed_at, {state_.X_BT, report.target.covariance});
  target_moved_on_ = true;
}

void ControlStage::endTeaching(const FrameReport& report) {
  teachings_ = report.teachings;
  target_motion_.forget();
  if (state_.phase != Phase::kTeaching) return;
  state_.phase = report.teaching_error ? Phase::kPrepare : Phase::kTaught;
  answer(report.teaching_error ? Answer::kTooFewMarkers : Answer::kAccepted);
}

void ControlStage::sample(const FrameReport& report, TimePoint exposed_at, const RigidTransform& X_BF) {
  const auto peaks = digest_.takePeaks();
  therapy::Sample sample;
  sample.time_s = sessionTime(exposed_at);
  sample.training = state_.phase == Phase::kTraining;
  sample.status = report.target.status;
  sample.matched = report.target.matched_count;
  sample.rms_m = report.target.rms_m;
  sample.sigma_t_m = shiftSigma(report.target);
  sample.sigma_r_rad = turnSigma(report.target);
  sample.X_CT = report.target.X_CT;
  sample.X_BT = state_.X_BT;
  sample.X_BE = X_BF * X_FE_;
  sample.X_BE_goal = state_.X_BE_goal;
  sample.q_rad = digest_.jointsAt(exposed_at);
  sample.v_rad_s = peaks.v_rad_s;
  sample.a_rad_s2 = peaks.a_rad_s2;
  sample.force_share = peaks.force_share;
  if (state_.servo.assist.gives_way) sample.help_level = state_.servo.assist.level;
  sample.help_adapts = sample.help_level && state_.help.adapts;
  recorder_.add(sample);
}

void ControlStage::obeyWishes() {
  while (const auto wish = wishes_.pop()) std::visit([this](const auto& wanted) { take(wanted); }, *wish);
}

void ControlStage::take(const Command& command) {
  const bool ends_lesson = command.action == Action::kFinishTeaching;
  // The lesson was faster: it ended by itself.
  if (ends_lesson && state_.phase == Phase::kTaught) return answer(Answer::kAccepted);
  const auto given = obey(command);
  // A lesson's answer comes when it has ended.
  if (!ends_lesson || given != Answer::kAccepted) answer(given);
}

void ControlStage::take(const control::Help& help) { answer(change(help)); }

Answer ControlStage::obey(const Command& command) {
  const auto next = therapy::after(state_.phase, command.action);
  if (!next) return Answer::kNotNow;
  switch (command.action) {
    case Action::kTeach:
      if (!tracking_.order(TrackingStage::Order::kBeginLesson)) return Answer::kQueueFull;
      break;
    case Action::kFinishTeaching:
      return tracking_.order(TrackingStage::Order::kEndLesson) ? Answer::kAccepted : Answer::kQueueFull;
    case Action::kAlign:
      if (const auto aligned = align(command.mapping); aligned != Answer::kAccepted) return aligned;
      break;
    case Action::kStart:
      if (const auto started = start(); started != Answer::kAccepted) return started;
      break;
    case Action::kPause:
      pause();
      break;
    case Action::kFinish:
      if (state_.phase == Phase::kTraining) pause();
      recordEvent("finished");
      recorder_.finish(stopLatched() ? "stop." + std::string(id(state_.servo.stop)) : "finished");
      break;
    case Action::kNewSession:
      if (!tracking_.order(TrackingStage::Order::kForget)) return Answer::kQueueFull;
      session_start_.reset();
      state_.has_goal = false;
      break;
  }
  state_.phase = *next;
  return Answer::kAccepted;
}

Answer ControlStage::align(therapy::Mapping mapping) {
  if (!calibration_holds_) return Answer::kNotCalibrated;
  if (!state_.target_fresh || !X_BE_at_target_) return Answer::kTargetUnseen;
  if (session_start_ && mapping != mapping_) return Answer::kNotNow;  // the record names one mapping
  mapping_ = mapping;
  alignment_ = {state_.X_BT, *X_BE_at_target_, midplane_normal_B_};
  state_.X_BE_goal = alignment_.X_BE;
  state_.has_goal = true;
  recordEvent("aligned");
  return Answer::kAccepted;
}

Answer ControlStage::start() {
  if (!calibration_holds_) return Answer::kNotCalibrated;
  if (stopLatched()) return Answer::kStopLatched;
  if (state_.servo.enabling_needed && state_.servo.enabling != control::EnablingPosition::kEnabled)
    return Answer::kNotEnabled;
  if (!state_.target_fresh) return Answer::kTargetUnseen;
  if (!session_start_) {
    session_start_ = now_;
    recorder_.begin(mapping_);
    static_cast<void>(digest_.takePeaks());  // what was before does not belong to the session
    recordHelp();
  }
  recordEvent("started");
  follower_.reset();
  desk_.withdraw();
  return Answer::kAccepted;
}

Answer ControlStage::change(const control::Help& help) {
  if (!state_.servo.assist.gives_way) return Answer::kHoldsStiffly;
  if (!(help.level >= 0.0 && help.level <= 1.0)) return Answer::kOutOfRange;
  state_.help = help;
  servo_.setHelp(help);
  recordHelp();
  return Answer::kAccepted;
}

// A motion without pieces is none: the servo loop brakes.
void ControlStage::pause() {
  state_.phase = Phase::kPaused;
  state_.trajectory = {};
  servo_.setTrajectory(state_.trajectory);
  recordEvent("paused");
}

void ControlStage::answer(Answer given) {
  state_.last_answer = given;
  ++state_.answers;
}

void ControlStage::follow() {
  const bool moved_on = std::exchange(target_moved_on_, false);
  const control::PlanAnswer* const answer = desk_.takeAnswer();
  if (state_.phase != Phase::kTraining || stopLatched()) return;
  if (desk_.waiting(now_) > kPlanningPatience) servo_.stop(control::StopReason::kPlannerSilent);
  if (answer && !state_.target_fresh) follower_.reset();  // asked again when the target is back
  if (!state_.target_fresh) return;
  const auto& servo = state_.servo;
  if (answer) obey(follower_.take(*answer, servo.commanded, servo.time));
  if (!moved_on || !target_motion_.isKnown()) return;
  const TimePoint begun = Clock::now();
  const auto kept = gaze_.keep(goalAt(servo.time + toClock(handover_ + arm_delay_.value())),
                               follower_.X_BE(servo.commanded.q_rad), sight());
  state_.gaze_kept = kept.shortened;
  obey(follower_.step(kept.goal, servo.commanded, servo.time));
  state_.follow_ms = 1e3 * secondsBetween(begun, Clock::now());
}

void ControlStage::obey(const control::FollowStep& step) {
  state_.follow = step.outcome;
  state_.contact = step.contact;
  if (step.question) {
    control::PlanQuestion question = *step.question;
    question.sight = sight();
    desk_.ask(question, now_);
  }
  if (!step.isNew()) return;
  state_.trajectory = step.trajectory;
  servo_.setTrajectory(step.trajectory);
}

control::Sight ControlStage::sight() const { return {state_.X_BT.translation(), target_radius_m_}; }

/// Where the target will be, so that the arm, which trails its commands, meets it.
control::ToolGoal ControlStage::goalAt(TimePoint time) const {
  control::ToolGoal goal;
  const auto at = [&](TimePoint moment) {
    return goalOf(alignment_, mapping_, target_motion_.at(moment).X_CT);
  };
  goal.X_BE = at(time);
  goal.X_BE_soon = at(time + toClock(goal.soon));
  return goal;
}

void ControlStage::tellServo() {
  seen_.following = state_.phase == Phase::kTraining;
  servo_.setTracking(seen_);
}

void ControlStage::publish() {
  state_.time = now_;
  state_.session_s = session_start_ ? sessionTime(now_) : 0.0;
  state_.lost_reports = lost_reports_.load(std::memory_order_relaxed);
  for_screen.put(state_);
}

bool ControlStage::stopLatched() const { return state_.servo.stop != control::StopReason::kNone; }

double ControlStage::sessionTime(TimePoint time) const { return secondsBetween(*session_start_, time); }

void ControlStage::recordEvent(std::string_view event) {
  if (session_start_) recorder_.addEvent(sessionTime(now_), event);
}

void ControlStage::recordHelp() {
  if (state_.servo.assist.gives_way) recordEvent(eventOf(state_.help));
}

}  // namespace mirrorarm::station
