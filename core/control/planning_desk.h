#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "core/common/latest_value.h"
#include "core/common/signal.h"
#include "core/control/gaze.h"
#include "core/robot/planner.h"

namespace mirrorarm::control {

/// A way around something is asked for.
struct PlanQuestion {
  std::uint64_t number = 0;  ///< counts the questions
  robot::Joints from{};
  robot::Joints to{};
  std::optional<Sight> sight{};  ///< to be kept in view on the way
};

/// The way, or why there is none. Fixed size: it goes through a mailbox.
struct PlanAnswer {
  std::uint64_t number = 0;  ///< of the question
  std::array<robot::Joints, robot::PlannedPath::kMostWaypoints> waypoints{};
  std::size_t waypoint_count = 0;
  std::optional<robot::PlanRefusal> refusal{};

  [[nodiscard]] std::span<const robot::Joints> path() const { return {waypoints.data(), waypoint_count}; }
};

/// Whether the cameras on the hand see something from a posture.
using SightRule = std::function<bool(const robot::Joints& q, const Sight& sight)>;

/// Where the control thread lays questions and the planning thread answers them. Neither waits for the other;
/// the newest question replaces one that was not taken yet.
class PlanningDesk {
 public:
  /// Without `sees` the sight of a question is of no account.
  explicit PlanningDesk(robot::Planner planner, SightRule sees = {})
      : planner_(std::move(planner)), sees_(std::move(sees)) {}

  /// Control thread.
  void ask(const PlanQuestion& question, TimePoint now) {
    open_ = Open{question.number, now};
    questions_.put(question);
    asked_.notify();
  }
  /// Control thread. Nullptr while nothing new has come; good until the next call.
  [[nodiscard]] const PlanAnswer* takeAnswer() noexcept {
    const PlanAnswer* const answer = answers_.take();
    if (answer && open_ && answer->number == open_->number) open_.reset();
    return answer;
  }
  /// Control thread. An answer is not waited for any more.
  void withdraw() noexcept { open_.reset(); }
  /// Control thread. How long the newest question has been waiting; 0 when it was answered.
  [[nodiscard]] Seconds waiting(TimePoint now) const noexcept {
    return open_ ? Seconds(now - open_->since) : Seconds(0.0);
  }

  /// Planning thread: answers the newest question, if there is one. Takes as long as planning does.
  void answer();
  /// The same, once there is one; waits so long for it at most.
  void awaitAndAnswer(Seconds longest) {
    if (asked_.waitFor(longest)) answer();
  }

 private:
  struct Open {
    std::uint64_t number = 0;
    TimePoint since{};
  };
  std::optional<Open> open_;  // control thread only
  robot::Planner planner_;    // planning thread only
  SightRule sees_;            // planning thread only
  Signal asked_;
  LatestValue<PlanQuestion> questions_;
  LatestValue<PlanAnswer> answers_;
};

}  // namespace mirrorarm::control
