#include "core/tracking/excess_variance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;

constexpr double kSigmas = 4.0;              // of chance that an excess must be above
constexpr double kShortMemory = 1.0 / 15.0;  // of the long one
constexpr double kMarkersLikeAll = 4.0;      // frames that speak for "as loose as all" against its own
constexpr double kMostOfMedian = 12.0;       // a square beyond this is no sample of what all do

double aboveChance(const FadingMean& excess, const FadingMean& chance) {
  if (excess.count() <= 0.0) return 0.0;
  return std::max(0.0, excess.value() - kSigmas * std::sqrt(chance.value() / excess.count()));
}

}  // namespace

void FadingMean::add(double sample, double share_of_memory) {
  count_ = std::min(count_ + 1.0, std::max(1.0, 1.0 / share_of_memory));
  mean_ += (sample - mean_) / count_;
}

void ExcessVariance::Memories::add(double sample, double variance, Seconds step, Seconds memory) {
  const double share = step / memory;
  excess.add(sample, share);
  chance.add(variance, share);
  late.add(sample, share / kShortMemory);
  chance_of_late.add(variance, share / kShortMemory);
}

double ExcessVariance::Memories::value() const {
  return std::max(aboveChance(excess, chance), aboveChance(late, chance_of_late));
}

void ExcessVariance::resize(std::size_t markers) {
  own_.resize(markers);
  samples_.reserve(markers);
  ratios_.reserve(markers);
}

void ExcessVariance::begin(Seconds step) {
  step_ = step;
  samples_.clear();
}

void ExcessVariance::add(std::size_t marker, const Eigen::Vector3d& misfit, const Matrix3d& sensor_m2,
                         const Matrix3d& fitted_m2) {
  const Matrix3d W = (sensor_m2 + of(marker) * Matrix3d::Identity()).inverse();
  const Matrix3d WW = W * W;
  const auto traceWith = [&](const Matrix3d& C) { return WW.cwiseProduct(C).sum(); };
  Sample sample;
  sample.marker = marker;
  sample.sensor = traceWith(sensor_m2 - fitted_m2);
  sample.information = WW.trace();
  // A fit never leaves more than it was given; rounding and weights could say so.
  sample.expected = std::max(sample.sensor + of(marker) * sample.information, 0.1 * W.trace());
  sample.ratio = misfit.dot(WW * misfit) / sample.expected;
  const Matrix3d WWC = WW * sensor_m2;
  sample.chance = 2.0 * WWC.cwiseProduct(WWC.transpose()).sum();
  samples_.push_back(sample);
}

void ExcessVariance::end() {
  if (samples_.empty()) return;
  ratios_.clear();
  for (const Sample& sample : samples_) ratios_.push_back(sample.ratio);
  const auto middle = ratios_.begin() + static_cast<std::ptrdiff_t>(ratios_.size() / 2);
  std::nth_element(ratios_.begin(), middle, ratios_.end());
  const double most = kMostOfMedian * std::max(1.0, *middle);
  double excess = 0.0, information = 0.0, chance = 0.0;
  for (const Sample& sample : samples_) {
    excess += std::min(sample.ratio, most) * sample.expected - sample.sensor;
    information += sample.information;
    chance += sample.chance;
    own_[sample.marker].add((sample.ratio * sample.expected - sample.sensor) / sample.information,
                            sample.chance / (sample.information * sample.information), step_, memory_);
  }
  all_.add(excess / information, chance / (information * information), step_, memory_);
}

double ExcessVariance::pooled() const { return all_.value(); }

double ExcessVariance::of(std::size_t marker) const {
  const double own = own_[marker].excess.count();
  return (kMarkersLikeAll * pooled() + own * own_[marker].value()) / (kMarkersLikeAll + own);
}

}  // namespace mirrorarm::tracking
