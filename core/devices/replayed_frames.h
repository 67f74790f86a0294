#pragma once

#include <optional>

#include "core/camera/frame_source.h"
#include "core/common/time_source.h"
#include "core/devices/recording.h"

namespace mirrorarm::devices {

/// A stereo camera that shows a recording again.
class ReplayedFrames final : public camera::FrameSource {
 public:
  enum class Pace {
    kAsAsked,   ///< every call gives the next frame at once, with the times of the file
    kRecorded,  ///< frames come with the pauses of the recording, their times moved to the running clock
  };

  /// `time` outlives the source; kRecorded starts with the first call of next().
  ReplayedFrames(Recording recording, Pace pace, const TimeSource& time);

  /// kEnded after the last frame; kFailed, for good, at an image that cannot be read (see failure()).
  [[nodiscard]] Expected<camera::StereoFrame, camera::NoFrame> next(Seconds timeout) override;

  /// From the median interval of the recording; 0 for a single frame.
  [[nodiscard]] double rate_hz() const override { return rate_hz_; }

  /// Why next() gave kFailed.
  [[nodiscard]] const std::optional<FileError>& failure() const { return failure_; }

 private:
  Recording recording_;
  Pace pace_;
  const TimeSource& time_;
  double rate_hz_ = 0.0;
  std::size_t next_ = 0;
  std::optional<Clock::duration> shift_;  ///< from the file's times to the running clock
  std::optional<FileError> failure_;
};

}  // namespace mirrorarm::devices
