#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/calibration/board.h"
#include "core/calibration/sighting.h"

namespace mirrorarm::calibration {

/// What keeps a view of the board from being taken by itself, the most basic first.
enum class CaptureVerdict : std::uint8_t {
  kNoBoard,  ///< not seen by every camera
  kTooFew,   ///< seen, but too few of its points by every camera
  kMoving,   ///< board or camera moves
  kNotNew,   ///< looks like a view that was taken before
  kTake,     ///< still and new
};
/// "no_board", "too_few", "moving", "not_new", "take".
[[nodiscard]] std::string_view id(CaptureVerdict verdict);

/// The coordinates of a view that tell whether it shows something new, each from 0 to 1: where the middle of
/// the board lies in the first image, how large it is there (root of its share of the image), and how it is
/// tilted along and across the rows: 0.5 seen square, more when its first column (row) is nearer, by the
/// logarithm of the ratio of the outer columns' (rows') lengths. Source: the sampling rule of the ROS camera
/// calibrator, with the sign of the tilts in place of their size.
struct ViewSignature {
  double x = 0.0, y = 0.0, size = 0.0, tilt_along = 0.0, tilt_across = 0.0;
};
/// From the points that are seen; all 0 with fewer than 4.
[[nodiscard]] ViewSignature signatureOf(const Sighting& sighting, const Board& board, ImageSize size);

struct CaptureSettings {
  double still_px = 0.15;      ///< largest mean shift of the points from one frame to the next
  int still_frames = 3;        ///< that many frames in a row
  double new_distance = 0.15;  ///< least sum of differences to every view that was taken
  double least_share = 0.5;    ///< of the board's points, in every image
};

/// Decides frame by frame whether the view before the cameras is to be taken. One thread.
class CaptureRule {
 public:
  CaptureRule(const Board& board, ImageSize size, bool stereo, const CaptureSettings& settings = {});

  /// `view`: the newest frame's sightings, empty ones where the board was not found. `taken`: the views so
  /// far.
  [[nodiscard]] CaptureVerdict judge(const BoardView& view, std::span<const BoardView> taken);

 private:
  [[nodiscard]] bool isStill(const BoardView& view);
  [[nodiscard]] bool isNew(const BoardView& view, std::span<const BoardView> taken) const;
  Board board_;
  ImageSize size_;
  bool stereo_;
  CaptureSettings settings_;
  BoardView last_;
  int still_frames_ = 0;
};

}  // namespace mirrorarm::calibration
