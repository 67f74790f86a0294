#pragma once

#include <vtkSmartPointer.h>

#include "ui/views/scene_part.h"

class vtkActor;

namespace mirrorarm::ui {

/// The table that the robot stands on, with a grid of 0.1 m.
class TablePart final : public ScenePart {
 public:
  TablePart();
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment&) override {}

 private:
  vtkSmartPointer<vtkActor> top_;
  vtkSmartPointer<vtkActor> grid_;
};

}  // namespace mirrorarm::ui
