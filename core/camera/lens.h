#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

/// The two lens models on rays, before focal length and principal point: `bend` takes a point of camera frame
/// C to its distorted point on the image plane of focal length 1, `straighten` takes that back to the plane z
/// = 1. `limit` is the largest radius (angle) at which the model holds.
namespace mirrorarm::camera {

using BendJacobian = Eigen::Matrix<double, 2, 3>;
using Distortion = std::array<double, 5>;

namespace brown_conrady {
[[nodiscard]] double limit(const Distortion& distortion);
[[nodiscard]] std::optional<Eigen::Vector2d> bend(const Distortion& distortion, double limit,
                                                  const Eigen::Vector3d& p_C, BendJacobian* J);
[[nodiscard]] std::optional<Eigen::Vector2d> straighten(const Distortion& distortion, double limit,
                                                        const Eigen::Vector2d& bent);
}  // namespace brown_conrady

namespace kannala_brandt {
[[nodiscard]] double limit(const Distortion& distortion);
[[nodiscard]] std::optional<Eigen::Vector2d> bend(const Distortion& distortion, double limit,
                                                  const Eigen::Vector3d& p_C, BendJacobian* J);
[[nodiscard]] std::optional<Eigen::Vector2d> straighten(const Distortion& distortion, double limit,
                                                        const Eigen::Vector2d& bent);
}  // namespace kannala_brandt

}  // namespace mirrorarm::camera
