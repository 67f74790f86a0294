#include "core/tracking/slip_watch.h"

#include <algorithm>

namespace mirrorarm::tracking {
namespace {

constexpr double kLeastJump_m = 0.0025;
constexpr double kSudden = 3.0;     // a jump is so many times the frame's before
constexpr int kFramesOfJump = 2;    // over which one jump may spread
constexpr int kFramesToLearn = 12;  // before anything is called a jump
constexpr double kShareThatStays = 0.5;
constexpr int kLeastFrames = 2;       // in which a jumped marker must be seen again
constexpr double kLongestWait = 5.0;  // of the slip time, for a marker that hides after its jump

}  // namespace

void SlipWatch::resize(std::size_t markers) {
  jumps_.resize(markers);
  off_before_.resize(markers, 0.0);
}

bool SlipWatch::isArmed() const { return frames_ >= kFramesToLearn; }

bool SlipWatch::takesJump(std::size_t marker, const Eigen::Vector3d& off, double sigma_m,
                          const Eigen::Vector3d& deviation, TimePoint now) {
  Jump& jump = jumps_[marker];
  const double distance = off.norm();
  const bool goes_on = jump.frames > 0 && jump.frames <= kFramesOfJump;
  const bool sudden = goes_on || distance > kSudden * off_before_[marker];
  off_before_[marker] = distance;
  const bool far = distance > std::max(sigmas_ * sigma_m, kLeastJump_m);
  if (jump.frames > 0) {
    ++jump.frames;
    jump.last_seen = now;
  }
  if (!isArmed() || !sudden || !far) return false;
  if (jump.frames == 0) jump = {Eigen::Vector3d::Zero(), deviation, now, now, 1};
  jump.offset += off;
  off_before_[marker] = 0.0;
  return true;
}

SlipWatch::Verdict SlipWatch::judge(std::size_t marker, const Eigen::Vector3d& deviation,
                                    TimePoint now) const {
  const Jump& jump = jumps_[marker];
  if (jump.frames == 0) return Verdict::kNone;
  if (jump.offset.norm() < kLeastJump_m) return Verdict::kUndone;
  const Seconds age = now - jump.since;
  if (age > kLongestWait * time_) return Verdict::kUndone;
  if (age < time_ || jump.frames < kLeastFrames || jump.last_seen != now) return Verdict::kNone;
  const Eigen::Vector3d left = jump.offset + deviation - jump.deviation;
  return left.dot(jump.offset) > kShareThatStays * jump.offset.squaredNorm() ? Verdict::kLasts
                                                                             : Verdict::kUndone;
}

}  // namespace mirrorarm::tracking
