#include "core/station/calibration_stages.h"

#include <stdexcept>

namespace mirrorarm::station {
namespace {

std::shared_ptr<const PlannedArm> plannedArm(const Equipment& equipment,
                                             const CalibrationSettings& settings) {
  if (equipment.robot == nullptr) return nullptr;
  const auto limits = robot::limitsOf(settings.limits_profile, equipment.arm);
  if (!limits) throw std::runtime_error("no limits profile is called '" + settings.limits_profile + "'");
  return std::make_shared<const PlannedArm>(PlannedArm{equipment.arm, equipment.attached, equipment.obstacles,
                                                       *limits, settings.planner, settings.table_height_m});
}

std::unique_ptr<control::ServoLoop> servoFor(const Equipment& equipment, const PlannedArm* arm,
                                             const CalibrationSettings& settings) {
  if (arm == nullptr) return nullptr;
  return std::make_unique<control::ServoLoop>(arm->arm, arm->limits, *equipment.robot, settings.supervisor,
                                              control::AssistSettings{},
                                              robot::Clearance(arm->arm, arm->attached, arm->obstacles));
}

}  // namespace

CalibrationStages::CalibrationStages(const Equipment& equipment, const CalibrationSettings& settings,
                                     JobRunner& runner)
    : CalibrationStages(equipment, settings, plannedArm(equipment, settings), runner) {}

CalibrationStages::CalibrationStages(const Equipment& equipment, const CalibrationSettings& settings,
                                     std::shared_ptr<const PlannedArm> arm, JobRunner& runner)
    : servo(servoFor(equipment, arm.get(), settings)),
      boards(settings.capture),
      control(equipment, settings, servo.get(), std::move(arm), boards, runner) {}

void CalibrationStages::stop(control::StopReason reason) noexcept {
  if (servo) servo->stop(reason);
}

void CalibrationStages::resetStop() noexcept {
  if (servo) servo->resetStop();
}

void CalibrationStages::setEnabling(control::EnablingPosition position) noexcept {
  if (servo) servo->setEnabling(position);
}

CalibrationSnapshot CalibrationStages::snapshot() {
  if (const auto* news = control.for_screen.take()) snapshot_ = *news;
  return snapshot_ ? *snapshot_ : CalibrationSnapshot{};
}

}  // namespace mirrorarm::station
