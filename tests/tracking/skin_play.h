#pragma once

#include <cmath>
#include <vector>

#include "tests/tracking/simulated_skin.h"
#include "tests/tracking/skin_loop.h"

namespace mirrorarm::tracking::test {

/// How much the bone seems to move in a frame that should stand still in it: root mean square, about the mean
/// over time, of points of the bone where the markers are [m].
class FrameWander {
 public:
  void add(const RigidTransform& X_CT, const RigidTransform& X_CB) {
    const RigidTransform X_TB = X_CT.inverse() * X_CB;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d p_B(corner & 1 ? 0.075 : -0.075, corner & 2 ? 0.04 : -0.04, corner & 4 ? 0.04 : -0.04);
      const Vector3d p_T = X_TB * p_B;
      sums_[corner] += p_T;
      squares_ += p_T.squaredNorm();
    }
    ++frames_;
  }
  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] double rms_m() const {
    double square = squares_ / 8.0 / frames_;
    for (const Vector3d& sum : sums_) square -= (sum / frames_).squaredNorm() / 8.0;
    return std::sqrt(std::max(0.0, square));
  }

 private:
  Vector3d sums_[8] = {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                       Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  double squares_ = 0.0;
  int frames_ = 0;
};

/// Which markers are behind something: a window of `count` neighbours along the arm that moves on by one each
/// half second, from `from_s` on.
inline std::vector<char> hiddenAt(double t, int count, double from_s) {
  std::vector<char> hidden(SimulatedSkin::kMarkers, 0);
  if (t < from_s) return hidden;
  const int first = static_cast<int>(2.0 * (t - from_s));
  for (int i = 0; i < count; ++i) hidden[static_cast<std::size_t>((first + i) % SimulatedSkin::kMarkers)] = 1;
  return hidden;
}

struct SkinTally {
  int frames = 0, tracked = 0;
  int shown = 0, found = 0, wrong = 0;  ///< markers that were not hidden, that were found, of these wrongly
  int slips = 0, losses = 0, finds = 0, additions = 0;

  void add(const SkinFrame& frame, bool is_tracked, const SkinLoop& loop) {
    ++frames;
    slips += loop.event == SkinEvent::kSlipped;
    losses += loop.event == SkinEvent::kMarkerLost;
    finds += loop.event == SkinEvent::kMarkerFound;
    additions += loop.event == SkinEvent::kMarkerAdded;
    for (const int marker : frame.marker_of_point) shown += marker >= 0 ? 1 : 0;
    if (!is_tracked) return;
    ++tracked;
    for (std::size_t i = 0; i < SimulatedSkin::kMarkers; ++i) {
      const int point = loop.fit->point_of_marker[i];
      if (point < 0) continue;
      ++found;
      if (frame.marker_of_point[static_cast<std::size_t>(point)] != static_cast<int>(i)) ++wrong;
    }
  }
};

inline TimePoint timeOf(const SkinFrame& frame) { return TimePoint(toClock(Seconds(1.0 + frame.time_s))); }

inline SkinLoop loopAbout(const SimulatedSkin& skin, const SkinSettings& settings = {}) {
  return {skin.taughtAt(0.0), SimulatedSkin::bone(-2.0 * SimulatedSkin::kFrame_s),
          SimulatedSkin::bone(-SimulatedSkin::kFrame_s), settings};
}

}  // namespace mirrorarm::tracking::test
