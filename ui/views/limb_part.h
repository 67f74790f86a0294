#pragma once

#include <memory>

#include <Eigen/Core>
#include <vtkSmartPointer.h>

#include "core/tracking/target.h"
#include "ui/model/workplace.h"
#include "ui/views/scene_part.h"

class vtkActor;

namespace mirrorarm::ui {

/// The patient's forearms: the healthy one in its sleeve of markers where they are tracked, the impaired one
/// in the sling.
class LimbPart final : public ScenePart {
 public:
  explicit LimbPart(const Workplace& workplace);
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  void fitTo(const tracking::Target& target, const RigidTransform& X_BT);

  Eigen::Vector3d impaired_elbow_B_;
  vtkSmartPointer<vtkActor> healthy_;
  vtkSmartPointer<vtkActor> sleeve_;
  vtkSmartPointer<vtkActor> impaired_;
  std::shared_ptr<const tracking::Target> fitted_;
  RigidTransform X_TL_ =
      RigidTransform::Identity();  ///< limb in the target: wrist at the origin, elbow on +z
  RigidTransform X_TS_ = RigidTransform::Identity();  ///< sleeve in the target
};

}  // namespace mirrorarm::ui
