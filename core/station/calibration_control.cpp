#include "core/station/calibration_control.h"

#include <algorithm>

#include "core/common/log.h"

namespace mirrorarm::station {
namespace {

using Action = CalibrationAction;
using Answer = CalibrationAnswer;
using Phase = CalibrationPhase;
using Verdict = calibration::CaptureVerdict;

calibration::InForce inForce(const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  auto in_force = calibration::CalibrationFolder(folder).read();
  if (in_force) return std::move(*in_force);
  log(LogLevel::kWarning, "calibration: " + describe(in_force.error()));
  return {};
}

bool isStill(Verdict verdict) { return verdict == Verdict::kNotNew || verdict == Verdict::kTake; }

bool isBoard(const calibration::Board& board) {
  return board.columns > 1 && board.rows > 1 && board.spacing_m > 0.0;
}

}  // namespace

CalibrationControl::CalibrationControl(const Equipment& equipment, const CalibrationSettings& settings,
                                       control::ServoLoop* servo, std::shared_ptr<const PlannedArm> arm,
                                       BoardStage& boards, JobRunner& runner)
    : settings_(settings),
      equipment_(equipment),
      servo_(servo),
      boards_(boards),
      jobs_(settings, runner),
      guidance_(jobs_, servo, std::move(arm), settings),
      known_(knownFrom(equipment, inForce(settings.folder))) {
  if (servo_ != nullptr) digest_.emplace(equipment.arm, equipment.robot->period());
  state_.views = views_.list();
}

void CalibrationControl::step(TimePoint now) {
  now_ = now;
  drainServo();
  takeReports();
  takeAnswers();
  obeyCommands();
  guide();
  tellServo();
  publish();
}

void CalibrationControl::end() {
  drainServo();
  if (const auto reason = stops_.unkept()) jobs_.keepBlackBox(*digest_->blackBox(), *reason);
}

void CalibrationControl::drainServo() {
  if (servo_ == nullptr) return;
  const bool streams = state_.phase == Phase::kCapturing && state_.job == CalibrationJob::kClock;
  while (const auto cycle = servo_->takeState()) {
    digest_->add(*cycle);
    noteStop(stops_.update(*cycle));
    const auto measured_at = cycle->measured.measured_at;
    if (!streams) continue;
    if (const auto X_BF = digest_->flangeAt(measured_at)) streams_.addRobot(measured_at, *X_BF);
  }
  if (const auto* newest = digest_->newest()) state_.servo = *newest;
}

void CalibrationControl::noteStop(const StopNews& news) {
  if (news.box_due) jobs_.keepBlackBox(*digest_->blackBox(), news.reason);
  if (!news.begun) return;
  log(LogLevel::kWarning, "stop." + std::string(id(news.reason)));
  guidance_.stopDriving();
}

void CalibrationControl::takeReports() {
  while (const auto report = reports_.pop()) takeReport(*report);
}

void CalibrationControl::takeReport(const BoardReport& report) {
  const auto& frame = *(state_.frame = report.frame);
  X_BF_.reset();
  if (digest_) X_BF_ = digest_->flangeAt(frame.frame.exposed_at + toClock(known_.clock_offset));
  if (state_.phase != Phase::kCapturing || report.watch != watch_) return;
  if (state_.job == CalibrationJob::kClock && frame.X_CM)
    streams_.addCamera(frame.frame.exposed_at, *frame.X_CM);
  if (frame.X_CM && X_BF_ && robotRests() && isStill(frame.verdict))
    X_BM_ = *X_BF_ * known_.X_FC * *frame.X_CM;
  takeByItself(report);
}

void CalibrationControl::takeByItself(const BoardReport& report) {
  if (state_.job == CalibrationJob::kClock || views_.size() >= viewsWanted()) return;
  const auto& frame = *report.frame;
  if (guidance_.isDriving()) {
    const auto since = guidance_.waitsSince();
    const auto exposed_at = frame.frame.exposed_at + toClock(known_.clock_offset);
    if (since && exposed_at > *since && isStill(frame.verdict)) takeView();
  } else if (state_.automatic && frame.verdict == Verdict::kTake && hasAllFor(state_.job)) {
    takeView();
  }
}

void CalibrationControl::takeView() {
  const auto& frame = *state_.frame;
  views_.add({{}, frame.view, frame.X_CM, X_BF_, {}, {}, false});
  jobs_.keepImages(views_.list()->back().name, frame.frame);
  updateWatch();
}

bool CalibrationControl::hasAllFor(CalibrationJob job) const {
  return robotRests() && (job != CalibrationJob::kHandEye || (X_BF_ && state_.frame->X_CM));
}

void CalibrationControl::takeAnswers() {
  for (const auto& answer : jobs_.takeAnswers()) {
    if (const auto* proposal = std::get_if<ViewProposal>(&answer.value)) take(*proposal, answer.version);
    if (const auto* solved = std::get_if<SolveAnswer>(&answer.value)) take(*solved);
    if (const auto* written = std::get_if<WriteAnswer>(&answer.value)) take(*written);
  }
}

void CalibrationControl::take(const ViewProposal& proposal, std::uint64_t version) {
  guidance_.take(proposal, version, situation());
  if (!proposal.rig) return;
  rig_ = proposal.rig;
  updateWatch();
}

void CalibrationControl::take(const SolveAnswer& solved) {
  if (state_.phase != Phase::kSolving) return;
  state_.phase = solved.outcome ? Phase::kSolved : Phase::kRefused;
  state_.outcome = solved.outcome;
  state_.refusal = solved.refusal;
  pairs_ = solved.pairs;
  if (!solved.views.empty()) views_.setFindings(solved.views);
}

void CalibrationControl::take(const WriteAnswer& written) {
  writing_ = false;
  if (written.record.empty()) {
    log(LogLevel::kError, "calibration: " + written.refusal);
    return answer(Answer::kNotWritten);
  }
  known_ = knownFrom(equipment_, written.in_force);
  state_.record = written.record;
  state_.phase = Phase::kAccepted;
  answer(Answer::kAccepted);
}

// The answer to kAccept comes when the record is written.
void CalibrationControl::obeyCommands() {
  while (const auto command = commands_.pop()) {
    const auto given = writing_ ? Answer::kNotNow : obey(*command);
    if (!writing_ || given != Answer::kAccepted) answer(given);
  }
}

CalibrationAnswer CalibrationControl::obey(const CalibrationCommand& command) {
  const bool capturing = state_.phase == Phase::kCapturing;
  switch (command.action) {
    case Action::kBegin:
      return begin(command);
    case Action::kCapture:
      return capturing && state_.job != CalibrationJob::kClock ? capture() : Answer::kNotNow;
    case Action::kSetAutomatic:
      state_.automatic = command.on;
      return Answer::kAccepted;
    case Action::kSetDriving:
      return capturing ? setDriving(command.on) : Answer::kNotNow;
    case Action::kRemoveView:
    case Action::kUndoRemove:
      return changeViews(command);
    case Action::kSolve:
      return capturing ? solve() : Answer::kNotNow;
    case Action::kAccept:
      return state_.phase == Phase::kSolved ? accept() : Answer::kNotNow;
    case Action::kDiscard:
      if (state_.phase != Phase::kSolved && state_.phase != Phase::kRefused) return Answer::kNotNow;
      state_.phase = Phase::kCapturing;
      state_.outcome.reset();
      return Answer::kAccepted;
    case Action::kCancel:
      cancel();
      return Answer::kAccepted;
  }
  return Answer::kNotNow;
}

CalibrationAnswer CalibrationControl::begin(const CalibrationCommand& command) {
  const bool needs_robot = command.job == CalibrationJob::kHandEye || command.job == CalibrationJob::kClock;
  if (!isBoard(command.board)) return Answer::kNoBoard;
  if (needs_robot && servo_ == nullptr) return Answer::kNoRobot;
  if (command.job != CalibrationJob::kStereo && !known_.rig_in_force) return Answer::kNoCalibration;
  cancel();
  state_.phase = Phase::kCapturing;
  state_.job = command.job;
  state_.board = command.board;
  state_.automatic = true;
  model_ = command.model;
  rig_ = known_.rig;
  updateWatch();
  return Answer::kAccepted;
}

CalibrationAnswer CalibrationControl::capture() {
  if (!state_.frame) return Answer::kNoBoard;
  const auto verdict = state_.frame->verdict;
  if (verdict == Verdict::kNoBoard || verdict == Verdict::kTooFew) return Answer::kNoBoard;
  if (verdict == Verdict::kMoving || !robotRests()) return Answer::kMoving;
  if (!hasAllFor(state_.job)) return Answer::kNoRobot;
  takeView();
  return Answer::kAccepted;
}

CalibrationAnswer CalibrationControl::setDriving(bool on) {
  if (!on) {
    guidance_.stopDriving();
    return Answer::kAccepted;
  }
  if (guidance_.isDriving()) return Answer::kAccepted;
  if (state_.servo.stop != control::StopReason::kNone) return Answer::kStopLatched;
  if (servo_ == nullptr || state_.servo.measured.q_rad.size() == 0 || !state_.servo.at_rest)
    return Answer::kNoRobot;
  if (!isEnabled()) return Answer::kNotEnabled;
  const bool needs_hand_eye = state_.job == CalibrationJob::kDrift;
  if (!rig_ || (needs_hand_eye && !known_.hand_eye_in_force)) return Answer::kNoCalibration;
  if (!X_BM_) return Answer::kNoBoard;
  if (state_.job == CalibrationJob::kClock) streams_.clear();
  if (state_.job == CalibrationJob::kDrift) {
    while (views_.remove(0)) continue;  // the grid is measured as a whole
    updateWatch();
  }
  guidance_.startDriving(state_.servo);
  return Answer::kAccepted;
}

// An outcome of other views than those that remain is none.
CalibrationAnswer CalibrationControl::changeViews(const CalibrationCommand& command) {
  const bool allowed =
      state_.phase == Phase::kCapturing || state_.phase == Phase::kSolved || state_.phase == Phase::kRefused;
  if (!allowed) return Answer::kNotNow;
  const bool changed =
      command.action == Action::kRemoveView ? views_.remove(command.view) : views_.undoRemove();
  if (!changed) return Answer::kNotNow;
  state_.phase = Phase::kCapturing;
  state_.outcome.reset();
  updateWatch();
  return Answer::kAccepted;
}

CalibrationAnswer CalibrationControl::solve() {
  if (!state_.frame) return Answer::kNoBoard;
  guidance_.stopDriving();
  jobs_.solve({state_.job, state_.board, model_, imageSize(), known_, views_.list(), streams_.robot(),
               streams_.camera()},
              views_.version());
  state_.phase = Phase::kSolving;
  return Answer::kAccepted;
}

CalibrationAnswer CalibrationControl::accept() {
  jobs_.accept(state_.outcome, views_.removedNames(), pairs_);
  writing_ = true;
  return Answer::kAccepted;
}

void CalibrationControl::cancel() {
  jobs_.begin();
  guidance_.forget();
  views_.clear();
  streams_.clear();
  X_BM_.reset();
  state_.phase = Phase::kIdle;
  state_.outcome.reset();
  state_.refusal.clear();
  state_.record.clear();
  state_.board = {};
  updateWatch();
}

void CalibrationControl::answer(CalibrationAnswer given) {
  state_.last_answer = given;
  ++state_.answers;
}

Guidance::Situation CalibrationControl::situation() const {
  const auto model = model_ ? *model_
                     : rig_ ? rig_->left.intrinsics().model
                            : camera::LensModel::kBrownConrady;
  return {now_,        state_.job, state_.board,  model,        imageSize(), rig_,
          known_.X_FC, views_,     viewsWanted(), state_.servo, X_BM_};
}

void CalibrationControl::guide() {
  if (state_.phase == Phase::kCapturing) guidance_.step(situation());
}

void CalibrationControl::updateWatch() {
  auto watch = std::make_shared<BoardWatch>();
  watch->version = ++watch_;
  watch->job = jobs_.job();
  if (isBoard(state_.board)) watch->board = state_.board;
  watch->rig = rig_;
  watch->taken = boardViewsOf(*views_.list());
  boards_.watch(std::move(watch));
  updateCoverage();
}

void CalibrationControl::updateCoverage() {
  std::vector<RigidTransform> X_CM;
  for (const auto& taken : *views_.list())
    if (taken.X_CM) X_CM.push_back(*taken.X_CM);
  if (X_CM.size() != views_.size()) X_CM.clear();
  state_.coverage = calibration::coverageOf(boardViewsOf(*views_.list()), X_CM, imageSize(), {},
                                            calibration::boardMiddle(state_.board));
}

calibration::ImageSize CalibrationControl::imageSize() const {
  if (!state_.frame) return {};
  return {state_.frame->frame.left.width(), state_.frame->frame.left.height()};
}

std::size_t CalibrationControl::viewsWanted() const {
  switch (state_.job) {
    case CalibrationJob::kStereo:
      return settings_.stereo_views;
    case CalibrationJob::kHandEye:
      return settings_.hand_eye_stations;
    case CalibrationJob::kClock:
      return 0;
    case CalibrationJob::kDrift:
      return guidance_.isDriving() ? static_cast<std::size_t>(settings_.drift_stations.prod()) : 1;
  }
  return 0;
}

double CalibrationControl::progress() const {
  switch (state_.phase) {
    case Phase::kIdle:
      return 0.0;
    case Phase::kCapturing:
      return std::min(1.0, state_.job == CalibrationJob::kClock
                               ? streams_.duration() / settings_.clock_motion
                               : static_cast<double>(views_.size()) / static_cast<double>(viewsWanted()));
    case Phase::kSolving:
    case Phase::kSolved:
    case Phase::kRefused:
    case Phase::kAccepted:
      return jobs_.progress();
  }
  return 0.0;
}

bool CalibrationControl::isEnabled() const {
  return !settings_.supervisor.enabling_needed ||
         state_.servo.enabling == control::EnablingPosition::kEnabled;
}

// One that never answered carries nothing.
bool CalibrationControl::robotRests() const {
  return servo_ == nullptr || state_.servo.measured.q_rad.size() == 0 || state_.servo.at_rest;
}

// There is no target that could be lost. But the robot goes by itself: nobody sees where when the cameras are
// gone, and nobody ends it when this thread hangs.
void CalibrationControl::tellServo() {
  if (servo_ == nullptr) return;
  const TimePoint frame_at = newest_frame_.load(std::memory_order_relaxed) + toClock(known_.clock_offset);
  servo_->setTracking({frame_at, now_, guidance_.isDriving()});
}

void CalibrationControl::publish() {
  state_.views = views_.list();
  state_.views_wanted = viewsWanted();
  state_.proposal = guidance_.proposal();
  state_.driving = guidance_.isDriving();
  state_.can_undo = views_.canUndo();
  state_.progress = progress();
  for_screen.put(std::make_shared<const CalibrationSnapshot>(state_));
}

}  // namespace mirrorarm::station
