#pragma once

#include <array>

#include <vtkSmartPointer.h>

#include "ui/views/scene_part.h"

class vtkActor;

namespace mirrorarm::ui {

/// Axes of the target on the healthy arm, of the sling, and a ring where the sling belongs.
class FramePart final : public ScenePart {
 public:
  FramePart();
  void addTo(vtkRenderer& renderer) override;
  void paint(const Theme& theme) override;
  void show(const SceneMoment& moment) override;

 private:
  using Triad = std::array<vtkSmartPointer<vtkActor>, 3>;
  [[nodiscard]] static Triad makeTriad(double length_m);
  static void place(const Triad& triad, const RigidTransform& X_BP);

  Triad target_;
  Triad sling_;
  vtkSmartPointer<vtkActor> goal_;
};

}  // namespace mirrorarm::ui
