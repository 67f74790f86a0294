#pragma once

#include <optional>
#include <string>

#include "core/robot/arm_description.h"
#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

/// Which part of the arm meets which kind of thing.
struct ContactKinds {
  ArmPart part = ArmPart::kLink;
  std::optional<ObstacleKind> obstacle = {};  ///< nothing: the arm meets itself
};

/// Which shape of the arm meets what.
struct Contact {
  ArmPart part = ArmPart::kLink;
  std::optional<ObstacleKind> obstacle;  ///< nothing: the arm meets itself
  std::string name = {};                 ///< of the obstacle
};

/// One line for an engineer: "sling meets head 'patient'", "camera_bar meets the arm".
[[nodiscard]] std::string describe(const Contact& contact);

}  // namespace mirrorarm::robot
