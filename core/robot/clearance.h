#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/robot/arm_description.h"
#include "core/robot/capsule_distance.h"
#include "core/robot/motion_guard.h"
#include "core/robot/obstacle.h"

namespace mirrorarm::robot {

struct ClearanceSettings {
  double self_m = 0.010;      ///< the arm comes no nearer to itself
  double obstacle_m = 0.020;  ///< nor to an obstacle
  double look_m = 0.120;      ///< what is farther off is not looked at: more than any stop takes
  /// Near the head the tool goes at most at this speed; it does from this distance of any part of the arm
  /// from the head on, and farther out as fast as it may be to have braked gently by then.
  double head_speed_m_s = 0.13;
  double head_near_m = 0.10;
  double head_braking_m_s2 = 0.25;
};

/// Two things that are near each other.
struct ClearancePair {
  int shape = -1;     ///< of the arm's shapes, then the attached ones
  int other = -1;     ///< a shape; -1 for an obstacle
  int obstacle = -1;  ///< an obstacle; -1 for a shape
};

/// How near the parts of one arm are to each other and to obstacles: the rows that the motion guard wants.
/// The same pairs as CollisionWorld looks at, but for those that the arm's build keeps within `self_m` of
/// each other in most postures: for these the joint ranges must see. What no joint changes has no row.
/// Distances are exact. No call allocates; one thread, it keeps work space.
class Clearance {
 public:
  static constexpr int kMostRows = 16;  ///< of each posture, the nearest

  /// Looks at nothing.
  Clearance() = default;
  /// `attached` are shapes fixed to the last link: camera bar, sling.
  Clearance(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> obstacles,
            const ClearanceSettings& settings = {});

  /// Rows at `here`, then those at `at_rest`, where the arm would come to rest: the first hold for what is
  /// round a bend, the second for what lies ahead. Good until the next call.
  std::span<const ClearanceRow> rows(const Joints& here, const Joints& at_rest) noexcept;
  /// What a row of the last call is about.
  [[nodiscard]] const ClearancePair& pair(int row) const { return pairs_[static_cast<std::size_t>(row)]; }
  /// Cap on the tool for the postures of the last call; infinite far from every head.
  [[nodiscard]] double zoneSpeed() const noexcept;

  /// Least distance there between any two of its pairs, negative where they overlap; infinite where all are
  /// farther apart than `look_m`.
  [[nodiscard]] double least(const Joints& q) noexcept;

 private:
  struct Shape {
    Capsule capsule;
    double reach_m = 0.0;  ///< of the ball around it
    Segment segment{};     ///< where it is now
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  };
  struct Frame {
    Eigen::Vector3d axis, origin;  ///< of a joint, in base frame
  };
  /// One pair at one posture.
  struct Found {
    double distance_m;
    Nearest nearest;
    ClearancePair pair;
  };

  void place(const Joints& q) noexcept;
  void leaveOutWhatIsAlwaysNear();
  void search() noexcept;
  void searchSelf(const ClearancePair& pair) noexcept;
  void searchObstacle(const ClearancePair& pair) noexcept;
  void keep(const Found& found) noexcept;
  void addRows(bool at_rest) noexcept;
  [[nodiscard]] ClearanceRow rowOf(const Found& found, bool at_rest) const noexcept;

  ArmDescription arm_;
  std::vector<Shape> shapes_;
  std::vector<Obstacle> obstacles_;
  std::vector<ClearancePair> watched_;
  ClearanceSettings settings_;
  std::array<Frame, kMaxJoints> frames_{};
  std::array<Found, kMostRows> found_;
  int found_count_ = 0;
  double head_m_ = std::numeric_limits<double>::infinity();
  std::array<ClearanceRow, 2 * static_cast<std::size_t>(kMostRows)> rows_;
  std::array<ClearancePair, 2 * static_cast<std::size_t>(kMostRows)> pairs_;
  int row_count_ = 0;
};

}  // namespace mirrorarm::robot
