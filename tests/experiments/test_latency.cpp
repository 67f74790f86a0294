#include <cmath>

#include <gtest/gtest.h>

#include "core/experiments/latency.h"

namespace mirrorarm::experiments {
namespace {

TEST(HeldMoves, BeginAndEndAtRest) {
  for (const MoveProfile profile : {MoveProfile::kMinimumJerk, MoveProfile::kTrapezoid}) {
    const auto moves = movesToAndFro(profile, 8, 2.0, 1);
    EXPECT_EQ(shiftAt(moves, 1.9).norm(), 0.0);
    for (const HeldMove& move : moves) {
      EXPECT_EQ(move.wayAt(move.start_s), 0.0);
      EXPECT_NEAR(move.wayAt(move.end_s()), move.shift_m.norm(), 1e-12);
      EXPECT_LT(move.wayAt(move.start_s + 0.01), 1e-4) << "no jump";
      EXPECT_NEAR(move.wayAt(0.5 * (move.start_s + move.end_s())), 0.5 * move.shift_m.norm(), 1e-12);
    }
    EXPECT_LT(shiftAt(moves, moves.back().end_s()).norm(), 1e-12) << "to and fro";
  }
}

TEST(Latency, TheTimeOfAWayIsInterpolated) {
  const std::vector<FollowMoment> moments = {{.time_s = 0.0},
                                             {.time_s = 0.1, .target_m = Eigen::Vector3d(0.0, 0.0, 0.002)}};
  const auto way = [](const FollowMoment& moment) { return moment.target_m.z(); };
  EXPECT_NEAR(timeOfWay(moments, 0.0, 0.001, way), 0.05, 1e-12);
  EXPECT_TRUE(std::isnan(timeOfWay(moments, 0.0, 0.003, way)));
}

TEST(Latency, ThePapersSchemeMovesWithoutJumpsAndAfterTheTarget) {
  const auto result = measureLatency(RESOURCES, MoveProfile::kMinimumJerk, 2, 3);
  ASSERT_TRUE(result) << result.error();
  const auto& moments = result->paper_moments;
  double fastest_m_s = 0.0;
  for (std::size_t i = 1; i < moments.size(); ++i)
    fastest_m_s = std::max(fastest_m_s, (moments[i].tool_m - moments[i - 1].tool_m).norm() /
                                            (moments[i].time_s - moments[i - 1].time_s));
  EXPECT_LT(fastest_m_s, 0.25) << "a jump";
  const WayOf target = wayAlong(result->moves[0].move, result->run.moments, &FollowMoment::target_m);
  const WayOf tool = wayAlong(result->moves[0].move, moments, &FollowMoment::tool_m);
  EXPECT_GT(timeOfWay(moments, 0.0, kOnset_m, tool), timeOfWay(result->run.moments, 0.0, kOnset_m, target));
}

// Wider than what is aimed at: four moves only.
TEST(Latency, TheWholeProgramAnswersSoonerThanThePapers) {
  const auto result = measureLatency(RESOURCES, MoveProfile::kMinimumJerk, 4, 3);
  ASSERT_TRUE(result) << result.error();
  EXPECT_LT(result->onset.worst_ms, 130.0);
  EXPECT_GT(result->onset.worst_ms, 0.0);
  EXPECT_LT(result->lag_at_50mm.worst_ms, 60.0);
  EXPECT_GT(result->paper_onset.mean_ms, 1.3 * result->onset.mean_ms);
  EXPECT_NEAR(result->chain.arm, 23.0, 4.0) << "the simulated drives: 10 ms late, 13 ms lag";
}

TEST(Latency, ASwingIsFollowedWithinMillimetres) {
  const auto swings = measureSwing(RESOURCES, 8.0, 3);
  ASSERT_TRUE(swings) << swings.error();
  EXPECT_LT((*swings)[1].rms_error_mm, 2.0);
  EXPECT_LT((*swings)[2].rms_error_mm, 2.0);
}

}  // namespace
}  // namespace mirrorarm::experiments
