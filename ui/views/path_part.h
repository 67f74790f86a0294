#pragma once

#include <vtkSmartPointer.h>

#include "core/robot/kinematics.h"
#include "ui/model/workplace.h"
#include "ui/views/scene_part.h"

class vtkActor;
class vtkPoints;
class vtkPolyData;

namespace mirrorarm::ui {

/// The way of the sling: a thin line where it has been and a thick one where the trajectory in force leads
/// it.
class PathPart final : public ScenePart {
 public:
  explicit PathPart(const Workplace& workplace);
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  struct Line {
    vtkSmartPointer<vtkPolyData> data;
    vtkSmartPointer<vtkActor> actor;
  };
  [[nodiscard]] static Line makeLine(double width_px);
  static void draw(const Line& line, const std::vector<Eigen::Vector3d>& points_B);
  void remember(const Eigen::Vector3d& p_BE, therapy::Phase phase);
  void lookAhead(const station::ControlState& control);

  int joint_count_;
  RigidTransform X_FE_;
  robot::Kinematics kinematics_;
  Line done_;
  Line ahead_;
  std::vector<Eigen::Vector3d> trail_B_;
  std::vector<Eigen::Vector3d> ahead_B_;
};

}  // namespace mirrorarm::ui
