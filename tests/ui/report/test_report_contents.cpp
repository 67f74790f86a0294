#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/ui/report/synthetic_record.h"
#include "ui/report/course_envelope.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_layout.h"
#include "ui/report/report_words.h"

namespace mirrorarm::ui {
namespace {

ReportContents contentsOf(const SyntheticRecord& record) {
  return *reportContents(*record.store, record.session);
}

TEST(ReportContents, TellWhatWasRecorded) {
  const SyntheticRecord record;
  const auto contents = contentsOf(record);
  EXPECT_EQ(contents.patient_code, "P-0042");
  EXPECT_EQ(contents.impaired_side, "left");
  EXPECT_FALSE(contents.is_cut_off);
  EXPECT_NEAR(contents.duration_s, SyntheticRecord::kSeconds, 0.1);
  EXPECT_NEAR(contents.session.measures.lag_ms, 140.0, 5.0);
  EXPECT_EQ(contents.events.size(), 5u);
  ASSERT_EQ(contents.rests.size(), 2u);
  EXPECT_NEAR(contents.rests[1].from_s, 70.0, 0.05);
  EXPECT_NEAR(contents.rests[1].to_s, 80.0, 0.05);
}

TEST(ReportContents, CoursesBeginAtTrainingAndBreakWhereTheArmWasLost) {
  const SyntheticRecord record;
  const auto courses = contentsOf(record).courses;
  const auto start = static_cast<std::size_t>(5.0 * SyntheticRecord::kRate_hz);
  EXPECT_NEAR(courses.healthy_mm[0][start], 0.0, 1e-9);
  EXPECT_NEAR(*std::ranges::min_element(courses.impaired_mm[0]), -100.0, 0.5);
  const auto lost = static_cast<std::size_t>(71.0 * SyntheticRecord::kRate_hz);
  EXPECT_TRUE(std::isnan(courses.healthy_mm[0][lost]));
  EXPECT_TRUE(std::isnan(courses.rms_mm[lost]));
  EXPECT_FALSE(std::isnan(courses.impaired_mm[0][lost]));
  EXPECT_EQ(courses.matched[lost], 0.0);
  EXPECT_TRUE(std::isnan(courses.goal_distance_mm.front()));
}

TEST(ReportContents, TheCloseUpLiesInTraining) {
  const SyntheticRecord record;
  const auto close_up = contentsOf(record).close_up;
  ASSERT_TRUE(close_up);
  EXPECT_NEAR(0.5 * (close_up->from_s + close_up->to_s), 37.5, 0.1);
  const SyntheticRecord brief(true, 400);
  EXPECT_FALSE(contentsOf(brief).close_up);
}

TEST(ReportContents, ASessionCutOffIsMeasuredFromItsSamples) {
  const SyntheticRecord record(false);
  const auto contents = contentsOf(record);
  EXPECT_TRUE(contents.is_cut_off);
  EXPECT_NEAR(contents.session.measures.lag_ms, 140.0, 5.0);
  EXPECT_EQ(contents.session.measures.joint_speed_ratio, 0.0);
}

TEST(ReportContents, AnEmptySessionIsNoError) {
  const SyntheticRecord record(true, 0);
  const auto contents = contentsOf(record);
  EXPECT_TRUE(contents.courses.time_s.empty());
  EXPECT_EQ(contents.duration_s, 0.0);
}

TEST(ReportContents, AStrangeSessionIsRefused) {
  const SyntheticRecord record;
  EXPECT_EQ(reportContents(*record.store, 77).error().reason, "session 77: is not in the store");
}

TEST(ReportWords, TheLagStandsBesideThePapers) {
  const SyntheticRecord record;
  auto contents = contentsOf(record);
  EXPECT_EQ(keyFigures(contents).front().value, "140");
  EXPECT_EQ(keyFigures(contents).front().remark, "paper: 318.7 ms");
  contents.session.measures.lag_ms = 0.0;
  EXPECT_EQ(keyFigures(contents).front().remark, "not determinable");
}

TEST(ReportWords, ForceAndHelpAreToldWhereTheyAreKnown) {
  const SyntheticRecord record;
  auto contents = contentsOf(record);
  const auto figure = [&](const char* label) {
    const auto figures = keyFigures(contents);
    return *std::ranges::find(figures, QString::fromLatin1(label), &KeyFigure::label);
  };
  EXPECT_EQ(figure("Largest force").remark, "not measured");
  EXPECT_EQ(figure("Mean help").remark, "robot held its position");
  contents.session.measures.force_share = 0.43;
  contents.session.measures.help_level = 0.62;
  contents.session.measures.help_adapting_share = 0.8;
  EXPECT_EQ(figure("Largest force").value, "43");
  EXPECT_EQ(figure("Mean help").value, "62");
  EXPECT_EQ(figure("Mean help").remark, "adapting 80 % of the time");
}

TEST(ReportWords, TheNameOfThePatientIsNowhere) {
  const SyntheticRecord record;
  for (const auto& fact : sessionFacts(contentsOf(record))) EXPECT_FALSE(fact.value.contains("Secret"));
}

TEST(ReportWords, UnknownIdsAreShownAsTheyAre) {
  EXPECT_EQ(eventWords("stop.target_lost"), "Stopped: the arm was out of sight");
  EXPECT_EQ(eventWords("help.adapts"), "The help adapts to the patient");
  EXPECT_EQ(eventWords("help.fixed.70"), "Help fixed at 70 %");
  EXPECT_EQ(eventWords("stop.meteorite"), "stop.meteorite");
  EXPECT_EQ(exerciseWords("dance"), "dance");
  EXPECT_EQ(clockTime(247.2), "4:07");
}

TEST(CourseEnvelope, HoldsEveryValueAndKnowsItsGaps) {
  const std::vector<double> times{0.0, 0.4, 1.0, 1.5, 3.0, 9.0}, values{1.0, -2.0, 5.0, NAN, 7.0, 99.0};
  const auto envelope = report::envelopeOf(times, values, {0.0, 3.0}, 3);
  EXPECT_EQ(envelope.time_s, (std::vector{0.5, 1.5, 2.5}));
  EXPECT_EQ(envelope.low, (std::vector{-2.0, 5.0, 7.0}));
  EXPECT_EQ(envelope.high, (std::vector{1.0, 5.0, 7.0}));
  EXPECT_TRUE(std::isnan(report::envelopeOf(times, values, {4.0, 8.0}, 1).low.front()));
}

TEST(ReportLayout, BlocksKeepTheirOrderAndArePushedWhole) {
  const std::vector<report::Block> blocks{
      {40, 10, {}}, {40, 10, {}}, {40, 10, {}}, {200, 0, {}}, {10, 0, {}}};
  const auto pages = report::paginate(blocks, 100.0);
  ASSERT_EQ(pages.size(), 4u);
  EXPECT_EQ(pages[0].size(), 2u);
  EXPECT_EQ(pages[0][1].top, 50.0);
  EXPECT_EQ(pages[1][0].block, &blocks[2]);
  EXPECT_EQ(pages[2][0].block, &blocks[3]);
  EXPECT_EQ(pages[3][0].top, 0.0);
  EXPECT_EQ(report::paginate({}, 100.0).size(), 1u);
}

}  // namespace
}  // namespace mirrorarm::ui
