#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/calibration/next_view.h"
#include "core/station/calibration_command.h"
#include "core/station/calibration_settings.h"
#include "core/station/taken_views.h"
#include "core/station/view_planner.h"

namespace mirrorarm::station {

/// All that decides where to go next. A value: it goes to another thread.
struct ViewQuestion {
  CalibrationJob job = CalibrationJob::kStereo;
  calibration::Board board;
  std::optional<camera::StereoRig> rig;                        ///< as it is known so far
  camera::LensModel model = camera::LensModel::kBrownConrady;  ///< should it be solved from the views
  calibration::ImageSize size;
  std::shared_ptr<const TakenViews::List> views;
  std::vector<RigidTransform> avoided_CM;  ///< went there in vain
  struct Robot {
    std::shared_ptr<const PlannedArm> arm;
    RigidTransform X_BM = RigidTransform::Identity();
    RigidTransform X_FC = RigidTransform::Identity();
    robot::Joints at;
    robot::Joints home;  ///< where driving began
  };
  std::optional<Robot> robot;  ///< nothing: the board is in somebody's hand
};

struct ViewProposal {
  std::optional<calibration::ViewWish> wish;
  std::vector<robot::Joints> path;  ///< of the robot, from where it was; empty where there is none
  std::optional<camera::StereoRig>
      rig;  ///< from the views so far, where the one given was too rough or absent
};

/// Stereo and hand-eye: the view that tells most (calibration::nextStereoView). Drift: the next station of
/// the grid. Clock: no view, but a path that turns the camera about two axes and comes back.
[[nodiscard]] ViewProposal proposeView(const ViewQuestion& question, const CalibrationSettings& settings);

}  // namespace mirrorarm::station
