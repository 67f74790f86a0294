#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/control/stop_reason.h"
#include "core/devices/fri_link.h"
#include "core/devices/real_time.h"
#include "core/peers/fri_controller_host.h"

namespace mirrorarm::benchmarks::robot {

/// Why the controller had no answer to a datagram before the next was due.
struct MissedAnswers {
  std::uint64_t unanswered = 0;  ///< ours: our thread had the datagram and answered nothing
  std::uint64_t computed = 0;    ///< ours: our thread ran and computed too long
  [[nodiscard]] std::uint64_t ours() const { return unanswered + computed; }
  std::uint64_t machine = 0;  ///< our thread, or the controller's, was not running
};

/// What a run of the servo loop over FRI against the simulated controller told.
struct FriRun {
  std::uint64_t cycles = 0;
  MissedAnswers missed;
  std::vector<double> answer_delay_us;  ///< from the datagram's arrival to our answer, a cycle each
  std::vector<double> computing_us;     ///< processor time of our thread, a cycle each
  std::vector<double> pauses_us;        ///< by which idle threads above ours in rank woke late
  std::uint64_t skipped_beats = 0;      ///< of the controller's thread
  std::vector<control::StopReason> stops;
  double first_stop_s = 0.0;                        ///< since the first cycle; 0 without one
  devices::FriFall fall = devices::FriFall::kNone;  ///< the last
  double rest_s = 0.0;                              ///< from the first stop to rest; 0 without one
  double creep_rad = 0.0;                           ///< what the arm moved after that rest
  double travelled_rad = 0.0;
  bool driving = false;   ///< at the end
  std::string real_time;  ///< what our thread was granted
};

struct FriRunOrder {
  Seconds duration{5.0};
  std::vector<peers::FriFault> faults{};
  bool resume = false;  ///< reset every stop as an operator would
  std::uint64_t seed = 1;
};

/// Runs it: controller and servo loop, a thread each, and an idle witness on each core; 1 ms a cycle, over
/// the loopback. Throws std::runtime_error where a socket or the arm's file is not to be had.
[[nodiscard]] FriRun runFriLine(const FriRunOrder& order);

}  // namespace mirrorarm::benchmarks::robot
