#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace mirrorarm::therapy {

/// A movement for the patient: from rest through way points and back, each leg with minimum jerk (Flash and
/// Hogan 1985), over and over. Displacements are in robot base B (x away from the robot's foot towards the
/// patient, z up), turns about the forearm's long axis.
struct Exercise {
  struct Leg {
    Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();  ///< from the start position
    double forearm_turn_rad = 0.0;                             ///< pronation positive
    double duration_s = 2.0;
    double rest_s = 0.5;  ///< pause at the end of the leg
  };
  std::string id;
  std::vector<Leg> legs;  ///< the last one leads back to the start
};

/// The catalogue: "reach", "lift", "side", "circle", "turn".
[[nodiscard]] const std::vector<Exercise>& exercises();
[[nodiscard]] std::optional<Exercise> exerciseOf(std::string_view id);

}  // namespace mirrorarm::therapy
