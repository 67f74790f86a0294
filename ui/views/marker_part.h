#pragma once

#include <vtkSmartPointer.h>

#include "ui/views/scene_part.h"

class vtkActor;
class vtkGlyph3DMapper;
class vtkPoints;

namespace mirrorarm::ui {

/// The discs as both cameras measure them, and around them the taught model where the tracker puts it.
class MarkerPart final : public ScenePart {
 public:
  MarkerPart();
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  struct Cloud {
    vtkSmartPointer<vtkPoints> points;
    vtkSmartPointer<vtkActor> actor;
  };
  [[nodiscard]] static Cloud makeCloud(double radius_m);
  static void place(const Cloud& cloud, const std::vector<Eigen::Vector3d>& points_B);

  Cloud measured_;
  Cloud taught_;
  std::vector<Eigen::Vector3d> points_B_;
};

}  // namespace mirrorarm::ui
