#include "benchmarks/vision/disc_trials.h"

#include <algorithm>

#include <Eigen/LU>

#include "benchmarks/parallel.h"
#include "benchmarks/statistics.h"
#include "benchmarks/suite.h"

namespace mirrorarm::benchmarks::vision {
namespace {

/// Where a person would click: the methods get no better hint.
Eigen::Vector2d hintOf(const Disc& disc) { return disc.centre_px.array().round(); }

/// Renders each disc and asks the methods; a worker of its own a thread.
struct Worker {
  std::vector<DiscTrial>& trials;
  double snr;
  std::uint64_t stream;
  const DiscMaker& make;
  Estimators estimators;

  void operator()(int index) {
    TrialRandom random(kSeed, stream, static_cast<std::uint64_t>(index));
    DiscTrial& trial = trials[static_cast<std::size_t>(index)];
    trial.truth = make(random);
    const auto image = exposed(lightOf(trial.truth), trial.truth.contrast / snr, random);
    for (const auto& estimator : estimators)
      trial.answers.push_back(estimator->estimate(image.view(), hintOf(trial.truth)));
  }
};

MethodError errorOf(const std::vector<DiscTrial>& trials, std::size_t method,
                    const CentreEstimator& estimator) {
  MethodError error{estimator.name(), estimator.isOurs(), 0, 0.0, std::nullopt};
  RootMeanSquare rms;
  double normalised = 0.0;
  bool tells = false;
  for (const DiscTrial& trial : trials) {
    const auto& estimate = trial.answers[method];
    if (!estimate) continue;
    const Eigen::Vector2d off = estimate->centre_px - trial.truth.centre_px;
    rms.addSquare(off.squaredNorm(), 2);
    ++error.found;
    if (!estimate->covariance_px2) continue;
    tells = true;
    normalised += off.dot(estimate->covariance_px2->inverse() * off);
  }
  error.rms_px = rms.value();
  if (tells) error.mean_normalised_square = normalised / error.found;
  return error;
}

}  // namespace

std::vector<DiscTrial> runDiscTrials(int count, double snr, std::uint64_t stream, const DiscMaker& make,
                                     Estimators (*methods)()) {
  std::vector<DiscTrial> trials(static_cast<std::size_t>(count));
  forEachTrial(count, [&] { return Worker{trials, snr, stream, make, methods()}; });
  return trials;
}

std::vector<MethodError> errorsOf(const std::vector<DiscTrial>& trials) {
  const Estimators estimators = allEstimators();
  std::vector<MethodError> errors;
  for (std::size_t method = 0; method < estimators.size(); ++method)
    errors.push_back(errorOf(trials, method, *estimators[method]));
  return errors;
}

MeanBound meanBoundOf(const std::vector<DiscTrial>& trials, double snr) {
  constexpr std::size_t kMost = 200;
  const std::size_t count = std::min(trials.size(), kMost);
  std::vector<CentreBound> bounds(count);
  forEachTrial(static_cast<int>(count), [&] {
    return [&](int i) {
      const Disc& disc = trials[static_cast<std::size_t>(i)].truth;
      bounds[static_cast<std::size_t>(i)] = centreBound(disc, disc.contrast / snr);
    };
  });
  RootMeanSquare formula, alone, blurred, ramp;
  for (std::size_t i = 0; i < count; ++i) {
    const Disc& disc = trials[i].truth;
    formula.addSquare(std::pow(centreBoundFormula(disc, disc.contrast / snr), 2));
    alone.addSquare(bounds[i].centre_alone * bounds[i].centre_alone);
    blurred.addSquare(bounds[i].blurred_ellipse * bounds[i].blurred_ellipse);
    ramp.addSquare(bounds[i].with_ramp * bounds[i].with_ramp);
  }
  return {formula.value(), {alone.value(), blurred.value(), ramp.value()}};
}

}  // namespace mirrorarm::benchmarks::vision
