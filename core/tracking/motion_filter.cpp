#include "core/tracking/motion_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirrorarm::tracking {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = MotionModel::Kind;

constexpr std::array<MotionModel, MotionFilter::kModels> kModelsOfAnArm{{
    {Kind::kRest, 0.0, 2e-9, 0.0},
    {Kind::kRest, 0.0, 2e-8, 0.0},
    {Kind::kGlide, 0.0, 1.0, 0.0},
    {Kind::kSwing, 0.0, 200.0, 0.0},
    {Kind::kSwing, 0.0, 3.0, 0.0},
    {Kind::kSwing, 0.0, 0.3, 0.0003},
    {Kind::kSwing, 2.5, 0.02, 0.0},
    {Kind::kSwing, 4.5, 0.02, 0.0},
    {Kind::kSwing, 6.0, 0.03, 0.0},
    {Kind::kSwing, 8.0, 0.1, 0.0},
    {Kind::kSwing, 12.0, 0.3, 0.0},
}};

// Of an arm [m, s].
constexpr double kStay_s = 1.5;    // how long a kind of motion lasts
constexpr double kAnySpeed = 0.5;  // when nothing is known
constexpr double kAnyAcceleration = 2.0;
constexpr double kStartSpeed = 0.02;        // in the frame in which a rest ends
constexpr double kGlideAcceleration = 1.0;  // which a glide leaves open
constexpr double kUntilStart_s = 1.0;       // a limb starts without warning once in that time,
constexpr double kUntilStop_s = 3.0;        // and stops once in this
constexpr double kUnforeseenJerk = 10.0;
constexpr double kLeastPart = 1e-6;   // less of a model's covariance than that is lost in the others'
constexpr double kLeastShare = 1e-9;  // so that every model can come back

Matrix3d swing(double w, double t) {
  Matrix3d F;
  if (w == 0.0) {
    F << 1.0, t, 0.5 * t * t, 0.0, 1.0, t, 0.0, 0.0, 1.0;
    return F;
  }
  const double s = std::sin(w * t), c = std::cos(w * t);
  F << 1.0, s / w, (1.0 - c) / (w * w), 0.0, c, s / w, 0.0, -w * s, c;
  return F;
}

Matrix3d transition(const MotionModel& model, double t) {
  if (model.kind == Kind::kSwing) return swing(model.frequency_rad_s, t);
  Matrix3d F = Matrix3d::Zero();
  F(0, 0) = 1.0;
  if (model.kind == Kind::kGlide) {
    F(0, 1) = t;
    F(1, 1) = 1.0;
  }
  return F;
}

/// What the model does not know adds this within `t` >= 0 [m]. Where it has no velocity or acceleration, what
/// another model finds when it takes over.
Matrix3d noiseWithin(const MotionModel& model, double t) {
  const double q = model.noise, t2 = t * t, t3 = t2 * t;
  Matrix3d Q = Matrix3d::Zero();
  switch (model.kind) {
    case Kind::kRest:
      Q.diagonal() << q * t, kStartSpeed * kStartSpeed, kAnyAcceleration * kAnyAcceleration;
      break;
    case Kind::kGlide:
      Q.topLeftCorner<2, 2>() << q * t3 / 3.0, q * t2 / 2.0, q * t2 / 2.0, q * t;
      Q(2, 2) = kGlideAcceleration * kGlideAcceleration;
      break;
    case Kind::kSwing:
      Q << t2 * t3 / 20.0, t2 * t2 / 8.0, t3 / 6.0, t2 * t2 / 8.0, t3 / 3.0, t2 / 2.0, t3 / 6.0, t2 / 2.0, t;
      Q *= q;
  }
  return Q;
}

/// Probability that what happens once in `mean_s` happens within `t`.
double within(double t, double mean_s) { return -std::expm1(-t / mean_s); }

}  // namespace

void MotionFilter::start(const Vector3d& position, const Vector3d& variance) {
  shares_.fill(1.0 / kModels);
  const double speed = unit_ * kAnySpeed, acceleration = unit_ * kAnyAcceleration;
  for (Body& body : bodies_)
    for (int k = 0; k < 3; ++k) {
      Axis& axis = body[static_cast<std::size_t>(k)];
      axis.state = Vector3d(position[k], 0.0, 0.0);
      axis.covariance = Vector3d(variance[k], speed * speed, acceleration * acceleration).asDiagonal();
    }
}

MotionFilter::Axis MotionFilter::mixed(std::size_t axis, const Shares& parts) const {
  Axis mixed;
  for (std::size_t i = 0; i < kModels; ++i) mixed.state += parts[i] * bodies_[i][axis].state;
  for (std::size_t i = 0; i < kModels; ++i) {
    if (parts[i] < kLeastPart) continue;
    const Vector3d apart = bodies_[i][axis].state - mixed.state;
    mixed.covariance += parts[i] * (bodies_[i][axis].covariance + apart * apart.transpose());
  }
  return mixed;
}

/// Each model goes on from what all of them think, as far as the motion may have changed to it.
void MotionFilter::mix(double step_s) {
  const double leave = within(step_s, kStay_s);
  const double change = leave / (kModels - 1);
  std::array<Body, kModels> bodies;
  Shares ahead;
  for (std::size_t j = 0; j < kModels; ++j) {
    Shares parts;
    ahead[j] = change * (1.0 - shares_[j]) + (1.0 - leave) * shares_[j];
    for (std::size_t i = 0; i < kModels; ++i)
      parts[i] = (i == j ? 1.0 - leave : change) * shares_[i] / ahead[j];
    for (std::size_t axis = 0; axis < 3; ++axis) bodies[j][axis] = mixed(axis, parts);
  }
  bodies_ = bodies;
  shares_ = ahead;
}

void MotionFilter::predict(double step_s) {
  for (std::size_t j = 0; j < kModels; ++j) {
    const Matrix3d F = transition(kModelsOfAnArm[j], step_s);
    const Matrix3d Q = unit_ * unit_ * noiseWithin(kModelsOfAnArm[j], step_s);
    for (Axis& axis : bodies_[j]) {
      axis.state = F * axis.state;
      axis.covariance = F * axis.covariance * F.transpose() + Q;
    }
  }
}

double MotionFilter::update(std::size_t j, const Vector3d& position, const Vector3d& variance) {
  const double jitter = unit_ * kModelsOfAnArm[j].jitter_m;
  double log_likelihood = 0.0;
  for (int k = 0; k < 3; ++k) {
    Axis& axis = bodies_[j][static_cast<std::size_t>(k)];
    const double surprise = position[k] - axis.state[0];
    const double expected = axis.covariance(0, 0) + variance[k] + jitter * jitter;
    const Vector3d gain = axis.covariance.col(0) / expected;
    axis.state += gain * surprise;
    axis.covariance -= gain * gain.transpose() * expected;
    log_likelihood -= 0.5 * (surprise * surprise / expected + std::log(expected));
  }
  return log_likelihood;
}

void MotionFilter::add(double step_s, const Vector3d& position, const Vector3d& variance) {
  assert(step_s > 0.0);
  mix(step_s);
  predict(step_s);
  Shares log_shares;
  for (std::size_t j = 0; j < kModels; ++j)
    log_shares[j] = std::log(shares_[j]) + update(j, position, variance);
  const double best = *std::max_element(log_shares.begin(), log_shares.end());
  double sum = 0.0;
  for (std::size_t j = 0; j < kModels; ++j)
    sum += shares_[j] = std::max(std::exp(log_shares[j] - best), kLeastShare);
  for (double& share : shares_) share /= sum;
}

MotionFilter::Prediction MotionFilter::at(double step_s) const {
  std::array<Vector3d, kModels> means;
  Prediction prediction;
  for (std::size_t j = 0; j < kModels; ++j) {
    const auto F = transition(kModelsOfAnArm[j], step_s).row(0).eval();
    const double noise = unit_ * unit_ * noiseWithin(kModelsOfAnArm[j], std::abs(step_s))(0, 0);
    for (int k = 0; k < 3; ++k) {
      const Axis& axis = bodies_[j][static_cast<std::size_t>(k)];
      means[j][k] = F.dot(axis.state);
      prediction.covariance(k, k) += shares_[j] * (F * axis.covariance * F.transpose() + noise);
    }
    prediction.mean += shares_[j] * means[j];
  }
  for (std::size_t j = 0; j < kModels; ++j) {
    const Vector3d apart = means[j] - prediction.mean;
    prediction.covariance += shares_[j] * apart * apart.transpose();
  }
  prediction.covariance.diagonal().array() += unforeseenVariance(std::abs(step_s));
  return prediction;
}

double MotionFilter::unforeseenVariance(double step_s) const {
  const double t = step_s;
  double resting = 0.0, squared_speed = 0.0;
  for (std::size_t j = 0; j < kModels; ++j) {
    if (kModelsOfAnArm[j].kind == Kind::kRest) resting += shares_[j];
    for (const Axis& axis : bodies_[j]) squared_speed += shares_[j] * axis.state[1] * axis.state[1] / 3.0;
  }
  // A stop at any instant of the step is as likely as at any other.
  const double stop = within(t, kUntilStop_s) * squared_speed * t * t / 3.0;
  const double started = unit_ * kAnyAcceleration * t * t / 2.0;
  const double start = within(t, kUntilStart_s) * resting * started * started;
  const double bent = unit_ * kUnforeseenJerk * t * t * t / 6.0;
  return stop + start + (1.0 - resting) * bent * bent;
}

void MotionFilter::moveOrigin(const Vector3d& origin) {
  for (Body& body : bodies_)
    for (int k = 0; k < 3; ++k) body[static_cast<std::size_t>(k)].state[0] -= origin[k];
}

}  // namespace mirrorarm::tracking
