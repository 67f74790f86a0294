#include "core/station/view_drive.h"

namespace mirrorarm::station {
namespace {

constexpr double kThere_rad = 0.005;
constexpr Seconds kPatience{3.0};

}  // namespace

void ViewDrive::go(const std::vector<robot::Joints>& path, const control::ServoState& state,
                   Seconds at_least) {
  trajectory_ = robot::Trajectory::through(state.commanded, path, state.time, limits_, at_least);
  servo_.setTrajectory(trajectory_);
  state_ = State::kUnderWay;
}

// A motion without pieces is none: the servo loop brakes.
void ViewDrive::halt() {
  if (state_ == State::kUnderWay || state_ == State::kStuck) servo_.setTrajectory({});
  state_ = State::kIdle;
}

ViewDrive::State ViewDrive::update(const control::ServoState& state, TimePoint now) {
  if (state_ != State::kUnderWay || now < trajectory_.end()) return state_;
  const bool there = state.at_rest && state.measured.q_rad.size() == trajectory_.goal().size() &&
                     (state.measured.q_rad - trajectory_.goal()).cwiseAbs().maxCoeff() < kThere_rad;
  if (there) {
    state_ = State::kThere;
    there_since_ = now;
  } else if (now > trajectory_.end() + toClock(kPatience)) {
    state_ = State::kStuck;
  }
  return state_;
}

}  // namespace mirrorarm::station
