#include "core/simulation/bench.h"

#include <atomic>
#include <mutex>
#include <optional>

#include "core/camera/rig_file.h"
#include "core/robot/kinematics.h"
#include "core/simulation/bench_layout.h"
#include "core/simulation/exercise_motion.h"
#include "core/simulation/movement_phase.h"
#include "core/simulation/recorded_motion.h"
#include "core/simulation/simulated_cameras.h"
#include "core/simulation/simulated_robot.h"

namespace mirrorarm::simulation {
namespace {

constexpr std::uint64_t kRobotStream = 0x526F626F74u;

/// Forward kinematics for several threads.
class SharedKinematics {
 public:
  explicit SharedKinematics(robot::Kinematics kinematics) : kinematics_(std::move(kinematics)) {}
  [[nodiscard]] RigidTransform flange(const robot::Joints& q) const {
    const std::lock_guard lock(mutex_);
    return kinematics_.flange(q);
  }

 private:
  mutable std::mutex mutex_;
  robot::Kinematics kinematics_;  ///< guarded by mutex_
};

/// None where a plate stands in place of the patient.
FromFile<std::shared_ptr<const ArmMotion>> makeMotion(const BenchSettings& settings,
                                                      const camera::StereoRig& rig) {
  if (settings.plate) return std::shared_ptr<const ArmMotion>();
  if (settings.held) return settings.held;
  const RigidTransform X_BC = bench_layout::startX_BC();
  const RigidTransform X_BA = X_BC * bench_layout::startX_CA();
  if (settings.motion.empty()) return std::make_shared<ExerciseMotion>(X_BA, settings.legs);
  auto recorded = RecordedMotion::read(settings.motion, X_BA,
                                       {X_BC.translation(), (X_BC * rig.X_RC.inverse()).translation()});
  if (!recorded) return unexpected(recorded.error());
  return std::make_shared<RecordedMotion>(std::move(*recorded));
}

SimulatedRobotSettings robotSettings(const BenchSettings& settings, const RigidTransform& X_FE) {
  SimulatedRobotSettings robot;
  robot.seed = settings.seed ^ kRobotStream;
  robot.gives_way = settings.robot_gives_way;
  if (!settings.plate) robot.load = settings.sling_arm;
  robot.p_FE_F = X_FE.translation();
  return robot;
}

}  // namespace

struct Bench::Body {
  const TimeSource& time;
  camera::StereoRig rig;
  robot::ArmDescription arm;
  robot::Hand hand;
  std::vector<robot::Capsule> attached;
  std::vector<robot::Obstacle> surroundings;
  std::vector<Patch> clutter_B = bench_layout::clutter();
  std::shared_ptr<const ArmMotion> motion;  ///< none where a plate stands
  std::vector<Patch> plate_B;
  SharedKinematics kinematics;
  std::unique_ptr<RiddenRobot> ridden;
  std::optional<SimulatedRobot> own_robot;  ///< where none is ridden
  SimulatedCameras cameras;
  MovementPhase phase;
  std::atomic<bool> target_hidden{false};
  std::vector<Disc> seen_discs;  ///< work space of the cameras' thread

  struct Parts {
    camera::StereoRig rig;
    robot::ArmDescription arm;
    robot::Hand hand;
    std::vector<robot::Obstacle> surroundings;
    std::shared_ptr<const ArmMotion> motion;
    robot::Joints start;
    std::unique_ptr<RiddenRobot> ridden;
  };
  Body(Parts parts, robot::Kinematics forward, const BenchSettings& settings, const TimeSource& time_source)
      : time(time_source),
        rig(std::move(parts.rig)),
        arm(std::move(parts.arm)),
        hand(std::move(parts.hand)),
        attached(attachedTo(arm, hand)),
        surroundings(std::move(parts.surroundings)),
        motion(std::move(parts.motion)),
        kinematics(std::move(forward)),
        ridden(std::move(parts.ridden)),
        cameras(
            rig, {}, {},
            {settings.rate_hz, settings.exposure, settings.transfer, settings.own_pace,
             settings.camera_clock_ahead},
            [this](TimePoint at, StereoRenderer::Instant& patches_C) { look(at, patches_C); }, time_source,
            settings.seed),
        seen_discs(static_cast<std::size_t>(motion ? motion->discCount() : 0)) {
    if (!ridden) own_robot.emplace(arm, parts.start, time_source, robotSettings(settings, hand.X_FE));
    if (!settings.plate) return;
    for (const Patch& patch_M : settings.plate->patches_M)
      plate_B.push_back(transformed(settings.plate->X_BM, patch_M));
  }

  [[nodiscard]] RigidTransform flangeAt(TimePoint at) const {
    return kinematics.flange(ridden ? ridden->jointsAt(at) : own_robot->jointsAt(at));
  }

  [[nodiscard]] SlingLoad* load() { return own_robot ? own_robot->load() : nullptr; }

  void look(TimePoint at, StereoRenderer::Instant& patches_C) {
    const RigidTransform X_CB = (flangeAt(at) * hand.X_FC).inverse();
    patches_C.clear();
    for (const Patch& patch_B : clutter_B) patches_C.push_back(transformed(X_CB, patch_B));
    if (target_hidden.load(std::memory_order_relaxed)) return;
    for (const Patch& patch_B : plate_B) patches_C.push_back(transformed(X_CB, patch_B));
    if (!motion) return;
    motion->discsAt(phase.at(at), seen_discs);
    for (const Disc& disc_B : seen_discs) patches_C.push_back(transformed(X_CB, patchOf(disc_B)));
  }
};

FromFile<std::unique_ptr<Bench>> Bench::make(const BenchSettings& settings, const TimeSource& time,
                                             std::unique_ptr<RiddenRobot> ridden) {
  auto rig = camera::readRig(bench_layout::rigFile(settings.resources, settings.lens));
  if (!rig) return unexpected(rig.error());
  auto arm = bench_layout::arm(settings.resources);
  if (!arm) return unexpected(arm.error());
  auto hand = bench_layout::hand(settings.resources);
  if (!hand) return unexpected(hand.error());
  auto surroundings = bench_layout::surroundings(settings.resources);
  if (!surroundings) return unexpected(surroundings.error());
  auto motion = makeMotion(settings, *rig);
  if (!motion) return unexpected(motion.error());
  robot::Kinematics kinematics(*arm);
  const auto start = bench_layout::startPosture(kinematics);
  if (!start)
    return unexpected(
        FileError{settings.resources, 0, "holds an arm that does not reach the bench's start pose"});
  Body::Parts parts{std::move(*rig),    std::move(*arm), std::move(*hand), std::move(*surroundings),
                    std::move(*motion), *start,          std::move(ridden)};
  auto body = std::make_unique<Body>(std::move(parts), std::move(kinematics), settings, time);
  return std::unique_ptr<Bench>(new Bench(std::move(body)));
}

Bench::Bench(std::unique_ptr<Body> body) : body_(std::move(body)) {}
Bench::~Bench() = default;

camera::FrameSource& Bench::cameras() { return body_->cameras; }
robot::RobotLink& Bench::robot() {
  if (body_->ridden) return *body_->ridden;
  return *body_->own_robot;
}
const camera::StereoRig& Bench::rig() const { return body_->rig; }
const robot::ArmDescription& Bench::arm() const { return body_->arm; }
const RigidTransform& Bench::X_FC() const { return body_->hand.X_FC; }
const RigidTransform& Bench::X_FE() const { return body_->hand.X_FE; }
const std::vector<robot::Capsule>& Bench::attached() const { return body_->attached; }
const std::vector<robot::Obstacle>& Bench::surroundings() const { return body_->surroundings; }

void Bench::setPatientMoving(bool moving) { body_->phase.set(body_->time.now(), moving); }

Bench::Truth Bench::truthAt(TimePoint time) const {
  Truth truth;
  truth.X_BF = body_->flangeAt(time);
  if (!body_->motion) return truth;
  const double phase_s = body_->phase.at(time);
  truth.discs.resize(static_cast<std::size_t>(body_->motion->discCount()));
  body_->motion->discsAt(phase_s, truth.discs);
  truth.healthy = body_->motion->forearmAt(phase_s);
  truth.impaired = bench_layout::impairedForearm((truth.X_BF * body_->hand.X_FE).translation());
  return truth;
}

void Bench::failCameras(bool failed) { body_->cameras.fail(failed); }
void Bench::hideTarget(bool hidden) { body_->target_hidden.store(hidden, std::memory_order_relaxed); }
void Bench::silenceRobot(bool silent) {
  if (body_->own_robot) body_->own_robot->silence(silent);
}
void Bench::disturbRobotLine(const LineFaults& faults) {
  if (body_->own_robot) body_->own_robot->disturbLine(faults);
}

void Bench::setPatientEffort(double share) {
  if (SlingLoad* const load = body_->load()) load->setEffort(share);
}
void Bench::pushSling(const Eigen::Vector3d& force_B_n) {
  if (SlingLoad* const load = body_->load()) load->push(force_B_n);
}

}  // namespace mirrorarm::simulation
