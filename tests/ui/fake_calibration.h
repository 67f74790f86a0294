#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/camera/stereo_rig.h"
#include "core/station/calibration_port.h"

namespace mirrorarm::ui::test {

/// A dot plate of 9 x 7 discs, 30 mm apart.
[[nodiscard]] calibration::Board dotPlate();
/// The middle of the plate on the left camera's axis at `distance_m`, turned by `turn_rad` (rotation vector
/// in the camera).
[[nodiscard]] RigidTransform plateAt(double distance_m,
                                     const Eigen::Vector3d& turn_rad = Eigen::Vector3d::Zero(),
                                     const Eigen::Vector3d& aside_m = Eigen::Vector3d::Zero());
/// A good stereo calibration with everything that it can say, two of its views left out.
[[nodiscard]] station::StereoOutcome stereoOutcome(const camera::StereoRig& rig);

/// A calibration without threads that shows what the test sets up; it goes through the phases as the commands
/// ask.
class FakeCalibration final : public station::CalibrationPort {
 public:
  explicit FakeCalibration(const camera::StereoRig& rig);

  [[nodiscard]] station::CalibrationAnswer request(const station::CalibrationCommand& command) override;
  void stop(control::StopReason reason) noexcept override;
  void resetStop() noexcept override;
  void setEnabling(control::EnablingPosition position) noexcept override;
  [[nodiscard]] station::CalibrationSnapshot snapshot() override { return shown; }

  /// The plate before the cameras, drawn into both images.
  void see(const RigidTransform& X_CM, calibration::CaptureVerdict verdict);
  /// Both cameras see nothing.
  void seeNothing();
  /// Takes a view of the plate there.
  void take(const RigidTransform& X_CM);

  station::CalibrationSnapshot shown;
  station::CalibrationCommand last_command;
  std::vector<station::CalibrationAction> asked;
  station::CalibrationAnswer at_once = station::CalibrationAnswer::kAccepted;  ///< given by request()
  station::CalibrationAnswer later = station::CalibrationAnswer::kAccepted;    ///< said in the snapshot
  std::shared_ptr<const station::CalibrationOutcome> outcome;                  ///< of the next solving
  std::string refusal;  ///< of the next solving; empty: it succeeds
  int stops = 0;
  int resets = 0;

 private:
  void obey(const station::CalibrationCommand& command);
  /// A residual each; the seventh and the twelfth are left out.
  void judgeViews();
  void setViews(std::vector<station::TakenView> views);
  const camera::StereoRig rig_;
  std::vector<station::TakenView> removed_;
};

}  // namespace mirrorarm::ui::test
