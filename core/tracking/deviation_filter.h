#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/common/time.h"
#include "core/tracking/deviation_fit.h"
#include "core/tracking/deviation_modes.h"
#include "core/tracking/excess_variance.h"
#include "core/tracking/shape_gauge.h"
#include "core/tracking/stiff_frame.h"

namespace mirrorarm::tracking {

/// How far the markers of one target are from their rest shape, carried from frame to frame: d = U a + o, a
/// few modes whose amplitudes go on as they went, and a part of each marker's own that fades. What is
/// expected next, how sure that is, and the learning of both from what was seen.
class DeviationFilter {
 public:
  explicit DeviationFilter(Seconds memory) : memory_(memory), steps_(memory), own_steps_(memory) {}

  void resize(std::size_t markers);

  /// Expects the deviations at `time`, from the last frame learnt.
  void predict(TimePoint time);
  /// From the mean frame of all markers, in which deviations are told, to the frame of the stiff part, as
  /// expected.
  [[nodiscard]] RigidTransform stiffMotion() const { return stiff_.motion(amplitudes_expected_); }
  /// What is expected of a marker [m], and the variance of its innovation along an axis beyond the sensor
  /// [m^2]: it grows while the marker is hidden, up to what the marker has ever deviated.
  [[nodiscard]] const Eigen::Vector3d& expected(std::size_t marker) const { return expected_[marker]; }
  [[nodiscard]] double variance(std::size_t marker) const;

  /// True when it was seen in the frame before, or about then.
  [[nodiscard]] bool wasSeenJustNow(std::size_t marker) const { return framesHidden(marker) < 1.5; }
  /// Frames in a row in which it was seen, the last learnt one with them.
  [[nodiscard]] int framesSeen(std::size_t marker) const { return frames_seen_[marker]; }

  /// Takes the motion of the body off the innovations, by the stiffest markers: what was seen of the skin.
  void takeBodyMotionOff(std::span<SeenMarker> seen);
  /// Learns a frame after takeBodyMotionOff(), from the markers that count.
  void learn(std::span<SeenMarker> seen, std::span<const Eigen::Vector3d> rest_T,
             std::span<const char> present);
  /// Moves a share of the deviations into the rest shape, which is not moved as a whole; nothing after a
  /// frame in which many markers were hidden.
  void giveToRest(double share, std::span<Eigen::Vector3d> rest_T);
  void add(std::size_t marker, const Eigen::Vector3d& deviation) { now_[marker] += deviation; }

  [[nodiscard]] std::span<const Eigen::Vector3d> deviations() const { return now_; }
  /// Mean square of what a marker has deviated along an axis so far [m^2].
  [[nodiscard]] double levelVariance(std::size_t marker) const { return gauge_.variance(marker); }
  [[nodiscard]] double pooledVariance() const { return steps_.pooled(); }
  [[nodiscard]] TimePoint lastLearnt() const { return time_; }

 private:
  [[nodiscard]] double framesHidden(std::size_t marker) const;
  [[nodiscard]] double ownVariance(std::size_t marker) const;
  void learnVariances(ExcessVariance& variances, std::span<const SeenMarker> seen, Seconds step);
  void estimate(std::span<SeenMarker> seen);
  void placeHidden(std::span<SeenMarker> seen, std::span<const Eigen::Vector3d> rest_T,
                   std::span<const char> present, double step_s);
  void learnMotion(double share_of_memory);
  void learnShape(std::span<const Eigen::Vector3d> rest_T, std::span<const char> present, double share);

  Seconds memory_;
  ExcessVariance steps_;      ///< of innovations: modes and own part together
  ExcessVariance own_steps_;  ///< of what the modes leave of them
  ShapeGauge gauge_;
  DeviationModes modes_;
  StiffFrame stiff_;
  DeviationFit fit_;

  std::vector<Eigen::Vector3d> now_, before_, expected_, next_;
  std::vector<Eigen::Vector3d> own_;    ///< part of each that no mode explains
  std::vector<FadingMean> own_square_;  ///< its mean square along an axis [m^2]
  std::vector<TimePoint> last_seen_;
  std::vector<int> frames_seen_;
  std::vector<char> hidden_;
  ModeVector amplitudes_expected_ = ModeVector::Zero();
  ModeVector trend_ = ModeVector::Zero();  ///< step of the amplitudes, were they to go on as they went
  FadingMean usual_step_;                  ///< [s]
  FadingMean trend_kept_, trend_square_;   ///< how far amplitudes go on as they went
  FadingMean mode_step_;  ///< square of the amplitudes' innovation, in shares of their variance
  bool begun_ = false;
  bool shows_all_ = false;  ///< the last frame showed nearly all markers
  TimePoint time_{}, time_before_{}, predicted_for_{};
};

}  // namespace mirrorarm::tracking
