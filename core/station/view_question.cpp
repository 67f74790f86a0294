#include "core/station/view_question.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/calibration/board_pose.h"
#include "core/calibration/stereo_calibration.h"
#include "core/geometry/small_motion.h"

namespace mirrorarm::station {
namespace {

using calibration::ViewWish;

/// Poses of a rig that is worse are not worth planning with, if the views give a better one.
constexpr double kRough_px = 1.0;
constexpr std::size_t kViewsForRig = 6;
constexpr double kSameStation_m = 0.25;  ///< of a grid's step
constexpr double kSameView_m = 0.01;
constexpr double kSameView_rad = 0.05;
constexpr int kTries = 5;

struct Poses {
  std::vector<RigidTransform> X_CM;
  double rms_px = 0.0;
  [[nodiscard]] bool areRough() const { return rms_px > kRough_px; }
};

Poses posesOf(const ViewQuestion& question, const camera::StereoRig& rig) {
  Poses poses;
  double sum = 0.0;
  for (const auto& taken : *question.views)
    if (const auto pose = calibration::poseBoard(rig, question.board, taken.view)) {
      poses.X_CM.push_back(pose->X_CM);
      sum += pose->rms_px * pose->rms_px;
    }
  if (!poses.X_CM.empty()) poses.rms_px = std::sqrt(sum / static_cast<double>(poses.X_CM.size()));
  return poses;
}

std::optional<camera::StereoRig> rigFromViews(const ViewQuestion& question) {
  if (question.views->size() < kViewsForRig) return std::nullopt;
  auto solved = calibration::calibrateStereo(question.board, boardViewsOf(*question.views), question.size,
                                             question.model);
  if (!solved) return std::nullopt;
  return std::move(solved->rig);
}

class Proposer {
 public:
  Proposer(const ViewQuestion& question, const CalibrationSettings& settings)
      : question_(question), settings_(settings), rig_(question.rig), avoided_(question.avoided_CM) {
    if (const auto& robot = question.robot)
      planner_.emplace(*robot->arm, BoardPlace{question.board, robot->X_BM, robot->X_FC});
  }

  [[nodiscard]] ViewProposal propose() {
    switch (question_.job) {
      case CalibrationJob::kStereo:
      case CalibrationJob::kHandEye:
        return mostTelling();
      case CalibrationJob::kDrift:
        return nextStation();
      case CalibrationJob::kClock:
        return turns();
    }
    return {};
  }

 private:
  /// A view that is in reach but without a clear path there is passed over.
  ViewProposal mostTelling() {
    ViewProposal proposal;
    const bool may_solve = question_.job == CalibrationJob::kStereo;
    if (may_solve && (!rig_ || posesOf(question_, *rig_).areRough())) proposal.rig = rigFromViews(question_);
    if (proposal.rig) rig_ = proposal.rig;
    if (!rig_) return proposal;
    const auto poses = posesOf(question_, *rig_);
    for (int trial = 0; trial < kTries; ++trial) {
      proposal.wish = best(poses.X_CM);
      if (!proposal.wish || !planner_) return proposal;
      proposal.path = pathTo(proposal.wish->X_CM);
      if (!proposal.path.empty()) return proposal;
      avoided_.push_back(proposal.wish->X_CM);
    }
    return proposal;
  }

  [[nodiscard]] std::optional<ViewWish> best(const std::vector<RigidTransform>& X_CM_taken) const {
    const auto reachable = [this](const RigidTransform& X_CM) { return isReachable(X_CM); };
    return question_.job == CalibrationJob::kStereo
               ? calibration::nextStereoView(*rig_, question_.board, X_CM_taken, reachable)
               : calibration::nextHandEyeView(*rig_, question_.board, X_CM_taken, reachable);
  }

  [[nodiscard]] bool isReachable(const RigidTransform& X_CM) const {
    const bool avoided = std::ranges::any_of(avoided_, [&](const RigidTransform& other) {
      return (other.translation() - X_CM.translation()).norm() < kSameView_m &&
             angleBetween(other, X_CM) < kSameView_rad;
    });
    return !avoided && (!planner_ || planner_->joints(X_CM, seeds()));
  }

  /// From home too, should the arm have wandered into its limits from view to view.
  [[nodiscard]] std::array<robot::Joints, 2> seeds() const {
    return {question_.robot->home, question_.robot->at};
  }

  [[nodiscard]] std::vector<robot::Joints> pathTo(const RigidTransform& X_CM) {
    const auto q = planner_->joints(X_CM, seeds());
    if (!q) return {};
    return planner_->path(question_.robot->at, *q).value_or(std::vector<robot::Joints>{});
  }

  ViewProposal nextStation() {
    if (!planner_) return {};
    const RigidTransform X_BF_middle = planner_->flange(question_.robot->home);
    for (const auto& shift_B : gridShifts()) {
      const RigidTransform X_BF = Eigen::Translation3d(shift_B) * X_BF_middle;
      const RigidTransform X_CM = planner_->viewFrom(X_BF);
      if (isTaken(X_BF) || !isReachable(X_CM)) continue;
      return {ViewWish{X_CM, 0.0}, pathTo(X_CM), std::nullopt};
    }
    return {};
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> gridShifts() const {
    const Eigen::Vector3i count = settings_.drift_stations;
    const Eigen::Vector3d middle = 0.5 * (count.array() - 1).cast<double>();
    std::vector<Eigen::Vector3d> shifts;
    for (int z = 0; z < count.z(); ++z)
      for (int y = 0; y < count.y(); ++y)
        for (int x = 0; x < count.x(); ++x)
          shifts.push_back(settings_.drift_step_m * (Eigen::Vector3d(x, y, z) - middle));
    return shifts;
  }

  [[nodiscard]] bool isTaken(const RigidTransform& X_BF) const {
    return std::ranges::any_of(*question_.views, [&](const TakenView& taken) {
      return taken.X_BF && (taken.X_BF->translation() - X_BF.translation()).norm() <
                               kSameStation_m * settings_.drift_step_m;
    });
  }

  /// About the camera, so that the board stays in the images.
  ViewProposal turns() {
    if (!planner_) return {};
    const RigidTransform X_CM = planner_->viewFrom(planner_->flange(question_.robot->at));
    robot::Joints last = question_.robot->at;
    ViewProposal proposal;
    for (const auto& [right, down] : kTurns) {
      const Eigen::Vector3d turn_C = settings_.clock_turn_rad * Eigen::Vector3d(right, down, 0.0);
      const RigidTransform X_CM_there = makeTransform(turnBy(turn_C), Eigen::Vector3d::Zero()) * X_CM;
      const auto q = planner_->joints(X_CM_there, std::array{last});
      const auto way = q ? planner_->path(last, *q) : std::nullopt;
      if (!way || way->size() != 1) return {};  // a turn on the spot needs no detour
      proposal.path.push_back(last = *q);
    }
    return proposal;
  }

  static constexpr std::array<std::array<double, 2>, 10> kTurns = {
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 0.5}, {0.5, -1}, {-1, -1}, {0, 1}, {0, 0}}};

  const ViewQuestion& question_;
  const CalibrationSettings& settings_;
  std::optional<camera::StereoRig> rig_;
  std::vector<RigidTransform> avoided_;
  std::optional<ViewPlanner> planner_;
};

}  // namespace

ViewProposal proposeView(const ViewQuestion& question, const CalibrationSettings& settings) {
  return Proposer(question, settings).propose();
}

}  // namespace mirrorarm::station
