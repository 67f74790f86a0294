#pragma once

#include <span>
#include <vector>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"
#include "core/camera/stereo_rig.h"

namespace mirrorarm::calibration {

/// What a rig is worth on views that it was not solved from.
struct HoldOut {
  /// Root mean square distance of a raw pixel from the (curved) epipolar line of its partner, both ways.
  double epipolar_px = 0.0;
  /// Root mean square distance of a point from its projection, the board posed by this view alone.
  double reprojection_px = 0.0;
  /// Triangulated length between neighbouring board points against the true one, over all of them [%].
  double square_mean_percent = 0.0;
  double square_std_percent = 0.0;
  /// Root mean square distance, along the line of sight, of a triangulated point from the board that fits all
  /// points of its view best [m].
  double depth_rms_m = 0.0;
  std::size_t views = 0;
  /// 0: these views were kept out by wish. Else the views were parted into so many, and each part measured
  /// by a rig solved from all others.
  std::size_t parts = 0;
};

/// Gathers the figures of views, each measured by a rig that may be another every time.
class HoldOutMeter {
 public:
  /// A view in which the board cannot be posed is passed over, and so are points outside a lens model's range
  /// or seen by one camera. For a single camera only `left` of the rig counts, and reprojection alone is
  /// measured. The centres of discs are freed of their bias first.
  void add(const camera::StereoRig& rig, const Board& board, const BoardView& view);
  /// All so far; without any point all is 0.
  [[nodiscard]] HoldOut figures() const;

 private:
  void addPoints(const camera::StereoRig& rig, const Board& board, const BoardView& centres,
                 const RigidTransform& X_CM);
  double epipolar_squares_ = 0.0;
  std::size_t epipolar_count_ = 0;
  double pixel_squares_ = 0.0;
  std::size_t pixels_ = 0;
  double depth_squares_ = 0.0;
  std::size_t depths_ = 0;
  std::vector<double> lengths_;  ///< measured over true, minus 1
  std::size_t views_ = 0;
};

/// Measures one rig on `views`.
[[nodiscard]] HoldOut measureHoldOut(const camera::StereoRig& rig, const Board& board,
                                     std::span<const BoardView> views);

}  // namespace mirrorarm::calibration
