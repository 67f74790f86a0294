#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/common/time.h"

namespace mirrorarm::tracking {

/// A mean over a memory: of all samples until that is full, then the older ones fade.
class FadingMean {
 public:
  void add(double sample, double share_of_memory);
  [[nodiscard]] double value() const { return mean_; }
  /// Samples that the mean stands on.
  [[nodiscard]] double count() const { return count_; }

 private:
  double mean_ = 0.0;
  double count_ = 0.0;
};

/// How much more the markers of one target scatter than their sensor explains: one variance for all and one
/// for each marker [m^2], learnt frame by frame over a short and a long memory, the larger counts.
///
/// Each frame gives a step of Fisher scoring for a variance component v_i in Cov(misfit) = C_i + v_i I. What
/// chance alone would show of it is taken off (kSigmas of it), so that a rigid body's excess is exactly
/// nothing; and a marker is taken for as loose as all are until it has shown otherwise. Source: Searle,
/// Casella, McCulloch, Variance Components, 1992, ch. 6; Efron, Morris, JASA 70, 1975 (shrinkage).
class ExcessVariance {
 public:
  explicit ExcessVariance(Seconds memory) : memory_(memory) {}

  void resize(std::size_t markers);
  /// Starts a frame, `step` after the last one.
  void begin(Seconds step);
  /// A marker's misfit [m], the covariance `sensor_m2` it has without any excess, and the part `fitted_m2`
  /// of its covariance that the fit of the frame has taken.
  void add(std::size_t marker, const Eigen::Vector3d& misfit, const Eigen::Matrix3d& sensor_m2,
           const Eigen::Matrix3d& fitted_m2);
  void end();

  [[nodiscard]] double of(std::size_t marker) const;
  [[nodiscard]] double pooled() const;

 private:
  struct Memories {
    FadingMean excess, chance;        ///< and the variance that chance gives a sample of it
    FadingMean late, chance_of_late;  ///< the same over the short memory
    void add(double sample, double variance, Seconds step, Seconds memory);
    [[nodiscard]] double value() const;
  };
  struct Sample {
    std::size_t marker = 0;
    double ratio = 0.0;     ///< square of the misfit in units of what is expected now
    double expected = 0.0;  ///< square now, and without any excess
    double sensor = 0.0;
    double information = 0.0;  ///< about the variance, and its product with what chance gives
    double chance = 0.0;
  };

  Seconds memory_;
  Seconds step_{0.0};
  Memories all_;
  std::vector<Memories> own_;
  std::vector<Sample> samples_;
  std::vector<double> ratios_;
};

}  // namespace mirrorarm::tracking
