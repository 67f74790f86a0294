#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/calibration/capture_rule.h"
#include "core/camera/stereo_rig.h"
#include "core/common/latest_value.h"
#include "core/station/calibration_snapshot.h"

namespace mirrorarm::station {

/// What is looked for in the frames, and against what a view is new.
struct BoardWatch {
  std::uint64_t version = 0;
  std::uint64_t job = 0;                    ///< counts the jobs: another board, or the same one put elsewhere
  std::optional<calibration::Board> board;  ///< nothing: frames pass by
  std::optional<camera::StereoRig> rig;     ///< for the board's pose
  std::vector<calibration::BoardView> taken;
};

/// One frame and by which watch it was judged.
struct BoardReport {
  std::shared_ptr<const BoardFrame> frame;
  std::uint64_t watch = 0;  ///< its version; 0 before the first
};

/// From a stereo frame to the board in it and whether the view is to be taken. process() belongs to the
/// vision thread.
class BoardStage {
 public:
  explicit BoardStage(const calibration::CaptureSettings& settings) : settings_(settings) {}

  /// From the next frame on. Control thread only.
  void watch(std::shared_ptr<const BoardWatch> watch) noexcept { orders_.put(std::move(watch)); }

  [[nodiscard]] BoardReport process(const camera::StereoFrame& frame);

 private:
  void takeOrders();
  void find(BoardFrame& seen);
  void judge(BoardFrame& seen);

  const calibration::CaptureSettings settings_;
  LatestValue<std::shared_ptr<const BoardWatch>> orders_;
  std::shared_ptr<const BoardWatch> watch_;  ///< nullptr before the first
  std::optional<calibration::CaptureRule> rule_;
  calibration::Sighting last_left_;  ///< the newest that was found: the next one is numbered alike
};

}  // namespace mirrorarm::station
