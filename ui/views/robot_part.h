#pragma once

#include <vtkSmartPointer.h>

#include "core/robot/arm_description.h"
#include "ui/model/workplace.h"
#include "ui/views/scene_part.h"

class vtkActor;

namespace mirrorarm::ui {

/// The robot as its description says: shells around the links, rings and caps at the joints, and what is
/// fixed to the flange.
class RobotPart final : public ScenePart {
 public:
  explicit RobotPart(const Workplace& workplace);
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  enum class Material { kShell, kJoint, kAttached };
  struct Piece {
    Material material;
    int link;
    RigidTransform X_LP;  ///< piece in its link
    vtkSmartPointer<vtkActor> actor;
  };
  void addCapsule(const robot::Capsule& capsule, Material material);
  void addJoint(const robot::ArmDescription& arm, int joint);

  std::vector<Piece> pieces_;
};

}  // namespace mirrorarm::ui
