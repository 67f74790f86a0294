#include "ui/views/scene_view.h"

#include <QSurfaceFormat>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTerrain.h>
#include <vtkLightKit.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "ui/views/camera_part.h"
#include "ui/views/frame_part.h"
#include "ui/views/limb_part.h"
#include "ui/views/marker_part.h"
#include "ui/views/path_part.h"
#include "ui/views/robot_part.h"
#include "ui/views/table_part.h"
#include "ui/views/theme.h"

namespace mirrorarm::ui {
namespace {

constexpr int kSamples = 4;
// What must be seen: the robot upright, both arms before it [m in B].
const double kInteresting[6] = {-0.1, 0.95, -0.25, 0.6, 0.0, 0.8};
const Eigen::Vector3d kFromSide(1.0, -0.68, 0.6);  // where the view looks from
constexpr double kCloser = 1.5;                    // ResetCamera leaves room for a whole sphere

}  // namespace

void SceneView::prepareSurface() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(kSamples);
  QSurfaceFormat::setDefaultFormat(format);
}

SceneView::SceneView(const Workplace& workplace, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      workplace_(workplace),
      kinematics_(workplace.arm),
      X_BL_(static_cast<std::size_t>(workplace.arm.jointCount() + 1), RigidTransform::Identity()),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      overlay_(vtkSmartPointer<vtkRenderer>::New()) {
  const vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(kSamples);
  setRenderWindow(window);
  window->SetNumberOfLayers(2);
  window->AddRenderer(renderer_);
  window->AddRenderer(overlay_);
  overlay_->SetLayer(1);
  overlay_->InteractiveOff();
  overlay_->SetActiveCamera(renderer_->GetActiveCamera());
  renderer_->GradientBackgroundOn();
  const vtkNew<vtkInteractorStyleTerrain> style;  // keeps z up
  window->GetInteractor()->SetInteractorStyle(style);
  addLights();
  addParts();
  setObjectName(QStringLiteral("sceneView"));
  setAccessibleName(tr("3D scene"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  resetView();
}

SceneView::~SceneView() = default;

void SceneView::addParts() {
  const auto add = [this](std::unique_ptr<ScenePart> part, vtkRenderer& renderer) {
    part->addTo(renderer);
    parts_.push_back(std::move(part));
  };
  add(std::make_unique<TablePart>(), *renderer_);
  add(std::make_unique<RobotPart>(workplace_), *renderer_);
  add(std::make_unique<LimbPart>(workplace_), *renderer_);
  add(std::make_unique<MarkerPart>(), *renderer_);
  add(std::make_unique<CameraPart>(workplace_.rig), *renderer_);
  add(std::make_unique<PathPart>(workplace_), *overlay_);
  add(std::make_unique<FramePart>(), *overlay_);
}

void SceneView::addLights() {
  renderer_->RemoveAllLights();
  const vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyToFillRatio(2.2);
  lights->SetKeyToHeadRatio(3.0);
  lights->SetKeyToBackRatio(4.0);
  lights->SetKeyLightWarmth(0.53);
  lights->SetFillLightWarmth(0.45);
  lights->AddLightsToRenderer(renderer_);
}

void SceneView::setTheme(const Theme& theme) {
  const QColor top = theme.colour(QStringLiteral("scene_top"));
  const QColor bottom = theme.colour(QStringLiteral("scene_bottom"));
  renderer_->SetBackground2(top.redF(), top.greenF(), top.blueF());
  renderer_->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  for (const auto& part : parts_) part->paint(theme);
  renderWindow()->Render();
}

SceneMoment SceneView::momentOf(const station::Snapshot& snapshot) {
  const auto& control = snapshot.control;
  const robot::Joints& q_rad = control.servo.measured.q_rad;
  if (q_rad.size() == workplace_.arm.jointCount())
    for (std::size_t link = 0; link < X_BL_.size(); ++link)
      X_BL_[link] = kinematics_.link(q_rad, static_cast<int>(link));
  SceneMoment moment{snapshot, X_BL_};
  moment.X_BF = control.X_BF;
  moment.X_BC = control.X_BF * workplace_.X_FC;
  moment.X_BE = control.X_BF * workplace_.X_FE;
  if (control.target_fresh) moment.X_BT = control.X_BT;
  if (control.has_goal) moment.X_BE_goal = control.X_BE_goal;
  return moment;
}

void SceneView::show(const station::Snapshot& snapshot) {
  const SceneMoment moment = momentOf(snapshot);
  for (const auto& part : parts_) part->show(moment);
  renderer_->ResetCameraClippingRange();
  renderWindow()->Render();
}

void SceneView::resetView() {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(28);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(kFromSide.x(), kFromSide.y(), kFromSide.z());
  renderer_->ResetCamera(kInteresting);
  camera->Zoom(kCloser);
  renderWindow()->Render();
}

}  // namespace mirrorarm::ui
