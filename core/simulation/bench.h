#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/camera/frame_source.h"
#include "core/camera/stereo_rig.h"
#include "core/common/file_error.h"
#include "core/common/time_source.h"
#include "core/robot/arm_description.h"
#include "core/robot/obstacle.h"
#include "core/robot/robot_link.h"
#include "core/simulation/arm_motion.h"
#include "core/simulation/line_faults.h"
#include "core/simulation/patch.h"
#include "core/simulation/ridden_robot.h"
#include "core/simulation/sling_load.h"

namespace mirrorarm::simulation {

/// Way points of a minimum-jerk movement, as therapy::Exercise gives them.
struct MinimumJerkLeg {
  Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();
  double forearm_turn_rad = 0.0;
  double duration_s = 2.0;
  double rest_s = 0.5;
};

/// A calibration plate on a stand, frame M. See bench_layout for a place that the arm reaches all round.
struct Plate {
  std::vector<Patch> patches_M;
  RigidTransform X_BM = RigidTransform::Identity();
};

struct BenchSettings {
  std::filesystem::path resources;  ///< the project's resources folder
  camera::LensModel lens = camera::LensModel::kKannalaBrandt;
  std::filesystem::path motion;           ///< a TRC file whose forearm markers carry the discs; empty: `legs`
  std::vector<MinimumJerkLeg> legs;       ///< used without `motion`
  std::shared_ptr<const ArmMotion> held;  ///< carries the discs in place of the forearm; empty: the forearm
  std::optional<Plate> plate;             ///< stands there in place of the patient
  double rate_hz = 24.0;
  Seconds exposure{0.0015};
  Seconds transfer{0.020};          ///< from the end of the exposure until the frame is handed out
  Seconds camera_clock_ahead{0.0};  ///< the frames' times are later than the truth by that
  std::uint64_t seed = 1;
  SlingArm sling_arm{};          ///< what the robot feels of the impaired arm; not where a plate stands
  bool robot_gives_way = false;  ///< like springs in its joints; else it holds its position stiffly
  bool own_pace = true;  ///< frames and states wait for the time source (real time); false: asked in lockstep
};

/// A bench that needs no hardware: LBR 4+ with stereo camera and sling on its flange, a passive impaired arm
/// in the sling, a healthy forearm with ten discs beside it; or a calibration plate in place of both arms.
/// Everything moves in one world, so the cameras see what the robot does. Another robot may carry the hand in
/// place of the simulated one: then the world rides on what that one measures. Cameras and robot are used
/// from their own threads; truth and faults from any.
class Bench {
 public:
  /// `time` outlives the bench; with a robot from outside it is the steady clock. Refused: missing or wrong
  /// resources, a TRC that lacks forearm markers.
  [[nodiscard]] static FromFile<std::unique_ptr<Bench>> make(const BenchSettings& settings,
                                                             const TimeSource& time,
                                                             std::unique_ptr<RiddenRobot> ridden = nullptr);
  ~Bench();

  [[nodiscard]] camera::FrameSource& cameras();
  [[nodiscard]] robot::RobotLink& robot();
  [[nodiscard]] const camera::StereoRig& rig() const;
  [[nodiscard]] const robot::ArmDescription& arm() const;
  [[nodiscard]] const RigidTransform& X_FC() const;  ///< camera on the flange
  [[nodiscard]] const RigidTransform& X_FE() const;  ///< sling on the flange
  /// Camera bar and sling, fixed to the flange.
  [[nodiscard]] const std::vector<robot::Capsule>& attached() const;
  /// Table and patient's head.
  [[nodiscard]] const std::vector<robot::Obstacle>& surroundings() const;

  /// The simulated patient moves the healthy arm while true; starting and stopping are smooth. Any thread.
  void setPatientMoving(bool moving);

  /// The share of the impaired arm's weight that the patient carries himself, 0 to 1; nothing at first. Any
  /// thread, as below. No effect where a plate stands, or on a robot from outside.
  void setPatientEffort(double share);
  /// A push on the sling besides; stays until the next one.
  void pushSling(const Eigen::Vector3d& force_B_n);

  /// What is truly there at one time.
  struct Truth {
    std::vector<Disc> discs;      ///< of the healthy forearm; none where a plate stands
    RigidTransform X_BF;          ///< flange
    ArmMotion::Forearm healthy;   ///< both forearms are of no meaning where a plate stands
    ArmMotion::Forearm impaired;  ///< wrist in the sling, elbow beside the body
  };
  [[nodiscard]] Truth truthAt(TimePoint time) const;

  /// Faults, for tests and for the start-of-day check. Those of the robot are the simulated one's. Any
  /// thread.
  void failCameras(bool failed);
  void hideTarget(bool hidden);  ///< or the plate
  void silenceRobot(bool silent);
  void disturbRobotLine(const LineFaults& faults);

 private:
  struct Body;
  explicit Bench(std::unique_ptr<Body> body);
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::simulation
