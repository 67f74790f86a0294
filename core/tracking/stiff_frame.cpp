#include "core/tracking/stiff_frame.h"

#include <Eigen/LU>

#include "core/geometry/small_motion.h"

namespace mirrorarm::tracking {
namespace {

constexpr int kStepsAFrame = 2;
constexpr double kLeastVariance = 0.01;  // of the first mode's: lesser ones move no frame
constexpr double kFloor = 0.05;          // of a mode's mean square

}  // namespace

void StiffFrame::learn(const DeviationModes& modes, std::span<const Eigen::Vector3d> rest_T,
                       std::span<const char> present) {
  motions_ = (motions_ * modes.lastTurn()).eval();
  rows_.resize(rest_T.size());
  for (std::size_t i = 0; i < rest_T.size(); ++i) rows_[i] = motionAt(rest_T[i]);
  for (int mode = 0; mode < kModes; ++mode) {
    if (modes.variances()[mode] <= kLeastVariance * modes.variances()[0]) {
      motions_.col(mode).setZero();
      continue;
    }
    for (int i = 0; i < kStepsAFrame; ++i) step(mode, modes, present);
  }
}

void StiffFrame::step(int mode, const DeviationModes& modes, std::span<const char> present) {
  const double floor = kFloor / static_cast<double>(rows_.size());
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (present[i] == 0) continue;
    const Eigen::Vector3d carried = modes.of(i).col(mode);
    const double weight = 1.0 / ((carried + rows_[i] * motions_.col(mode)).squaredNorm() + floor);
    normal += weight * rows_[i].transpose() * rows_[i];
    right -= weight * rows_[i].transpose() * carried;
  }
  motions_.col(mode) = normal.inverse() * right;
}

RigidTransform StiffFrame::motion(const ModeVector& amplitudes) const {
  return smallMotion(motions_ * amplitudes);
}

}  // namespace mirrorarm::tracking
