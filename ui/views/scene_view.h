#pragma once

#include <memory>
#include <vector>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkSmartPointer.h>

#include "core/robot/kinematics.h"
#include "ui/model/workplace.h"
#include "ui/views/scene_part.h"

class vtkRenderer;

namespace mirrorarm::ui {

/// The 3D scene: robot, cameras, markers, both arms and the way ahead, in robot base with z up. The mouse
/// turns, shifts and zooms it. One show() sets the poses and draws once.
class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT
 public:
  /// Call before the QApplication is made: the surface that the scene is drawn on, with multisampling.
  static void prepareSurface();

  /// `workplace` outlives the view.
  explicit SceneView(const Workplace& workplace, QWidget* parent = nullptr);
  ~SceneView() override;

  void setTheme(const Theme& theme);
  void show(const station::Snapshot& snapshot);
  using QWidget::show;

 public slots:
  /// Looks from where everything can be seen.
  void resetView();

 private:
  [[nodiscard]] SceneMoment momentOf(const station::Snapshot& snapshot);
  void addLights();
  void addParts();

  const Workplace& workplace_;
  robot::Kinematics kinematics_;
  std::vector<RigidTransform> X_BL_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderer> overlay_;  ///< signs that no body may hide
  std::vector<std::unique_ptr<ScenePart>> parts_;
};

}  // namespace mirrorarm::ui
