#pragma once

#include "core/camera/stereo_frame.h"
#include "core/common/expected.h"

namespace mirrorarm::camera {

/// Why no frame came.
enum class NoFrame {
  kTimeout,  ///< nothing within the time asked; ask again
  kEnded,    ///< a recording is over
  kFailed,   ///< the device is gone; it will not come back by waiting
};

/// A stereo camera: real, simulated or replayed. Used by one thread, the acquisition thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Waits up to `timeout` for the next frame.
  [[nodiscard]] virtual Expected<StereoFrame, NoFrame> next(Seconds timeout) = 0;

  /// The frame rate that the source is set to [Hz], for watchdogs.
  [[nodiscard]] virtual double rate_hz() const = 0;
};

}  // namespace mirrorarm::camera
