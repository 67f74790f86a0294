#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/vision/disc.h"
#include "benchmarks/vision/estimators.h"
#include "benchmarks/vision/information.h"

namespace mirrorarm::benchmarks::vision {

/// What all methods said about one image.
struct DiscTrial {
  Disc truth;
  std::vector<Answer> answers;  ///< in the order of the methods
};

/// Makes the disc of a trial.
using DiscMaker = std::function<Disc(TrialRandom& random)>;

/// Shows `count` discs with white noise of contrast / `snr` to the methods, the same images to each.
[[nodiscard]] std::vector<DiscTrial> runDiscTrials(int count, double snr, std::uint64_t stream,
                                                   const DiscMaker& make,
                                                   Estimators (*methods)() = allEstimators);

/// What one method did over many trials.
struct MethodError {
  std::string name;
  bool ours = false;
  int found = 0;
  double rms_px = 0.0;  ///< per axis, over the discs found
  /// Mean of e^T C^-1 e over the discs found, of methods that tell a covariance: 2 when it is honest.
  std::optional<double> mean_normalised_square;
};

/// Of trials with all methods.
[[nodiscard]] std::vector<MethodError> errorsOf(const std::vector<DiscTrial>& trials);

/// Root mean square over the first discs of the trials (at most 200) of the least possible deviation.
struct MeanBound {
  double formula_px = 0.0;
  CentreBound numeric;
};
[[nodiscard]] MeanBound meanBoundOf(const std::vector<DiscTrial>& trials, double snr);

}  // namespace mirrorarm::benchmarks::vision
