#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "benchmarks/parallel.h"
#include "benchmarks/robot/bench_arm.h"
#include "benchmarks/robot/suite.h"
#include "benchmarks/timing.h"
#include "core/robot/clearance.h"
#include "tests/robot/guard_mischief.h"
#include "tests/robot/guard_wire.h"

namespace mirrorarm::benchmarks::robot {
namespace {

using namespace mirrorarm::robot;
using mirrorarm::robot::testing::Mischief;
using mirrorarm::robot::testing::WireWatch;
using mirrorarm::robot::testing::WireWorst;

constexpr double kPeriod_s = 0.001;
constexpr int kCyclesATrial = 10'000;
constexpr int kCyclesAKind = 500;
constexpr double kRounding = 1.0 + 1e-5;
constexpr double kWayRounding = 1e-6;

/// A table, a box beside the arm and a head.
std::vector<Obstacle> room() {
  const auto at = [](double x, double y, double z) {
    return makeTransform(Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, y, z));
  };
  return {{at(0.7, 0.0, 0.0), {0.8, 1.2, 0.04}, ObstacleKind::kTable, "table"},
          {at(0.35, 0.65, 0.3), {0.3, 0.2, 0.6}, ObstacleKind::kBox, "box"},
          ball(ObstacleKind::kHead, {0.75, -0.35, 0.75}, 0.15)};
}

/// What went past which limit.
struct Tally {
  long cycles = 0;
  long past = 0;
  long trimmed = 0;
  WireWorst worst;
  double least_gap_m = 1e9;  ///< over what the settings ask
  double zone_speed = 0.0;   ///< share of the cap, where it holds in full
  std::vector<double> call_us;

  void add(const Tally& other) {
    cycles += other.cycles;
    past += other.past;
    trimmed += other.trimmed;
    mirrorarm::robot::testing::worsen(worst, other.worst);
    least_gap_m = std::min(least_gap_m, other.least_gap_m);
    zone_speed = std::max(zone_speed, other.zone_speed);
    call_us.insert(call_us.end(), other.call_us.begin(), other.call_us.end());
  }
};

/// One arm under the guard, started anew at random postures.
/// The fastest end of what the hand carries.
class HandWatch {
 public:
  HandWatch(const Kinematics& kinematics, const std::vector<Capsule>& attached)
      : kinematics_(kinematics), attached_(attached) {}

  /// In the cycle that led to `q` [m/s].
  double look(const Joints& q) {
    const RigidTransform X_BL = kinematics_.link(q, static_cast<int>(q.size()));
    double fastest = 0.0;
    for (std::size_t i = 0; i < attached_.size(); ++i) {
      const std::array<Eigen::Vector3d, 2> ends{X_BL * attached_[i].a, X_BL * attached_[i].b};
      if (before_.size() == i) before_.push_back(ends);
      for (std::size_t end = 0; end < ends.size(); ++end)
        fastest = std::max(fastest, (ends[end] - before_[i][end]).norm() / kPeriod_s);
      before_[i] = ends;
    }
    return fastest;
  }

 private:
  const Kinematics& kinematics_;
  const std::vector<Capsule>& attached_;
  std::vector<std::array<Eigen::Vector3d, 2>> before_;
};

class Trial {
 public:
  explicit Trial(bool in_room)
      : in_room_(in_room),
        attached_(handOn(arm_)),
        clearance_(in_room ? Clearance(arm_, attached_, room()) : Clearance()),
        watched_(clearance_) {}

  void run(int trial, Tally& tally) {
    Mischief mischief(static_cast<unsigned>(trial) + 1U);
    last_ = restAt(freePosture(trial));
    watch_.restart(last_.q_rad);
    hand_watch_.look(last_.q_rad);
    for (int cycle = 0; cycle < kCyclesATrial; ++cycle) {
      if (cycle % kCyclesAKind == 0)
        mischief.choose(static_cast<Mischief::Kind>((trial + cycle / kCyclesAKind) % Mischief::kKinds), 7);
      const Jacobian J = kinematics_.jacobian(last_.q_rad);
      step(mischief.wishOf(cycle, last_, J, kPeriod_s, limits_), J, tally);
      look(tally);
    }
  }

 private:
  Joints freePosture(int trial) {
    std::mt19937 random(static_cast<unsigned>(trial));
    for (;;) {
      Joints q(7);
      for (Eigen::Index j = 0; j < 7; ++j)
        q[j] = std::uniform_real_distribution<double>(limits_.lower_rad[j], limits_.upper_rad[j])(random);
      if (!in_room_ || clearance_.leastRoom(q) > 0.01) return q;
    }
  }

  void step(const MotionState& wish, const Jacobian& J, Tally& tally) {
    const TimePoint start = Clock::now();
    const auto rows = clearance_.rows(last_.q_rad, restOf(last_, kPeriod_s));
    const Surroundings around{J, rows, clearance_.zoneSpeed(), clearance_.hand()};
    const Guarded guarded = guardMotion(wish, last_, around, kPeriod_s, limits_);
    if (tally.cycles % 100 == 0) tally.call_us.push_back(1e6 * secondsBetween(start, Clock::now()));
    if (guarded.action != GuardAction::kPassed) ++tally.trimmed;
    last_ = guarded.command;
  }

  void look(Tally& tally) {
    const WireWorst now = watch_.look(last_.q_rad);
    mirrorarm::robot::testing::worsen(tally.worst, now);
    bool past = !last_.q_rad.allFinite() || now.position_rad > kWayRounding || now.speed > kRounding ||
                now.acceleration > kRounding || now.jerk > kRounding || now.tool_speed > kRounding ||
                now.tool_acceleration > kRounding;
    const double hand_m_s = hand_watch_.look(last_.q_rad);
    for (const ClearanceRow& row : watched_.rows(last_.q_rad, last_.q_rad)) {
      tally.least_gap_m = std::min(tally.least_gap_m, row.distance_m - row.minimum_m);
      past = past || row.distance_m < row.minimum_m - kWayRounding;
    }
    if (watched_.zoneSpeed() <= ClearanceSettings{}.head_speed_m_s) {
      const double share = std::max(watch_.toolSpeed(), hand_m_s) / ClearanceSettings{}.head_speed_m_s;
      tally.zone_speed = std::max(tally.zone_speed, share);
      past = past || share > kRounding;
    }
    ++tally.cycles;
    if (past) ++tally.past;
  }

  bool in_room_;
  ArmDescription arm_ = lbr();
  std::vector<Capsule> attached_;
  MotionLimits limits_ = *limitsOf("therapy", arm_);
  Kinematics kinematics_{arm_};
  Clearance clearance_, watched_;
  WireWatch watch_{arm_, limits_, kPeriod_s};
  HandWatch hand_watch_{kinematics_, attached_};
  Commanded last_;
};

Tally runAll(int trials, bool in_room) {
  Tally sum;
  std::mutex guard;  // of sum
  forEachTrial(trials, [&] {
    return [&, arm = std::make_shared<Trial>(in_room)](int trial) {
      Tally tally;
      arm->run(trial, tally);
      const std::scoped_lock lock(guard);
      sum.add(tally);
    };
  });
  return sum;
}

Row rowOf(const std::string& name, const Tally& tally) {
  Row row{"",
          name,
          "none past a limit",
          {{"past a limit", static_cast<double>(tally.past), ""},
           {"cycles", static_cast<double>(tally.cycles), ""},
           {"trimmed", static_cast<double>(tally.trimmed), ""}},
          {{"worst jerk", tally.worst.jerk, "of its limit"},
           {"acceleration", tally.worst.acceleration, ""},
           {"speed", tally.worst.speed, ""},
           {"beyond a range", 1e3 * tally.worst.position_rad, "mrad"},
           {"tool speed", tally.worst.tool_speed, ""},
           {"tool acceleration", tally.worst.tool_acceleration, ""}},
          tally.past == 0};
  if (tally.least_gap_m < 1e8) {
    row.references.push_back({"least gap over the one asked for", 1e3 * tally.least_gap_m, "mm"});
    row.references.push_back({"tool speed near the head", tally.zone_speed, "of 0.13 m/s"});
  }
  return row;
}

Row timeOf(const std::string& name, const Tally& tally) {
  return {"",
          name,
          "<= 50 us median",
          {{"median", quantile(tally.call_us, 0.5), "us"}, {"p99", quantile(tally.call_us, 0.99), "us"}},
          {},
          quantile(tally.call_us, 0.5) <= 50.0};
}

}  // namespace

void measureGuard(Run& run) {
  const int trials = run.trials(500, 2);
  const Tally free = runAll(trials, false), in_room = runAll(trials, true);
  run.report.rows.push_back(rowOf("adversarial wishes, free arm", free));
  run.report.rows.push_back(rowOf("adversarial wishes among table, box and head", in_room));
  run.report.rows.push_back(timeOf("one call of the guard", free));
  run.report.rows.push_back(timeOf("one call with its clearances", in_room));
}

}  // namespace mirrorarm::benchmarks::robot
