#include "ui/model/motion_trace.h"

#include <algorithm>
#include <limits>

namespace mirrorarm::ui {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

bool isAligned(therapy::Phase phase) {
  return phase == therapy::Phase::kAligned || phase == therapy::Phase::kTraining ||
         phase == therapy::Phase::kPaused;
}

}  // namespace

MotionTrace::MotionTrace(const RigidTransform& X_FE, double window_s) : X_FE_(X_FE), window_s_(window_s) {}

void MotionTrace::add(const station::Snapshot& snapshot) {
  const auto& control = snapshot.control;
  if (control.phase == therapy::Phase::kTaught) clear();
  if (!isAligned(control.phase)) return;
  const double now_s = secondsBetween(TimePoint{}, control.time);
  if (!at_s_.isEmpty() && now_s <= at_s_.last()) return;
  const Eigen::Vector3d healthy_B = control.X_BT.translation();
  const RigidTransform X_BE = control.X_BF * X_FE_;
  if (!start_ && !control.target_fresh) return;
  if (!start_) start_ = Start{healthy_B, X_BE.translation()};
  at_s_ << now_s;
  healthy_mm_ << (control.target_fresh ? (healthy_B - start_->healthy_B).norm() * 1e3 : kGap);
  impaired_mm_ << (X_BE.translation() - start_->impaired_B).norm() * 1e3;
  const bool has_goal = control.has_goal && control.target_fresh;
  to_goal_mm_ << (has_goal ? (X_BE.translation() - control.X_BE_goal.translation()).norm() * 1e3 : kGap);
  forgetOld();
}

void MotionTrace::clear() {
  start_.reset();
  for (auto* column : {&at_s_, &shown_s_, &healthy_mm_, &impaired_mm_, &to_goal_mm_}) column->clear();
}

void MotionTrace::forgetOld() {
  const double newest = at_s_.last();
  const auto kept = std::lower_bound(at_s_.cbegin(), at_s_.cend(), newest - window_s_);
  const int old = static_cast<int>(kept - at_s_.cbegin());
  for (auto* column : {&at_s_, &healthy_mm_, &impaired_mm_, &to_goal_mm_}) column->remove(0, old);
  shown_s_.resize(at_s_.size());
  std::transform(at_s_.cbegin(), at_s_.cend(), shown_s_.begin(), [newest](double t) { return t - newest; });
}

}  // namespace mirrorarm::ui
