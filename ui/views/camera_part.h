#pragma once

#include <array>

#include <vtkSmartPointer.h>

#include "core/camera/stereo_rig.h"
#include "ui/views/scene_part.h"

class vtkActor;

namespace mirrorarm::ui {

/// Both cameras of the rig and the pyramids that they see.
class CameraPart final : public ScenePart {
 public:
  explicit CameraPart(const camera::StereoRig& rig);
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  struct Eye {
    RigidTransform X_CK;  ///< this camera in the left one
    vtkSmartPointer<vtkActor> body;
    vtkSmartPointer<vtkActor> edges;
    vtkSmartPointer<vtkActor> sides;
  };
  std::array<Eye, 2> eyes_;
};

}  // namespace mirrorarm::ui
