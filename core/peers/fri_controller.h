#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/common/time.h"
#include "core/devices/fri_datagram.h"
#include "core/devices/fri_settings.h"
#include "core/robot/kinematics.h"
#include "core/simulation/joint_drives.h"

namespace mirrorarm::peers {

/// How a simulated KRC2 lr with an LBR 4+ behaves. What the maker does not publish is assumed: the thresholds
/// of the quality (shares of answers in time among the last 100) and the times.
struct FriControllerSettings {
  Seconds period{0.001};
  devices::FriHandshake handshake{};
  double perfect_share = 0.98;
  double ok_share = 0.90;
  double bad_share = 0.50;
  int bridged_in_a_row = 1;    ///< missed answers that are extrapolated while it takes commands
  Seconds start_delay{0.1};    ///< of its program, from a request to friStart
  double safety_factor = 1.0;  ///< on the joints' speeds, as given to friStart
  double mirror_tolerance_rad = 1e-4;
};

/// Why it went back to monitoring, or did not start.
enum class FriControllerFall : std::uint8_t {
  kStopped,        ///< because the host asked for it
  kMissedAnswers,  ///< more in a row than it bridges
  kPoorQuality,
  kJump,                ///< beyond the joints' speeds
  kLimit,               ///< beyond the joints' ranges
  kFlags,               ///< changed while it takes commands, or without joint positions
  kDrives,              ///< off or in error
  kInterpolationError,  ///< the host did not mirror when it was to start
};
/// "stopped", "missed_answers", ...
[[nodiscard]] std::string_view id(FriControllerFall fall);

struct FriControllerReport {
  std::uint64_t cycles = 0;
  std::uint64_t in_time = 0;
  std::uint64_t missed = 0;  ///< datagrams without an answer before the next one was due
  std::uint64_t late = 0;    ///< answers to earlier datagrams
  std::uint64_t doubled = 0;
  std::uint64_t out_of_order = 0;
  std::uint64_t refused = 0;
  std::uint64_t mirror_errors = 0;
  std::uint64_t starts = 0;
  struct Fall {
    double time_s = 0.0;  ///< since its first cycle
    FriControllerFall why = FriControllerFall::kStopped;
  };
  std::vector<Fall> falls;                   ///< the first thousand
  std::vector<std::uint64_t> missed_cycles;  ///< counted from 1 as the sequences are; the first 100 000
};

/// The controller's side of the Fast Research Interface without its socket, with the program that runs on it
/// and the arm. A cycle is cycle(), then answer() for what comes before the next. One thread.
class FriController {
 public:
  /// `arm` has seven joints and rests at `start`.
  FriController(const robot::ArmDescription& arm, const robot::Joints& start,
                const FriControllerSettings& settings);

  /// Judges the answers since the last cycle, moves the arm by a period, and says what to send.
  [[nodiscard]] const devices::FriMeasurement& cycle(TimePoint now);
  /// What came from the host.
  void answer(std::span<const std::byte> bytes, TimePoint arrived_at);

  /// Drives in error are off; 0 mends them.
  void failDrives(std::uint16_t drives) { drive_errors_ = drives; }
  /// Tells no better quality than this, and acts on it.
  void limitQuality(devices::FriQuality best) { best_quality_ = best; }
  /// Tells commanded angles that are so far from the measured ones.
  void misplaceHold(double angle_rad) { misplaced_rad_ = angle_rad; }

  [[nodiscard]] devices::FriState state() const { return state_; }
  [[nodiscard]] devices::FriQuality quality() const { return quality_; }
  [[nodiscard]] const robot::Joints& q() const { return drives_.q(); }
  [[nodiscard]] const robot::Joints& v() const { return drives_.v(); }
  [[nodiscard]] const FriControllerReport& report() const { return report_; }

 private:
  void moveArm();
  void judgeAnswer();
  void judgeQuality();
  void monitor();
  void heed(const devices::FriVariables& wishes);
  void start();
  void obey();
  void follow(const devices::FriCommand& answer);
  void fall(FriControllerFall why);
  void describe();
  [[nodiscard]] robot::Joints held() const;

  const FriControllerSettings settings_;
  robot::Joints lower_rad_, upper_rad_, max_speed_rad_s_;
  robot::Kinematics kinematics_;
  simulation::JointDrives drives_;

  devices::FriState state_ = devices::FriState::kMonitor;
  devices::FriQuality quality_ = devices::FriQuality::kUnacceptable;
  devices::FriQuality best_quality_ = devices::FriQuality::kPerfect;
  devices::FriControl control_ = devices::FriControl::kPosition;
  std::uint16_t drive_errors_ = 0;
  double misplaced_rad_ = 0.0;

  TimePoint cycle_at_{};
  TimePoint arm_time_{};          ///< from 0
  devices::FriMeasurement sent_;  ///< the newest
  devices::FriCommand answer_;    ///< to it; good while `answered_`
  bool answered_ = false;
  bool heard_ = false;  ///< any answer yet
  std::uint16_t heard_sequence_ = 0;
  std::array<bool, 100> in_time_{};  ///< of the last cycles
  std::array<float, 100> latency_s_{};
  int missed_in_a_row_ = 0;

  double asked_s_ = 0.0;  ///< since the host asks for the start
  bool refused_ = false;  ///< this request; the next may succeed
  std::uint32_t flags_ = 0;
  robot::Joints base_;       ///< what the controller commands by itself
  robot::Joints commanded_;  ///< with what the host adds
  robot::Joints step_;       ///< of the last cycle
  FriControllerReport report_;
};

}  // namespace mirrorarm::peers
