#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/common/time.h"

namespace mirrorarm::tracking {

/// Tells a slip of the sleeve from a motion of the skin: a marker that leaves its expected place within a
/// frame or two, far beyond what was learnt, and stays away. Until that is certain its jump is an offset of
/// its own beside the deviation, so that neither the modes nor the frame follow it.
class SlipWatch {
 public:
  SlipWatch(double sigmas, Seconds time) : sigmas_(sigmas), time_(time) {}

  void resize(std::size_t markers);
  /// True when a marker that was seen `off` its expected place [m] has jumped, `sigma_m` being expected; the
  /// jump is then kept as its offset. `deviation` is the marker's, without offset. Every seen marker of every
  /// frame is to be asked for; nothing is a jump before enough frames have been learnt.
  bool takesJump(std::size_t marker, const Eigen::Vector3d& off, double sigma_m,
                 const Eigen::Vector3d& deviation, TimePoint now);
  void endFrame() { ++frames_; }
  /// True when enough frames have been learnt to tell a slip from the skin's motion.
  [[nodiscard]] bool isArmed() const;

  enum class Verdict : std::uint8_t { kNone, kLasts, kUndone };
  /// What has become of a marker's jump; its deviation now. After kLasts and kUndone the offset is to be
  /// taken over by the caller, and is forgotten here.
  [[nodiscard]] Verdict judge(std::size_t marker, const Eigen::Vector3d& deviation, TimePoint now) const;
  /// Its offset [m]; zero while it has none.
  [[nodiscard]] const Eigen::Vector3d& offset(std::size_t marker) const { return jumps_[marker].offset; }
  void forget(std::size_t marker) { jumps_[marker] = {}; }

 private:
  struct Jump {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();  ///< when it happened
    TimePoint since{}, last_seen{};
    int frames = 0;  ///< in which the marker was seen since; 0 for no jump
  };

  double sigmas_;
  Seconds time_;
  int frames_ = 0;
  std::vector<Jump> jumps_;
  std::vector<double> off_before_;
};

}  // namespace mirrorarm::tracking
