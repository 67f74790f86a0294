#pragma once

#include <array>
#include <limits>
#include <span>

#include "core/robot/motion_guard.h"
#include "core/robot/placed_shapes.h"

namespace mirrorarm::robot {

struct ClearanceSettings {
  SafeDistances keep{};
  double look_m = 0.120;  ///< what is farther off is not looked at: more than any stop takes
  /// Near the head the tool goes at most at this speed; it does from this distance of any part of the arm
  /// from the head on, and farther out as fast as it may be to have braked gently by then.
  double head_speed_m_s = 0.13;
  double head_near_m = 0.10;
  double head_braking_m_s2 = 0.25;
};

/// How near the parts of one arm are to each other and to obstacles: the rows that the motion guard wants.
/// Of the same pairs and the same distances as CollisionWorld's; what no joint changes has no row. No call
/// allocates; one thread, it keeps work space.
class Clearance {
 public:
  static constexpr int kMostHandPoints = 8;
  static constexpr int kMostRows = 16;  ///< of each posture, those with the least room

  /// Looks at nothing.
  Clearance() = default;
  /// `attached` are shapes fixed to the last link: camera bar, sling.
  Clearance(const ArmDescription& arm, std::span<const Capsule> attached, std::span<const Obstacle> obstacles,
            const ClearanceSettings& settings = {});

  /// Rows at `here`, then those at `at_rest`, where the arm would come to rest: the first hold for what is
  /// round a bend, the second for what lies ahead. Good until the next call.
  std::span<const ClearanceRow> rows(const Joints& here, const Joints& at_rest) noexcept;
  /// What a row of the last call is about.
  [[nodiscard]] const ShapePair& pair(int row) const { return pairs_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] ContactKinds kinds(int row) const noexcept { return shapes_.kinds(pair(row)); }
  /// Cap on the hand for the postures of the last call; infinite far from every head.
  [[nodiscard]] double zoneSpeed() const noexcept;
  /// Of the ends of what is attached to the flange, at `here` of the last call: kMostHandPoints of them at
  /// most; none so far from every head that the cap cannot matter. Good until the next call.
  [[nodiscard]] std::span<const Jacobian> hand() const noexcept;

  /// How much nearer any two may come there, negative where they are too near; infinite where all are farther
  /// apart than `look_m`.
  [[nodiscard]] double leastRoom(const Joints& q) noexcept;

 private:
  /// One pair at one posture.
  struct Found {
    ShapePair pair;
    Gap gap;
    [[nodiscard]] double room_m() const noexcept { return gap.distance_m - pair.keep_m; }
  };

  void noteHand() noexcept;
  [[nodiscard]] Jacobian jacobianOf(const Eigen::Vector3d& p_B) const noexcept;
  void search() noexcept;
  [[nodiscard]] bool isHead(const ShapePair& pair) const noexcept;
  void keep(const Found& found) noexcept;
  void addRows(bool at_rest) noexcept;
  [[nodiscard]] ClearanceRow rowOf(const Found& found, bool at_rest) const noexcept;

  PlacedShapes shapes_;
  ClearanceSettings settings_;
  std::array<Found, kMostRows> found_;
  int found_count_ = 0;
  double head_m_ = std::numeric_limits<double>::infinity();
  std::array<ClearanceRow, 2 * static_cast<std::size_t>(kMostRows)> rows_;
  std::array<ShapePair, 2 * static_cast<std::size_t>(kMostRows)> pairs_;
  int row_count_ = 0;
  std::array<Jacobian, static_cast<std::size_t>(kMostHandPoints)> hand_;
  int hand_count_ = 0;
};

}  // namespace mirrorarm::robot
