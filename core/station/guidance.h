#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/station/calibration_jobs.h"
#include "core/station/view_drive.h"

namespace mirrorarm::station {

/// Where to go next, and the robot's way there: asks for proposals and, when it is to drive, brings the robot
/// to one after the other. Control thread only.
class Guidance {
 public:
  /// `servo` and `arm` are nullptr without a robot.
  Guidance(CalibrationJobs& jobs, control::ServoLoop* servo, std::shared_ptr<const PlannedArm> arm,
           const CalibrationSettings& settings);

  /// What the control thread knows when it asks.
  struct Situation {
    TimePoint now{};
    CalibrationJob job = CalibrationJob::kStereo;
    calibration::Board board;
    camera::LensModel model = camera::LensModel::kBrownConrady;
    calibration::ImageSize size;
    const std::optional<camera::StereoRig>& rig;  ///< as it is known so far
    const RigidTransform& X_FC;
    const TakenViews& views;
    std::size_t wanted = 0;
    const control::ServoState& servo;
    std::optional<RigidTransform> X_BM;  ///< nothing before the board was seen at rest
  };
  /// One beat while capturing.
  void step(const Situation& situation);
  void take(const ViewProposal& proposal, std::uint64_t version, const Situation& situation);

  /// A new job, or none: the robot is brought to rest.
  void forget();
  /// The robot rests and is to go by itself from now on.
  void startDriving(const control::ServoState& state);
  void stopDriving();

  [[nodiscard]] bool isDriving() const { return driving_; }
  /// Since when the robot waits at a view for the view to be taken; nothing while it does not.
  [[nodiscard]] std::optional<TimePoint> waitsSince() const;
  [[nodiscard]] const std::optional<calibration::ViewWish>& proposal() const { return proposal_; }

 private:
  void advance(const Situation& situation);
  void waitForView(const Situation& situation);
  void depart(const Situation& situation);
  void ask(const Situation& situation);
  [[nodiscard]] bool wantsProposal(const Situation& situation) const;
  void giveUp(std::string_view why);

  CalibrationJobs& jobs_;
  const std::shared_ptr<const PlannedArm> arm_;
  const Seconds clock_motion_;
  std::optional<ViewDrive> drive_;
  bool driving_ = false;
  bool asked_ = false;
  std::optional<std::uint64_t> answered_;  ///< version of the views that the proposal belongs to
  std::optional<calibration::ViewWish> proposal_;
  std::vector<robot::Joints> path_;  ///< to the proposal, not yet begun
  std::vector<RigidTransform> avoided_CM_;
  robot::Joints asked_at_;  ///< where the robot was when the proposal was asked for
  robot::Joints home_;
  std::uint64_t departed_ = 0;  ///< version of the views at departure
  int misses_ = 0;              ///< one after the other
};

}  // namespace mirrorarm::station
