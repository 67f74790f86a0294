#include "core/station/guidance.h"

#include "core/common/log.h"

namespace mirrorarm::station {
namespace {

using State = ViewDrive::State;

/// Enough for the robot to calm down and for a few frames.
constexpr Seconds kPatience{2.0};
constexpr int kMostMisses = 5;
/// A path is clear from where it was planned from.
constexpr double kSamePlace_rad = 0.005;

bool isAt(const robot::Joints& q, const robot::Joints& there) {
  return q.size() == there.size() && (q - there).cwiseAbs().maxCoeff() < kSamePlace_rad;
}

}  // namespace

Guidance::Guidance(CalibrationJobs& jobs, control::ServoLoop* servo, std::shared_ptr<const PlannedArm> arm,
                   const CalibrationSettings& settings)
    : jobs_(jobs), arm_(std::move(arm)), clock_motion_(settings.clock_motion) {
  if (servo != nullptr) drive_.emplace(*servo, arm_->limits);
}

void Guidance::forget() {
  stopDriving();
  asked_ = false;
  answered_.reset();
  proposal_.reset();
  avoided_CM_.clear();
}

void Guidance::startDriving(const control::ServoState& state) {
  driving_ = true;
  misses_ = 0;
  home_ = state.commanded.q_rad;
  path_.clear();
  answered_.reset();
}

void Guidance::stopDriving() {
  driving_ = false;
  path_.clear();
  if (drive_) drive_->halt();
}

std::optional<TimePoint> Guidance::waitsSince() const {
  if (!driving_ || drive_->state() != State::kThere) return std::nullopt;
  return drive_->thereSince();
}

void Guidance::step(const Situation& situation) {
  if (driving_ && situation.servo.stop != control::StopReason::kNone) stopDriving();
  if (situation.views.size() >= situation.wanted && situation.job != CalibrationJob::kClock) {
    proposal_.reset();
    return stopDriving();
  }
  if (driving_) advance(situation);
  if (wantsProposal(situation)) ask(situation);
}

void Guidance::advance(const Situation& situation) {
  switch (drive_->update(situation.servo, situation.now)) {
    case State::kIdle:
      if (!path_.empty()) depart(situation);
      break;
    case State::kUnderWay:
      break;
    case State::kThere:
      waitForView(situation);
      break;
    case State::kStuck:
      giveUp("the robot did not arrive where it was sent");
      break;
  }
}

void Guidance::waitForView(const Situation& situation) {
  if (situation.job == CalibrationJob::kClock) return stopDriving();
  if (situation.views.version() != departed_) {
    misses_ = 0;
    return drive_->finish();
  }
  if (situation.now - drive_->thereSince() < kPatience) return;
  if (++misses_ > kMostMisses) return giveUp("the board is not seen where it should be");
  if (proposal_) avoided_CM_.push_back(proposal_->X_CM);
  answered_.reset();
  drive_->finish();
}

void Guidance::depart(const Situation& situation) {
  const bool is_clock = situation.job == CalibrationJob::kClock;
  drive_->go(path_, situation.servo, is_clock ? clock_motion_ : Seconds(0.0));
  path_.clear();
  departed_ = situation.views.version();
}

bool Guidance::wantsProposal(const Situation& situation) const {
  if (asked_ || situation.size.width_px == 0 || answered_ == situation.views.version()) return false;
  if (driving_) return drive_->state() == State::kIdle && situation.X_BM.has_value();
  return situation.job != CalibrationJob::kClock && (!arm_ || situation.X_BM);
}

void Guidance::ask(const Situation& situation) {
  ViewQuestion question{situation.job,  situation.board,        situation.rig, situation.model,
                        situation.size, situation.views.list(), avoided_CM_,   std::nullopt};
  const auto& at = asked_at_ = situation.servo.commanded.q_rad;
  if (arm_ && at.size() == arm_->arm.jointCount())
    question.robot = {arm_, *situation.X_BM, situation.X_FC, at, driving_ ? home_ : at};
  jobs_.propose(std::move(question), situation.views.version());
  asked_ = true;
}

void Guidance::take(const ViewProposal& proposal, std::uint64_t version, const Situation& situation) {
  asked_ = false;
  if (version != situation.views.version()) return;  // asked again at once
  answered_ = version;
  proposal_ = proposal.wish;
  if (!driving_) return;
  if (!isAt(situation.servo.commanded.q_rad, asked_at_)) return answered_.reset();  // asked again
  path_ = proposal.path;
  if (path_.empty()) giveUp("no view, or no clear way to one, is in reach");
}

void Guidance::giveUp(std::string_view why) {
  log(LogLevel::kWarning, "calibration: " + std::string(why));
  stopDriving();
}

}  // namespace mirrorarm::station
