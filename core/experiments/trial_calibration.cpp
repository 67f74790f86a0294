#include "core/experiments/trial_calibration.h"

#include <vector>

#include "core/calibration/board_pose.h"
#include "core/calibration/next_view.h"
#include "core/camera/rig_file.h"
#include "core/experiments/encoder_noise.h"
#include "core/experiments/plate_studio.h"
#include "core/robot/kinematics.h"
#include "core/robot/urdf.h"
#include "core/simulation/bench_layout.h"

namespace mirrorarm::experiments {
namespace {

using calibration::BoardView;

const calibration::Board kPlate{calibration::BoardKind::kDotPlate, 9, 7, 0.03};
constexpr int kMostMisses = 20;  // views proposed that the finder does not find

/// The plate lies on the table, its middle below the place where the paper's cuboid is.
RigidTransform plateOnTable() {
  Eigen::Matrix3d R_BM;
  R_BM << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0;
  const Eigen::Vector3d middle_M = 0.5 * Eigen::Vector3d(8.0, 6.0, 0.0) * kPlate.spacing_m;
  return makeTransform(R_BM, Eigen::Vector3d(0.6, 0.0, 0.0) - R_BM * middle_M);
}

/// The LBR 4+ with the cameras on its flange.
class Carrier {
 public:
  explicit Carrier(const robot::ArmDescription& arm, std::uint64_t seed)
      : kinematics_(arm), q_(simulation::bench_layout::startPosture(kinematics_)), seed_(seed) {}

  /// Where the flange truly is, and where the encoders say.
  struct Flange {
    RigidTransform true_X_BF = RigidTransform::Identity();
    RigidTransform X_BF = RigidTransform::Identity();
  };

  [[nodiscard]] bool reaches(const RigidTransform& X_BF) const {
    return q_ && kinematics_.inverse(X_BF, *q_).has_value();
  }
  [[nodiscard]] Flange goTo(const RigidTransform& X_BF) {
    q_ = kinematics_.inverse(X_BF, *q_);
    return {kinematics_.flange(*q_), kinematics_.flange(asRead(*q_, seed_, readings_++))};
  }

 private:
  robot::Kinematics kinematics_;
  std::optional<robot::Joints> q_;
  std::uint64_t seed_;
  std::uint64_t readings_ = 0;
};

Expected<std::vector<BoardView>, std::string> takeViews(const camera::StereoRig& truth,
                                                        const TrialCalibrationSettings& settings) {
  PlateStudio studio(truth, kPlate, settings.seed);
  std::vector<BoardView> views;
  std::vector<RigidTransform> poses;
  const auto anywhere = [](const RigidTransform&) { return true; };
  while (static_cast<int>(views.size()) < settings.views) {
    const auto wish = nextStereoView(truth, kPlate, poses, anywhere);
    if (!wish || static_cast<int>(poses.size()) > settings.views + kMostMisses)
      return unexpected(std::string("the plate is found in too few views"));
    poses.push_back(wish->X_CM);
    if (auto view = studio.take(wish->X_CM, "view" + std::to_string(views.size())))
      views.push_back(std::move(*view));
  }
  return views;
}

Expected<calibration::HandEyeSolution, std::string> calibrateHandEye(
    const robot::ArmDescription& arm, const camera::StereoRig& truth, const camera::StereoRig& rig,
    const RigidTransform& X_FC, const TrialCalibrationSettings& settings) {
  const RigidTransform X_BM = plateOnTable();
  const auto flangeFor = [&](const RigidTransform& X_CM) { return X_BM * X_CM.inverse() * X_FC.inverse(); };
  Carrier carrier(arm, settings.seed);
  PlateStudio studio(truth, kPlate, settings.seed + 1);
  std::vector<RigidTransform> poses;
  std::vector<calibration::PosePair> pairs;
  const auto reachable = [&](const RigidTransform& X_CM) { return carrier.reaches(flangeFor(X_CM)); };
  while (static_cast<int>(pairs.size()) < settings.stations) {
    const auto wish = nextHandEyeView(truth, kPlate, poses, reachable);
    if (!wish || static_cast<int>(poses.size()) > settings.stations + kMostMisses)
      return unexpected(std::string("the robot reaches too few views of the plate"));
    poses.push_back(wish->X_CM);
    const auto flange = carrier.goTo(flangeFor(wish->X_CM));
    const auto view = studio.take((flange.true_X_BF * X_FC).inverse() * X_BM, "station");
    const auto pose = view ? poseBoard(rig, kPlate, *view) : std::nullopt;
    if (pose) pairs.push_back({flange.X_BF, pose->X_CM});
  }
  auto solved = solveHandEye(pairs, calibration::CameraMount::kInHand);
  if (!solved) return unexpected("hand-eye: " + std::string(reason(solved.error())));
  return std::move(*solved);
}

}  // namespace

double TrialCalibration::handEyeError_mm() const {
  return 1e3 * (hand_eye.X_PC.translation() - true_X_FC.translation()).norm();
}

Expected<RigTrial, std::string> calibrateRigInSimulation(const std::filesystem::path& resources,
                                                         const TrialCalibrationSettings& settings) {
  using simulation::bench_layout::rigFile;
  auto rig = camera::readRig(rigFile(resources, camera::LensModel::kKannalaBrandt));
  if (!rig) return unexpected(describe(rig.error()));
  auto views = takeViews(*rig, settings);
  if (!views) return unexpected(views.error());
  const auto& lens = rig->left.intrinsics();
  auto solved = calibrateStereo(kPlate, *views, {lens.width_px, lens.height_px}, lens.model);
  if (!solved) return unexpected("stereo: " + std::string(reason(solved.error())));
  return RigTrial{std::move(*rig), kPlate, std::move(*views), std::move(*solved)};
}

Expected<TrialCalibration, std::string> calibrateInSimulation(const std::filesystem::path& resources,
                                                              const TrialCalibrationSettings& settings) {
  auto rig = calibrateRigInSimulation(resources, settings);
  if (!rig) return unexpected(rig.error());
  const auto arm = robot::readUrdf(resources / "robots/lbr4plus.urdf");
  if (!arm) return unexpected(describe(arm.error()));
  const auto hand = simulation::bench_layout::hand(resources);
  if (!hand) return unexpected(describe(hand.error()));
  auto hand_eye = calibrateHandEye(*arm, rig->true_rig, rig->stereo.rig, hand->X_FC, settings);
  if (!hand_eye) return unexpected(hand_eye.error());
  return TrialCalibration{std::move(*rig), hand->X_FC, std::move(*hand_eye)};
}

}  // namespace mirrorarm::experiments
