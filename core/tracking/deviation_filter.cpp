#include "core/tracking/deviation_filter.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kOwnPartFades_s = 1.0;
constexpr double kLongestTrend = 3.0;               // usual steps over which amplitudes go on as they went
constexpr double kMostUnseen_m2 = 0.0025 * 0.0025;  // wider gates take up strangers
constexpr double kMostOfMode = 3.0;  // standard deviations that an amplitude told by few markers may have
constexpr double kShowsAll = 0.75;   // of the markers, that a frame must show to teach how they go together
constexpr double kFirstModeStep = 0.1;  // in shares of the modes' variance, before it is learnt

int countOf(std::span<const SeenMarker> seen) {
  return static_cast<int>(
      std::count_if(seen.begin(), seen.end(), [](const SeenMarker& marker) { return marker.counts; }));
}

}  // namespace

void DeviationFilter::resize(std::size_t markers) {
  steps_.resize(markers);
  own_steps_.resize(markers);
  gauge_.resize(markers);
  modes_.resize(markers);
  for (auto* field : {&now_, &before_, &expected_, &next_, &own_}) field->resize(markers, Vector3d::Zero());
  own_square_.resize(markers);
  last_seen_.resize(markers, time_);
  frames_seen_.resize(markers, 0);
}

void DeviationFilter::predict(TimePoint time) {
  predicted_for_ = time;
  const ModeVector now = modes_.amplitudes(now_);
  const double step = begun_ ? secondsBetween(time_, time) : 0.0;
  const double step_before = secondsBetween(time_before_, time_);
  trend_.setZero();
  if (step_before > 0.0 && step < kLongestTrend * std::max(step_before, usual_step_.value()))
    trend_ = (now - modes_.amplitudes(before_)) * (step / step_before);
  const double kept =
      trend_square_.value() > 0.0 ? std::clamp(trend_kept_.value() / trend_square_.value(), 0.0, 1.0) : 0.0;
  amplitudes_expected_ = now + kept * trend_;
  const double fade = std::exp(-std::max(step, 0.0) / kOwnPartFades_s);
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const Vector3d own = now_[i] - modes_.of(i) * now;
    expected_[i] = modes_.of(i) * amplitudes_expected_ + fade * own;
  }
}

double DeviationFilter::framesHidden(std::size_t marker) const {
  if (usual_step_.value() <= 0.0) return 1.0;
  return std::max(1.0, secondsBetween(last_seen_[marker], predicted_for_) / usual_step_.value());
}

/// What a marker does by itself while nobody looks, up to what it ever did.
double DeviationFilter::ownVariance(std::size_t marker) const {
  const double own = own_steps_.of(marker);
  const double hidden = framesHidden(marker);
  return std::max(own, std::min({own * hidden * hidden, gauge_.variance(marker), kMostUnseen_m2}));
}

double DeviationFilter::variance(std::size_t marker) const {
  return steps_.of(marker) + ownVariance(marker) - own_steps_.of(marker);
}

void DeviationFilter::takeBodyMotionOff(std::span<SeenMarker> seen) {
  for (SeenMarker& marker : seen)
    marker.covariance_m2 = marker.sensor_m2 + variance(marker.marker) * Matrix3d::Identity();
  fit_.run(seen, modes_, {});
}

void DeviationFilter::learn(std::span<SeenMarker> seen, std::span<const Vector3d> rest_T,
                            std::span<const char> present) {
  const Seconds step(begun_ ? secondsBetween(time_, predicted_for_) : 0.0);
  const double share = std::clamp(step / memory_, 0.0, 1.0);
  if (begun_ && step.count() > 0.0 &&
      (usual_step_.count() < 1.0 || step.count() < kLongestTrend * usual_step_.value()))
    usual_step_.add(step.count(), share);
  next_ = expected_;
  const auto markers = static_cast<double>(std::count(present.begin(), present.end(), 1));
  shows_all_ = countOf(seen) >= kShowsAll * markers;
  if (countOf(seen) >= 3) {
    learnVariances(steps_, seen, step);
    estimate(seen);
    learnVariances(own_steps_, seen, step);
    placeHidden(seen, rest_T, present, step.count());
  }
  learnMotion(std::max(share, 1e-9));
  before_ = now_;
  now_ = next_;
  learnShape(rest_T, present, share);
  for (const SeenMarker& marker : seen) {
    frames_seen_[marker.marker] = wasSeenJustNow(marker.marker) ? frames_seen_[marker.marker] + 1 : 1;
    last_seen_[marker.marker] = predicted_for_;
  }
  time_before_ = begun_ ? time_ : predicted_for_;
  time_ = predicted_for_;
  begun_ = true;
}

void DeviationFilter::learnVariances(ExcessVariance& variances, std::span<const SeenMarker> seen,
                                     Seconds step) {
  variances.begin(step);
  for (const SeenMarker& marker : seen)
    if (marker.counts && wasSeenJustNow(marker.marker))
      variances.add(marker.marker, marker.left_over, marker.sensor_m2, marker.fitted_m2);
  variances.end();
}

void DeviationFilter::estimate(std::span<SeenMarker> seen) {
  for (SeenMarker& marker : seen)
    marker.covariance_m2 = marker.sensor_m2 + ownVariance(marker.marker) * Matrix3d::Identity();
  const double mode_step = mode_step_.count() > 0.0 ? mode_step_.value() : kFirstModeStep;
  fit_.run(seen, modes_, {Matrix6::Zero(), mode_step * modes_.variances()});
  const ModeVector steps = fit_.amplitudeSteps();
  for (std::size_t i = 0; i < next_.size(); ++i) next_[i] += modes_.of(i) * steps;
  for (const SeenMarker& marker : seen) {
    if (!marker.counts) continue;
    const Matrix3d excess = marker.covariance_m2 - marker.sensor_m2;
    next_[marker.marker] += excess * marker.covariance_m2.inverse() * marker.left_over;
  }
}

/// Hidden markers go along with the modes that explain best how far the seen ones are from rest now: steps
/// alone would add up their errors.
void DeviationFilter::placeHidden(std::span<SeenMarker> seen, std::span<const Vector3d> rest_T,
                                  std::span<const char> present, double step_s) {
  constexpr double kLeast_m2 = 1e-12;
  DeviationFit::Prior prior{Matrix6::Zero(), modes_.variances()};
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const RigidRows rows = motionAt(rest_T[i]);
    prior.motion_information += rows.transpose() * rows / (own_square_[i].value() + kLeast_m2);
  }
  for (SeenMarker& marker : seen) {
    marker.innovation = next_[marker.marker];
    marker.covariance_m2 =
        marker.sensor_m2 + (own_square_[marker.marker].value() + kLeast_m2) * Matrix3d::Identity();
  }
  fit_.run(seen, modes_, prior);
  const ModeVector most = kMostOfMode * modes_.variances().cwiseSqrt();
  const ModeVector amplitudes = fit_.amplitudeSteps().cwiseMin(most).cwiseMax(-most);
  const Vector6 motion = fit_.motion();
  const double fade = std::exp(-step_s / kOwnPartFades_s);
  for (auto& own : own_) own *= fade;
  for (const SeenMarker& marker : seen) {
    own_[marker.marker] = marker.left_over;
    if (shows_all_)
      own_square_[marker.marker].add(marker.left_over.squaredNorm() / 3.0, step_s / memory_.count() + 1e-9);
  }
  hidden_.assign(present.begin(), present.end());
  for (const SeenMarker& marker : seen) hidden_[marker.marker] = 0;
  for (std::size_t i = 0; i < next_.size(); ++i)
    if (hidden_[i] != 0) next_[i] = modes_.of(i) * amplitudes + motionAt(rest_T[i]) * motion + own_[i];
}

/// How well amplitudes go on as they went, and how far they are off then.
void DeviationFilter::learnMotion(double share_of_memory) {
  if (modes_.areNone() || !shows_all_) return;
  const ModeVector next = modes_.amplitudes(next_);
  trend_kept_.add((next - modes_.amplitudes(now_)).dot(trend_), share_of_memory);
  trend_square_.add(trend_.squaredNorm(), share_of_memory);
  mode_step_.add(std::min(1.0, (next - amplitudes_expected_).squaredNorm() / modes_.variances().sum()),
                 share_of_memory);
}

void DeviationFilter::learnShape(std::span<const Vector3d> rest_T, std::span<const char> present,
                                 double share) {
  gauge_.prepare(rest_T, present);
  gauge_.removeRigidPart(now_);
  if (!shows_all_) return;
  gauge_.learn(now_, present, std::max(share, 1e-9));
  modes_.refit(gauge_);
  modes_.learn(now_, std::max(share, 1.0 / (1.0 + usual_step_.count())));
  stiff_.learn(modes_, rest_T, present);
}

void DeviationFilter::giveToRest(double share, std::span<Vector3d> rest_T) {
  if (!shows_all_) return;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const Vector3d given = share * now_[i];
    rest_T[i] += given;
    now_[i] -= given;
    before_[i] -= given;
  }
}

}  // namespace mirrorarm::tracking
