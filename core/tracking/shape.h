#pragma once

#include <span>

#include <Eigen/Core>

namespace mirrorarm::tracking {

/// The markers of a target as they are expected in a frame. Spans of somebody else's; equally long or empty.
struct Shape {
  std::span<const Eigen::Vector3d> markers_T;        ///< [m]
  std::span<const Eigen::Matrix3d> covariance_m2{};  ///< of each, in T; empty when exactly known
  std::span<const char> present{};                   ///< a flag for each: it counts; empty when all do

  [[nodiscard]] std::size_t size() const { return markers_T.size(); }
  [[nodiscard]] bool counts(std::size_t marker) const { return present.empty() || present[marker] != 0; }
  [[nodiscard]] Eigen::Matrix3d covarianceOf(std::size_t marker) const {
    return covariance_m2.empty() ? Eigen::Matrix3d::Zero() : covariance_m2[marker];
  }
};

}  // namespace mirrorarm::tracking
