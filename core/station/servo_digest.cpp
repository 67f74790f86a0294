#include "core/station/servo_digest.h"

#include <algorithm>

namespace mirrorarm::station {
namespace {

/// Encoder readings come every few milliseconds; a moment just past the newest is still answered.
constexpr Seconds kEndTolerance{0.010};

}  // namespace

ServoDigest::ServoDigest(const robot::ArmDescription& arm, Seconds period)
    : kinematics_(arm),
      period_s_(period.count()),
      cycles_(std::make_unique<RingLog<control::ServoState, kCycles>>()) {
  peaks_.v_rad_s = peaks_.a_rad_s2 = robot::Joints::Zero(arm.jointCount());
}

void ServoDigest::add(const control::ServoState& state) {
  newest_ = state;
  cycles_->add(state);
  if (state.measured.q_rad.size() == kinematics_.jointCount())
    flange_.add(state.measured.measured_at, kinematics_.flange(state.measured.q_rad));
  if (state.assist.force.known)
    peaks_.force_share = std::max(peaks_.force_share.value_or(0.0), state.assist.force.limit_share);
  if (state.sent.v_rad_s.size() == peaks_.v_rad_s.size()) notePeaks(state.sent.v_rad_s);
  last_sent_v_rad_s_ = state.sent.v_rad_s;
}

void ServoDigest::notePeaks(const robot::Joints& v_rad_s) {
  peaks_.v_rad_s = peaks_.v_rad_s.cwiseMax(v_rad_s.cwiseAbs());
  if (last_sent_v_rad_s_.size() != v_rad_s.size()) return;
  peaks_.a_rad_s2 = peaks_.a_rad_s2.cwiseMax((v_rad_s - last_sent_v_rad_s_).cwiseAbs() / period_s_);
}

std::optional<RigidTransform> ServoDigest::flangeAt(TimePoint time) const {
  return flange_.at(time, kEndTolerance);
}

robot::Joints ServoDigest::jointsAt(TimePoint time) const {
  std::size_t i = cycles_->size();
  while (i > 1 && (*cycles_)[i - 1].measured.measured_at > time) --i;
  return i == 0 ? robot::Joints() : (*cycles_)[i - 1].measured.q_rad;
}

ServoDigest::Peaks ServoDigest::takePeaks() {
  const Peaks taken = peaks_;
  peaks_.v_rad_s.setZero();
  peaks_.a_rad_s2.setZero();
  peaks_.force_share.reset();
  return taken;
}

std::shared_ptr<const std::vector<control::ServoState>> ServoDigest::blackBox() const {
  auto states = std::make_shared<std::vector<control::ServoState>>();
  states->reserve(cycles_->size());
  for (std::size_t i = 0; i < cycles_->size(); ++i) states->push_back((*cycles_)[i]);
  return states;
}

}  // namespace mirrorarm::station
