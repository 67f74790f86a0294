#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

#include "core/camera/frame_source.h"
#include "core/common/time_source.h"
#include "core/simulation/stereo_renderer.h"

namespace mirrorarm::simulation {

struct CameraTiming {
  double rate_hz = 24.0;
  Seconds exposure{0.0015};
  Seconds transfer{0.020};   ///< from the end of the exposure until the frame can be had
  bool waits = true;         ///< next() waits for a frame; false: it only looks, for sessions in lockstep
  Seconds clock_ahead{0.0};  ///< the times in the frames are later than the truth by that
};

/// A stereo camera that looks at a world of patches. The trigger runs freely from the moment it is made:
/// whoever asks late gets the newest frame, and the numbering shows what was missed.
class SimulatedCameras final : public camera::FrameSource {
 public:
  /// Fills in the patches at a time, in the left camera's frame. Called from the thread that calls next(),
  /// for times a little in the past.
  using World = std::function<void(TimePoint, StereoRenderer::Instant&)>;

  /// `time` outlives the cameras.
  SimulatedCameras(const camera::StereoRig& rig, const LightSettings& light, const SensorSettings& sensor,
                   const CameraTiming& timing, World world, const TimeSource& time, std::uint64_t seed);

  /// kTimeout when no frame is due in time, or for ever while failed.
  [[nodiscard]] Expected<camera::StereoFrame, camera::NoFrame> next(Seconds timeout) override;
  [[nodiscard]] double rate_hz() const override { return timing_.rate_hz; }

  /// The cable is pulled, or in again. Any thread.
  void fail(bool failed) noexcept { failed_.store(failed, std::memory_order_relaxed); }

 private:
  [[nodiscard]] TimePoint triggered(std::uint64_t sequence) const;
  [[nodiscard]] TimePoint ready(std::uint64_t sequence) const;
  [[nodiscard]] std::uint64_t newestReady(TimePoint now) const;
  [[nodiscard]] camera::StereoFrame render(std::uint64_t sequence);

  StereoRenderer renderer_;
  CameraTiming timing_;
  World world_;
  const TimeSource& time_;
  TimePoint start_;
  std::uint64_t seed_ = 0;
  std::uint64_t next_ = 0;  ///< first frame that was not handed out
  std::atomic<bool> failed_{false};
  std::array<StereoRenderer::Instant, 3> instants_;
};

}  // namespace mirrorarm::simulation
