#pragma once

#include <optional>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/station/snapshot.h"

class vtkRenderer;

namespace mirrorarm::ui {

class Theme;

/// One beat of the scene: the snapshot and the poses that follow from it, all in robot base B.
struct SceneMoment {
  const station::Snapshot& snapshot;
  const std::vector<RigidTransform>& X_BL;  ///< links, 0 the base
  RigidTransform X_BF = RigidTransform::Identity();
  RigidTransform X_BC = RigidTransform::Identity();
  RigidTransform X_BE = RigidTransform::Identity();
  std::optional<RigidTransform> X_BT = std::nullopt;       ///< the healthy arm's target, while it is seen
  std::optional<RigidTransform> X_BE_goal = std::nullopt;  ///< while there is one
};

/// Something in the 3D scene: robot, cameras, arms, markers. Screen's thread.
class ScenePart {
 public:
  virtual ~ScenePart() = default;
  virtual void addTo(vtkRenderer& renderer) = 0;
  virtual void paint(const Theme& theme) = 0;
  virtual void show(const SceneMoment& moment) = 0;
};

}  // namespace mirrorarm::ui
