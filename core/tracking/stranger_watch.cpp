#include "core/tracking/stranger_watch.h"

#include <algorithm>
#include <limits>

namespace mirrorarm::tracking {
namespace {

constexpr int kMostMissed = 3;           // frames in a row after which it is forgotten
constexpr double kLeastPath_m = 0.02;    // root mean square about its mean, before the camera
constexpr double kLeastContrast = 20.0;  // of scatter before the camera to scatter on the body
constexpr double kRigid_m = 0.002;
constexpr Seconds kLongestProof{10.0};

void add(Stranger& stranger, const Eigen::Vector3d& p_T, const Eigen::Vector3d& p_C, TimePoint time) {
  ++stranger.frames;
  stranger.frames_missed = 0;
  stranger.last_seen = time;
  stranger.last_T = p_T;
  const Eigen::Vector3d off_T = p_T - stranger.mean_T, off_C = p_C - stranger.mean_C;
  stranger.mean_T += off_T / stranger.frames;
  stranger.mean_C += off_C / stranger.frames;
  stranger.scatter_T_m2 += off_T.dot(p_T - stranger.mean_T);
  stranger.scatter_C_m2 += off_C.dot(p_C - stranger.mean_C);
}

}  // namespace

void StrangerWatch::begin(TimePoint time, double gate_m) {
  time_ = time;
  gate_m_ = gate_m;
  for (Stranger& stranger : strangers_) ++stranger.frames_missed;
}

void StrangerWatch::seen(const Eigen::Vector3d& p_T, const Eigen::Vector3d& p_C) {
  Stranger* nearest = nullptr;
  double least = gate_m_ * gate_m_;
  for (Stranger& stranger : strangers_) {
    if (!stranger.alive || stranger.frames_missed == 0) continue;
    const double square = (stranger.last_T - p_T).squaredNorm();
    if (square >= least) continue;
    least = square;
    nearest = &stranger;
  }
  if (nearest == nullptr) {
    const auto free =
        std::find_if(strangers_.begin(), strangers_.end(), [](const auto& s) { return !s.alive; });
    if (free == strangers_.end()) return;
    *free = {};
    free->alive = true;
    free->first_seen = time_;
    nearest = &*free;
  }
  add(*nearest, p_T, p_C, time_);
}

void StrangerWatch::end() {
  for (Stranger& stranger : strangers_)
    if (stranger.frames_missed > kMostMissed || time_ - stranger.first_seen > kLongestProof) stranger = {};
}

bool StrangerWatch::movesWithBody(const Stranger& stranger, Seconds time, double skin_variance_m2) {
  const Seconds life = stranger.last_seen - stranger.first_seen;
  if (!stranger.alive || life < time || stranger.frames < 4) return false;
  const double on_body = stranger.scatter_T_m2 / stranger.frames;
  const double before_camera = stranger.scatter_C_m2 / stranger.frames;
  const double allowed = kRigid_m * kRigid_m + 6.0 * skin_variance_m2;
  return before_camera > kLeastPath_m * kLeastPath_m && before_camera > kLeastContrast * on_body &&
         on_body < allowed;
}

}  // namespace mirrorarm::tracking
