#include "core/station/stages.h"

#include <stdexcept>

namespace mirrorarm::station {
namespace {

robot::MotionLimits limitsFor(const StationSettings& settings, const robot::ArmDescription& arm) {
  const auto limits = robot::limitsOf(settings.limits_profile, arm);
  if (!limits) throw std::runtime_error("no limits profile is called '" + settings.limits_profile + "'");
  return *limits;
}

control::AssistSettings assistFor(const StationSettings& settings, const Equipment& equipment) {
  return {equipment.X_FE.translation(), settings.force, settings.assist};
}

/// A way around something is no use if the cameras on the hand lose the target on it.
control::SightRule sightFor(const Equipment& equipment) {
  return [gaze = control::Gaze(equipment.rig, equipment.X_FE.inverse() * equipment.X_FC),
          kinematics = std::make_shared<const robot::Kinematics>(equipment.arm),
          X_FE = equipment.X_FE](const robot::Joints& q, const control::Sight& sight) {
    return gaze.sees(kinematics->flange(q) * X_FE, sight);
  };
}

}  // namespace

Stages::Stages(const Equipment& equipment, const StationSettings& settings)
    : limits(limitsFor(settings, equipment.arm)),
      servo(equipment.arm, limits, *equipment.robot, settings.supervisor, assistFor(settings, equipment),
            robot::Clearance(equipment.arm, equipment.attached, equipment.obstacles)),
      desk(robot::Planner(equipment.arm, equipment.attached, equipment.obstacles, settings.planner),
           sightFor(equipment)),
      tracking(equipment.rig, settings),
      recorder(settings, limits, equipment.simulated),
      control(equipment, settings, limits, servo, desk, tracking, recorder) {}

const Snapshot& Stages::snapshot() {
  if (const auto* frame = tracking.for_screen.take()) snapshot_.frame = *frame;
  if (const auto* state = control.for_screen.take()) snapshot_.control = *state;
  if (const auto* record = recorder.for_screen.take()) snapshot_.record = *record;
  return snapshot_;
}

}  // namespace mirrorarm::station
